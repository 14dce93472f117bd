#include "improvement/edge_removal.h"
#include "improvement/vertex_smoothing.h"
#include "unit/improvement/improvement_fixture.h"

#include "base/random.h"
#include "quality/triangle_measures.h"

#include <array>

namespace mesher {
namespace {

/// A refined mesh of an example, ready for changes of its boundary.
struct BoundaryWorkshop
{
    test::SolidExample example;
    ClassifiedMesh mesh;
    TetComplex complex;
    BoundaryGeometry geometry;

    explicit BoundaryWorkshop(std::size_t which)
        : example(std::move(test::solidExamples()[which])),
          mesh(test::refinedMesh(example)),
          complex(mesh),
          geometry(example.model, complex, mesh.nodes, 0.0)
    {
    }

    [[nodiscard]] ClassifiedMesh result() const
    {
        ClassifiedMesh after = mesh;
        complex.writeTo(after);
        return after;
    }
    [[nodiscard]] std::vector<NodeId> nodesOn(std::uint8_t dimension) const
    {
        std::vector<NodeId> nodes;
        for (std::uint32_t i = 0; i < complex.nodeLimit(); ++i) {
            if (complex.node(NodeId(i)).entity.dimension == dimension) nodes.push_back(NodeId(i));
        }
        return nodes;
    }
};

constexpr std::size_t kBox = 0;
constexpr std::size_t kCylinder = 1;
constexpr std::size_t kSphere = 3;
constexpr std::size_t kTorus = 4;

TEST(BoundaryGeometry, PutsNodesOnExactPointsOfTheirOwnEntity)
{
    Random random(7);
    for (const std::size_t which : {kBox, kCylinder, kSphere, kTorus}) {
        BoundaryWorkshop shop(which);
        SCOPED_TRACE(shop.example.name);
        BoundaryMove move;
        for (const std::uint8_t dimension : std::array<std::uint8_t, 2>{1, 2}) {
            for (const NodeId n : shop.nodesOn(dimension)) {
                const Vec3 step = 0.05 * Vec3{random.unit(), random.unit(), random.unit()};
                if (!shop.geometry.evaluateMove(n, shop.complex.position(n) + step, move)) continue;
                const std::uint32_t index = shop.complex.node(n).entity.index;
                const Vec3 exact =
                    dimension == 1
                        ? shop.example.model.edges[BrepEdgeId(index)].curve->position(move.parameters.x)
                        : shop.example.model.faces[BrepFaceId(index)].surface->position(move.parameters);
                EXPECT_LT(length(exact - move.position), 1e-12);
                EXPECT_LT(length(move.position - shop.complex.position(n)), 0.2);
            }
        }
    }
}

TEST(BoundaryGeometry, RefusesAMoveThatFoldsTriangles)
{
    for (const std::size_t which : {kBox, kSphere}) {
        BoundaryWorkshop shop(which);
        SCOPED_TRACE(shop.example.name);
        int moves = 0;
        for (const NodeId n : shop.nodesOn(2)) {
            BoundaryMove move;
            const FacetNodes& v = shop.complex.nodes(shop.complex.facets(n).front());
            for (const NodeId other : v) {
                if (other == n) continue;
                const Vec3 beyond = shop.complex.position(n) +
                                    1.7 * (shop.complex.position(other) - shop.complex.position(n));
                if (!shop.geometry.evaluateMove(n, beyond, move)) continue;
                EXPECT_FALSE(shop.geometry.allows(move));
                ++moves;
            }
        }
        EXPECT_GT(moves, 50);
    }
}

TEST(BoundaryGeometry, LimitsTheSagOfChords)
{
    BoundaryWorkshop shop(kSphere);
    BoundaryGeometry strict(shop.example.model, shop.complex, shop.mesh.nodes, 1e-9);
    int allowed = 0;
    int allowedStrictly = 0;
    for (const NodeId n : shop.nodesOn(2)) {
        const FacetNodes& v = shop.complex.nodes(shop.complex.facets(n).front());
        const NodeId other = v[0] == n ? v[1] : v[0];
        const Vec3 target =
            shop.complex.position(n) + 0.15 * (shop.complex.position(other) - shop.complex.position(n));
        BoundaryMove move;
        if (!shop.geometry.evaluateMove(n, target, move)) continue;
        allowed += shop.geometry.allows(move) ? 1 : 0;
        allowedStrictly += strict.allows(move) ? 1 : 0;
    }
    EXPECT_GT(allowed, 50);
    EXPECT_LT(allowedStrictly, allowed - 50);
}

/// The two triangles of an edge and those on the other diagonal.
struct FacetPair
{
    std::array<FacetId, 2> before;
    std::array<FacetNodes, 2> after;
};

std::vector<FacetPair> pairsWithinFaces(const TetComplex& complex)
{
    std::vector<FacetPair> pairs;
    for (std::uint32_t i = 0; i < complex.facetLimit(); ++i) {
        const FacetNodes& v = complex.nodes(FacetId(i));
        for (std::size_t k = 0; k < 3; ++k) {
            FacetPair pair;
            const NodeId a = v[k];
            const NodeId b = v[(k + 1) % 3];
            if (b < a || complex.facetsAt(a, b, pair.before) != 2) continue;
            if (complex.face(pair.before[0]) != complex.face(pair.before[1])) continue;
            const auto apex = [&](FacetId f) {
                for (const NodeId n : complex.nodes(f)) {
                    if (n != a && n != b) return n;
                }
                return NodeId();
            };
            pair.after = {complex.nodes(pair.before[0]), complex.nodes(pair.before[1])};
            std::replace(pair.after[0].begin(), pair.after[0].end(), b, apex(pair.before[1]));
            std::replace(pair.after[1].begin(), pair.after[1].end(), a, apex(pair.before[0]));
            pairs.push_back(pair);
        }
    }
    return pairs;
}

TEST(BoundaryGeometry, RefusesSwapsInAPlaneThatFoldOrMakeSmallAngles)
{
    BoundaryWorkshop shop(kBox);
    const auto cornersOf = [&](const FacetNodes& v) {
        return TriangleCorners{shop.complex.position(v[0]), shop.complex.position(v[1]),
                               shop.complex.position(v[2])};
    };
    int allowed = 0;
    int refused = 0;
    for (const FacetPair& pair : pairsWithinFaces(shop.complex)) {
        double before = 180.0;
        double after = 180.0;
        bool isFolded = false;
        const Vec3 normal = doubleAreaVector(cornersOf(shop.complex.nodes(pair.before[0])));
        for (std::size_t i = 0; i < 2; ++i) {
            before = std::min(before, shapeOf(cornersOf(shop.complex.nodes(pair.before[i]))).minAngle);
            after = std::min(after, shapeOf(cornersOf(pair.after[i])).minAngle);
            isFolded = isFolded || dot(doubleAreaVector(cornersOf(pair.after[i])), normal) <= 0.0;
        }
        const bool isGood = !isFolded && after >= std::min(before, BoundaryGeometry::kLeastFacetAngle);
        EXPECT_EQ(shop.geometry.allowsSwap(pair.before, pair.after), isGood);
        ++(isGood ? allowed : refused);
    }
    EXPECT_GT(allowed, 50);
    EXPECT_GT(refused, 20);
}

TEST(BoundaryGeometry, AllowsFewerSwapsOnACurvedFaceTheLessTheyMayLeaveIt)
{
    BoundaryWorkshop shop(kTorus);
    BoundaryGeometry strict(shop.example.model, shop.complex, shop.mesh.nodes, 1e-9);
    int allowed = 0;
    int allowedStrictly = 0;
    for (const FacetPair& pair : pairsWithinFaces(shop.complex)) {
        allowed += shop.geometry.allowsSwap(pair.before, pair.after) ? 1 : 0;
        allowedStrictly += strict.allowsSwap(pair.before, pair.after) ? 1 : 0;
        LocalChange change;
        const auto& v = shop.complex.nodes(pair.before[0]);
        for (std::size_t k = 0; k < 3; ++k) {
            if (!evaluateEdgeRemoval(shop.complex, strict, v[k], v[(k + 1) % 3], {}, change)) continue;
            EXPECT_TRUE(strict.allowsSwap(change.facets, change.facetNodes));
        }
    }
    EXPECT_LT(allowedStrictly, allowed - 20);
}

TEST(VertexSmoothing, KeepsNodesOfTheBoundaryThere)
{
    for (const std::size_t which : {kBox, kCylinder, kTorus}) {
        BoundaryWorkshop shop(which);
        SCOPED_TRACE(shop.example.name);
        VertexSmoothing smoothing(shop.complex, shop.geometry, BoundaryChanges::Allowed);
        VertexSmoothing frozen(shop.complex, shop.geometry, BoundaryChanges::None);
        int moves = 0;
        for (const std::uint8_t dimension : std::array<std::uint8_t, 3>{0, 1, 2}) {
            for (const NodeId n : shop.nodesOn(dimension)) {
                EXPECT_FALSE(frozen.evaluate(n, 0.8));
                if (!smoothing.evaluate(n, 0.8)) continue;
                ASSERT_GT(dimension, 0);
                shop.geometry.commit(smoothing.move());
                shop.complex.move(n, smoothing.move().position, smoothing.move().parameters);
                ++moves;
            }
        }
        EXPECT_GT(moves, 30);
        EXPECT_TRUE(test::isImprovementOf(shop.result(), shop.mesh, shop.example.model));
    }
}

TEST(EdgeRemoval, SwapsEdgesOfTheBoundaryWithinTheirFace)
{
    for (const std::size_t which : {kBox, kCylinder, kSphere, kTorus}) {
        BoundaryWorkshop shop(which);
        SCOPED_TRACE(shop.example.name);
        int swaps = 0;
        for (std::uint32_t i = 0; i < shop.complex.facetLimit(); ++i) {
            const FacetNodes v = shop.complex.nodes(FacetId(i));
            for (std::size_t k = 0; k < 3; ++k) {
                LocalChange change;
                const NodeId a = v[k];
                const NodeId b = v[(k + 1) % 3];
                EXPECT_FALSE(evaluateEdgeRemoval(shop.complex, shop.geometry, a, b,
                                                 {BoundaryChanges::None, 0.0}, change));
                if (!evaluateEdgeRemoval(shop.complex, shop.geometry, a, b, {}, change)) continue;
                ASSERT_TRUE(change.swapsFacets);
                ASSERT_FALSE(shop.complex.isLine(a, b));
                apply(change, shop.complex, shop.geometry);
                EXPECT_FALSE(shop.complex.isOnSurface(a, b));
                ++swaps;
                break;
            }
        }
        EXPECT_GT(swaps, 5);
        EXPECT_TRUE(test::isImprovementOf(shop.result(), shop.mesh, shop.example.model));
    }
}

}  // namespace
}  // namespace mesher
