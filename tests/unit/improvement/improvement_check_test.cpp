#include "unit/improvement/improvement_fixture.h"

namespace mesher {
namespace {

using test::isImprovementOf;

/// A mesh, and one that is spoilt in one way.
class ImprovementCheck : public testing::Test
{
protected:
    ImprovementCheck()
        : example_{"cylinder", makeCylinder(Axes{}, 1.0, 2.0).value(), 0.4},
          before_(test::refinedMesh(example_)),
          after_(before_)
    {
    }

    /// The first node on an entity of that dimension.
    MeshNode& nodeOn(std::uint8_t dimension)
    {
        return *std::find_if(after_.nodes.begin(), after_.nodes.end(),
                             [&](const MeshNode& n) { return n.entity.dimension == dimension; });
    }
    void expectProblem(const std::string& words)
    {
        const CheckReport report = checkImprovement(before_, after_, example_.model);
        EXPECT_FALSE(report.isValid());
        EXPECT_NE(report.problem.find(words), std::string::npos) << report.problem;
    }

    /// To one side or the other a small move of a node makes no tetrahedron worse.
    void expectProblemOfMove(MeshNode& node, const Vec3& step, const std::string& words)
    {
        const Vec3 place = node.position;
        node.position = place + step;
        const std::string there = checkImprovement(before_, after_, example_.model).problem;
        node.position = place - step;
        const std::string back = checkImprovement(before_, after_, example_.model).problem;
        EXPECT_TRUE(there.find(words) != std::string::npos || back.find(words) != std::string::npos)
            << there << ", " << back;
    }

    test::SolidExample example_;
    ClassifiedMesh before_;
    ClassifiedMesh after_;
};

TEST_F(ImprovementCheck, FindsNothingInAMeshThatIsTheSame)
{
    EXPECT_TRUE(isImprovementOf(after_, before_, example_.model));
}

TEST_F(ImprovementCheck, FindsAWorseTetrahedron)
{
    MeshNode& node = nodeOn(3);
    node.position = node.position + Vec3{0.06, 0.05, 0.04};
    expectProblem("of the worst has fallen");
}

TEST_F(ImprovementCheck, FindsAnInvertedTetrahedron)
{
    std::swap(after_.tets[5].node[0], after_.tets[5].node[1]);
    expectProblem("inverted");
}

TEST_F(ImprovementCheck, FindsANodeThatLeftItsSurface)
{
    expectProblemOfMove(nodeOn(2), {1e-6, 1e-6, 1e-6}, "off its surface");
}

TEST_F(ImprovementCheck, FindsANodeThatLeftItsCurve)
{
    expectProblemOfMove(nodeOn(1), {0, 0, 1e-6}, "off its curve");
}

TEST_F(ImprovementCheck, FindsAVertexThatMoved)
{
    expectProblemOfMove(nodeOn(0), {0, 0, 1e-12}, "has moved");
}

TEST_F(ImprovementCheck, FindsANodeOfAnotherEntity)
{
    nodeOn(2).entity.index ^= 1u;
    EXPECT_FALSE(isImprovementOf(after_, before_, example_.model));
}

TEST_F(ImprovementCheck, FindsALineOfAnotherEdge)
{
    before_.lines.pop_back();
    expectProblem("lines or points");
}

TEST_F(ImprovementCheck, FindsATriangleThatIsGone)
{
    after_.triangles.pop_back();
    EXPECT_FALSE(isImprovementOf(after_, before_, example_.model));
}

}  // namespace
}  // namespace mesher
