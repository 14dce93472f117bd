#pragma once

#include "brep/analytic/axes.h"
#include "brep/analytic/solids.h"
#include "improvement/dihedral_score.h"
#include "improvement/improve_mesh.h"
#include "improvement/improvement_check.h"
#include "pipeline/mesh_solids.h"
#include "quality/quality_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace mesher::test {

struct SolidExample
{
    std::string name;
    BrepModel model;
    double size = 0.0;
};

inline std::vector<SolidExample> solidExamples()
{
    std::vector<SolidExample> examples;
    examples.push_back({"box", makeBox({0, 0, 0}, {3, 2, 1}).value(), 0.3});
    examples.push_back({"cylinder", makeCylinder(Axes{}, 1.0, 2.5).value(), 0.35});
    examples.push_back({"frustum", makeCone(Axes{}, 1.5, 0.5, 2.0).value(), 0.35});
    examples.push_back({"sphere", makeSphere(Axes{}, 1.0).value(), 0.25});
    examples.push_back({"torus", makeTorus(Axes{}, 2.0, 0.7).value(), 0.3});
    return examples;
}

/// As the refinement leaves it.
inline ClassifiedMesh refinedMesh(const SolidExample& example)
{
    MeshOptions options;
    options.size = example.size;
    options.isImproved = false;
    RunContext context;
    MeshOutcome outcome = meshSolids(example.model, options, nullptr, context);
    EXPECT_TRUE(outcome.mesh) << example.name;
    return outcome.mesh ? std::move(*outcome.mesh) : ClassifiedMesh{};
}

inline Improvement improved(ClassifiedMesh& mesh, const BrepModel& model, const ImprovementOptions& options = {})
{
    RunContext context;
    const Result<Improvement> result = improveMesh(mesh, model, options, context);
    EXPECT_TRUE(result);
    return result ? result.value() : Improvement{};
}

inline testing::AssertionResult isImprovementOf(const ClassifiedMesh& after, const ClassifiedMesh& before,
                                                const BrepModel& model)
{
    const CheckReport report = checkImprovement(before, after, model);
    if (report.isValid()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << report.violations << " violations, first: " << report.problem;
}

}  // namespace mesher::test
