#include "unit/improvement/improvement_fixture.h"

#include "mesh/classified_mesh_hash.h"

namespace mesher {
namespace {

using test::improved;
using test::isImprovementOf;
using test::refinedMesh;
using test::SolidExample;

TEST(ImproveMesh, MakesNothingWorseAndKeepsTheBoundary)
{
    for (const SolidExample& example : test::solidExamples()) {
        SCOPED_TRACE(example.name);
        const ClassifiedMesh before = refinedMesh(example);
        ClassifiedMesh after = before;
        const Improvement result = improved(after, example.model);
        EXPECT_TRUE(isImprovementOf(after, before, example.model));
        EXPECT_LT(result.counts.badAfter, result.counts.badBefore / 20);
        EXPECT_GT(tetQualityOf(after).dihedral.least(), 24.0);
        EXPECT_LT(tetQualityOf(after).dihedral.largest(), 146.0);
    }
}

}  // namespace
}  // namespace mesher
