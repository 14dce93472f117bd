#pragma once

#include "brep/brep_model.h"
#include "surface_sampling/curve_chains.h"
#include "surface_sampling/initial_face_mesh.h"
#include "surface_sampling/surface_check.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace mesher::test {

inline Result<CurveChains> sampledChains(const BrepModel& model, const CurveChainOptions& options,
                                         IdVector<NodeId, MeshNode>& nodes)
{
    RunContext context;
    return sampleCurveChains(model, options, nodes, context);
}

/// A model with its coarse surface mesh.
struct SampledModel
{
    BrepModel model;
    IdVector<NodeId, MeshNode> nodes;
    CurveChains chains;
    InitialSurfaceMesh initial;
    SurfaceMesh mesh;
};

/// The chains keep a pointer to the model, so the result stays where it is made.
inline void sampleInto(SampledModel& sampled, BrepModel model, const CurveChainOptions& chainOptions = {},
                       const InitialFaceMeshOptions& options = {})
{
    sampled.model = std::move(model);
    RunContext context;
    auto chains = sampleCurveChains(sampled.model, chainOptions, sampled.nodes, context);
    ASSERT_TRUE(chains) << describe(chains.error());
    sampled.chains = std::move(*chains);
    sampled.initial = initialSurfaceMesh(sampled.model, sampled.chains, sampled.nodes, options, context);
    for (const auto& [face, error] : sampled.initial.failures) ADD_FAILURE() << describe(error);
    sampled.mesh = assembleSurfaceMesh(sampled.chains, sampled.nodes, sampled.initial);
}

}  // namespace mesher::test
