#include "surface_sampling/face_mesh.h"

#include "brep/analytic/plane_surface.h"
#include "brep/analytic/round_surfaces.h"
#include "support/face_examples.h"
#include "surface_sampling/face_flips.h"
#include "surface_sampling/face_mesh_check.h"
#include "surface_sampling/face_replacement.h"
#include "surface_sampling/face_star.h"
#include "surface_sampling/face_walk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace mesher::test {
namespace {

constexpr double kPi = std::numbers::pi;

FaceExample square(std::size_t cells)
{
    return gridFace(std::make_shared<PlaneSurface>(PlaneFrame{}), {0.0, 1.0}, {0.0, 1.0}, cells, cells);
}

FaceExample tube()
{
    return gridFace(std::make_shared<CylinderSurface>(Axes{}, 1.0), {0.0, 2.0 * kPi}, {0.0, 2.0}, 8, 4,
                    {true, false});
}

TEST(FaceMesh, LinksFacetsAcrossASeamAndTellsTheBorder)
{
    const FaceExample example = tube();
    const FaceGeometry geometry(example.face);
    const Result<FaceMesh> mesh = example.mesh(geometry);
    ASSERT_TRUE(mesh.hasValue());
    const FaceMeshCheck check = checkFaceMesh(*mesh, geometry);
    EXPECT_EQ(check.report.problem, "");
    EXPECT_EQ(check.eulerCharacteristic(), 0) << "a tube";
    EXPECT_EQ(check.components, 1u);
    EXPECT_LT(check.largestDistance, 1e-12);
}

TEST(FaceMesh, GivesEachFanAVertexWhereTheFaceTouchesItself)
{
    // Two cells of four, that have nothing but the node in the middle in common.
    FaceExample example = square(2);
    const std::vector<SurfaceFacet> all = example.facets;
    example.facets = {all[0], all[1], all[6], all[7]};
    std::uint32_t next = 100;
    for (const SurfaceFacet& facet : example.facets) {
        for (std::size_t i = 0; i < 3; ++i) {
            const NodeId a = facet.node[i], b = facet.node[(i + 1) % 3];
            example.nodes[a].entity.dimension = 1;
            const bool isDiagonal = facet.parameters[i].x != facet.parameters[(i + 1) % 3].x &&
                                    facet.parameters[i].y != facet.parameters[(i + 1) % 3].y;
            if (!isDiagonal) example.segments.insert(std::minmax(a, b), SegmentId(next++));
        }
    }
    const FaceGeometry geometry(example.face);
    const Result<FaceMesh> mesh = example.mesh(geometry);
    ASSERT_TRUE(mesh.hasValue());
    EXPECT_EQ(mesh->vertexCount(), 8u) << "seven nodes, one of them twice";
    const FaceMeshCheck check = checkFaceMesh(*mesh, geometry);
    EXPECT_EQ(check.report.problem, "");
    EXPECT_EQ(check.components, 2u);
}

TEST(FaceMesh, RefusesTwoFacetsThatUseASideTheSameWay)
{
    FaceExample example = square(2);
    example.facets.push_back(example.facets.front());
    const Result<FaceMesh> mesh = example.mesh(FaceGeometry(example.face));
    ASSERT_FALSE(mesh.hasValue());
    EXPECT_EQ(mesh.error().entity, "Face1");
}

TEST(FaceMesh, RefusesABorderThatIsNoSegment)
{
    FaceExample example = square(2);
    example.facets.pop_back();
    const Result<FaceMesh> mesh = example.mesh(FaceGeometry(example.face));
    ASSERT_FALSE(mesh.hasValue());
    EXPECT_TRUE(mesh.error().point.has_value());
}

TEST(FaceMeshCheck, SeesABrokenLinkAndAMissingSegment)
{
    const FaceExample example = square(2);
    const FaceGeometry geometry(example.face);
    Result<FaceMesh> mesh = example.mesh(geometry);
    ASSERT_TRUE(mesh.hasValue());
    FaceMesh broken = *mesh;
    for (unsigned i = 0; i < 3; ++i) {
        if (broken.across(EdgeLink(TriangleId(0), i)).isValid())
            broken.triangle(TriangleId(0)).n[i] = EdgeLink();
    }
    EXPECT_FALSE(checkFaceMesh(broken, geometry).report.isValid());
    broken = *mesh;
    broken.triangle(TriangleId(0)).s = {};
    EXPECT_FALSE(checkFaceMesh(broken, geometry).report.isValid());
    broken = *mesh;
    std::swap(broken.triangle(TriangleId(3)).v[0], broken.triangle(TriangleId(3)).v[1]);
    EXPECT_FALSE(checkFaceMesh(broken, geometry).report.isValid());
}

TEST(FaceWalk, FindsTheTriangleAndTheShiftAcrossASeam)
{
    const FaceExample example = tube();
    const FaceGeometry geometry(example.face);
    Result<FaceMesh> mesh = example.mesh(geometry);
    ASSERT_TRUE(mesh.hasValue());
    // The last column of facets has u around 5.5 to 6.28; the point is just behind the seam.
    const TriangleId start(static_cast<std::uint32_t>(mesh->triangleSlots() - 4));
    const Vec2 uv{2.0 * kPi + 0.3, 1.3};
    const FaceWalk walk = walkToPoint(*mesh, geometry, start, geometry.surface().position(uv));
    ASSERT_EQ(walk.outcome, FaceWalk::Outcome::Inside);
    EXPECT_NEAR(walk.shift.x, 2.0 * kPi, 1e-12);
    const FaceTriangle& found = mesh->triangle(walk.triangle);
    for (const Vec2 corner : found.uv) EXPECT_LT(std::abs(corner.x - 0.3), 1.0);
}

TEST(FaceWalk, IsBlockedByTheBorder)
{
    const FaceExample example = tube();
    const FaceGeometry geometry(example.face);
    Result<FaceMesh> mesh = example.mesh(geometry);
    ASSERT_TRUE(mesh.hasValue());
    const FaceWalk walk =
        walkToPoint(*mesh, geometry, TriangleId(4), geometry.surface().position({0.4, -1.0}));
    ASSERT_EQ(walk.outcome, FaceWalk::Outcome::Blocked);
    EXPECT_TRUE(mesh->segment(walk.side).isValid());
}

TEST(FaceFlips, MakeAGridWithBadDiagonalsDelaunay)
{
    const FaceExample example =
        gridFace(std::make_shared<PlaneSurface>(PlaneFrame{{}, {1, 0, 0}, {0.6, 0.8, 0}}), {0.0, 1.0},
                 {0.0, 1.0}, 6, 6);
    const FaceGeometry geometry(example.face);
    Result<FaceMesh> mesh = example.mesh(geometry);
    ASSERT_TRUE(mesh.hasValue());
    ASSERT_GT(checkFaceMesh(*mesh, geometry).nonDelaunayEdges, 0u) << "nothing to do";
    RunContext context;
    Budget budget({}, context);
    const FaceFlips flips = makeSurfaceDelaunay(*mesh, geometry, budget);
    EXPECT_EQ(flips.flips, 36u);
    EXPECT_EQ(flips.stopReason, StopReason::Done);
    const FaceMeshCheck check = checkFaceMesh(*mesh, geometry);
    EXPECT_EQ(check.report.problem, "");
    EXPECT_EQ(check.nonDelaunayEdges, 0u);
    EXPECT_LT(check.largestDistance, 1e-12);
    EXPECT_NEAR(areaOf(*mesh), 0.8, 1e-12);
}

TEST(FaceFlips, KeepParametersTogetherAcrossASeam)
{
    // Around it so fine that the other diagonals of the quadrilaterals at the seam do not fold.
    const FaceExample example = gridFace(std::make_shared<CylinderSurface>(Axes{}, 1.0), {0.0, 2.0 * kPi},
                                         {0.0, 2.0}, 24, 4, {true, false});
    const FaceGeometry geometry(example.face);
    Result<FaceMesh> mesh = example.mesh(geometry);
    ASSERT_TRUE(mesh.hasValue());
    std::size_t flips = 0, flipsOfSeam = 0;
    for (std::uint32_t i = 0; i < mesh->triangleSlots(); ++i) {
        for (unsigned k = 0; k < 3; ++k) {
            const EdgeLink side(TriangleId(i), k);
            if (obstacleToFlip(*mesh, geometry, side) != FlipObstacle::None) continue;
            flipsOfSeam += std::abs(mesh->shiftAcross(geometry, side).x) > 1.0 ? 1 : 0;
            flip(*mesh, geometry, side);
            ++flips;
            ASSERT_EQ(checkFaceMesh(*mesh, geometry).report.problem, "");
        }
    }
    EXPECT_GT(flips, 10u);
    EXPECT_GT(flipsOfSeam, 0u);
    const FaceMeshCheck check = checkFaceMesh(*mesh, geometry);
    EXPECT_EQ(check.report.problem, "");
    EXPECT_LT(check.largestDistance, 1e-12);
}

TEST(FaceFlips, RefuseAnEdgeThatIsThereAlreadyAndOneThatFolds)
{
    const FaceExample example = octahedronOnSphere(1.0);
    const FaceGeometry geometry(example.face);
    Result<FaceMesh> mesh = example.mesh(geometry);
    ASSERT_TRUE(mesh.hasValue());
    const VertexId south = mesh->triangle(TriangleId(1)).v[2], north = mesh->triangle(TriangleId(0)).v[2];
    const EdgeLink side =
        mesh->findSide(mesh->triangle(TriangleId(0)).v[0], mesh->triangle(TriangleId(0)).v[1]);
    ASSERT_EQ(mesh->apex(side), north);
    ASSERT_EQ(mesh->apex(mesh->across(side)), south);
    EXPECT_EQ(obstacleToFlip(*mesh, geometry, side), FlipObstacle::Folds) << "an edge through the centre";
}

TEST(FaceFlips, NeverJoinThreeNodesOfAStraightBorder)
{
    // The normal of such a facet is rounding, which agrees with the surface half of the time.
    int tried = 0;
    for (int i = 0; i < 50; ++i) {
        const double angle = 0.1 + 0.05 * i;
        const Vec3 z{0.0, std::sin(angle), std::cos(angle)}, y{0.0, std::cos(angle), -std::sin(angle)};
        const FaceExample example =
            gridFace(std::make_shared<CylinderSurface>(Axes{{0.3, 0.7, 0.9}, {1.0, 0.0, 0.0}, y, z}, 1.0),
                     {0.3, 0.9}, {0.0, 1.7}, 1, 2);
        const FaceGeometry geometry(example.face);
        Result<FaceMesh> mesh = example.mesh(geometry);
        ASSERT_TRUE(mesh.hasValue());
        // Nodes by column and row.
        const auto vertexAt = [&](std::uint32_t node) {
            for (std::uint32_t v = 0; v < mesh->vertexSlots(); ++v) {
                if (mesh->vertex(VertexId(v)).node == NodeId(node)) return VertexId(v);
            }
            return VertexId();
        };
        EdgeLink diagonal = mesh->findSide(vertexAt(1), vertexAt(5));
        if (!diagonal.isValid()) diagonal = mesh->findSide(vertexAt(5), vertexAt(1));
        ASSERT_TRUE(diagonal.isValid());
        ASSERT_EQ(obstacleToFlip(*mesh, geometry, diagonal), FlipObstacle::None);
        flip(*mesh, geometry, diagonal);
        const EdgeLink side = mesh->findSide(vertexAt(1), vertexAt(4));
        ASSERT_TRUE(side.isValid());
        EXPECT_EQ(obstacleToFlip(*mesh, geometry, side), FlipObstacle::Folds) << angle;
        ++tried;
    }
    EXPECT_EQ(tried, 50);
}

TEST(FaceStar, SplitsASegmentOfTheBorderIntoItsHalves)
{
    const FaceExample example = square(2);
    const FaceGeometry geometry(example.face);
    Result<FaceMesh> mesh = example.mesh(geometry);
    ASSERT_TRUE(mesh.hasValue());
    EdgeLink side;
    for (std::uint32_t i = 0; i < mesh->triangleSlots() && !side.isValid(); ++i) {
        for (unsigned k = 0; k < 3; ++k) {
            if (mesh->segment(EdgeLink(TriangleId(i), k)).isValid()) side = EdgeLink(TriangleId(i), k);
        }
    }
    const VertexId a = mesh->from(side), b = mesh->to(side);
    const Vec3 middle = 0.5 * (mesh->position(a) + mesh->position(b));
    FaceStar star(*mesh, geometry);
    FaceVertex vertex = FaceVertex::of(geometry.projected(middle, {}));
    const FaceMesh before = *mesh;
    star.evaluateOnSide(side, vertex, {middle.x, middle.y}, StarExtent::Delaunay,
                        {SegmentId(100), SegmentId(101)});
    EXPECT_EQ(before.triangleCount(), mesh->triangleCount()) << "evaluation must not change the mesh";
    EXPECT_FALSE(star.isFolded());
    EXPECT_FALSE(star.isClosed());
    const VertexId v = star.commit();
    EXPECT_EQ(mesh->segment(mesh->findSide(a, v)), SegmentId(100));
    EXPECT_EQ(mesh->segment(mesh->findSide(v, b)), SegmentId(101));
    const FaceMeshCheck check = checkFaceMesh(*mesh, geometry);
    EXPECT_EQ(check.report.problem, "");
    EXPECT_NEAR(areaOf(*mesh), 1.0, 1e-12);
}

TEST(FaceVertexRemoval, UndoesInsertionsUpToTheTriangulation)
{
    const FaceExample example = tube();
    const FaceGeometry geometry(example.face);
    Result<FaceMesh> mesh = example.mesh(geometry);
    ASSERT_TRUE(mesh.hasValue());
    RunContext context;
    Budget budget({}, context);
    makeSurfaceDelaunay(*mesh, geometry, budget);
    FaceVertexRemoval removal(*mesh, geometry);
    std::size_t removed = 0;
    for (std::uint32_t i = 0; i < mesh->vertexSlots(); i += 2) {
        if (!removal.evaluate(VertexId(i))) continue;
        removal.commit();
        ++removed;
        const FaceMeshCheck check = checkFaceMesh(*mesh, geometry);
        ASSERT_EQ(check.report.problem, "");
        EXPECT_EQ(check.eulerCharacteristic(), 0);
        EXPECT_LT(check.largestDistance, 1e-12);
        EXPECT_GE(check.leastNormalAgreement, 0.5);
    }
    EXPECT_GT(removed, 3u);
    EXPECT_FALSE(removal.evaluate(mesh->triangle(TriangleId(0)).v[0]) &&
                 !mesh->vertex(mesh->triangle(TriangleId(0)).v[0]).isFree);
}

}  // namespace
}  // namespace mesher::test
