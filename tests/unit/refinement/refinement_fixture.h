#pragma once

#include "delaunay/constrained_check.h"
#include "quality/tet_measures.h"
#include "refinement/refine_volume.h"
#include "refinement/refinement_check.h"
#include "support/sampled_solids.h"
#include "support/triangulations3d.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace mesher::test {

inline testing::AssertionResult isSound(const SampledSolid& solid)
{
    const CheckReport report = checkRefinement(solid.tetrahedralization, solid.splitter->mesh());
    if (report.isValid()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << report.violations << " violations, first: " << report.problem;
}

inline std::vector<TetId> meshedTets(const SampledSolid& solid)
{
    const Triangulation3d& mesh = solid.tetrahedralization.mesh();
    std::vector<TetId> tets = finiteTets(mesh);
    std::erase_if(tets, [&](TetId tet) { return mesh.region(tet) == kExteriorRegion; });
    return tets;
}

struct DihedralRange
{
    double least = 180.0;
    double most = 0.0;
};

inline std::array<Vec3, 4> cornersOf(const SampledSolid& solid, TetId tet)
{
    const Triangulation3d& mesh = solid.tetrahedralization.mesh();
    const auto& v = mesh.tet(tet).vertex;
    return {mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]), mesh.position(v[3])};
}

inline DihedralRange dihedralRange(const SampledSolid& solid)
{
    DihedralRange range;
    for (const TetId tet : meshedTets(solid)) {
        for (const double angle : dihedralAngles(cornersOf(solid, tet))) {
            range.least = std::min(range.least, angle);
            range.most = std::max(range.most, angle);
        }
    }
    return range;
}

/// In model units.
inline double meshedVolume(const SampledSolid& solid)
{
    double volume = 0.0;
    for (const TetId tet : meshedTets(solid)) volume += sixfoldVolume(cornersOf(solid, tet)) / 6.0;
    const double scale = solid.tetrahedralization.scale;
    return volume / (scale * scale * scale);
}

inline RefinedVolume refine(SampledSolid& solid, const RefineVolumeOptions& options = {})
{
    RunContext context;
    Result<RefinedVolume> result = refineVolume(solid.tetrahedralization, *solid.splitter, options, context);
    EXPECT_TRUE(result.hasValue()) << (result.hasValue() ? std::string() : describe(result.error()));
    return result.hasValue() ? std::move(result).value() : RefinedVolume{};
}

}  // namespace mesher::test
