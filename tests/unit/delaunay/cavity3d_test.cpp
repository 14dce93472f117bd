#include "delaunay/cavity3d.h"

#include "predicates/insphere.h"
#include "predicates/orient3d.h"
#include "support/test_effort.h"
#include "support/triangulations3d.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace mesher::test {
namespace {

VertexId vertexAt(const Triangulation3d& mesh, const Vec3& place)
{
    for (const VertexId v : liveVertices(mesh)) {
        if (mesh.position(v) == place) return v;
    }
    return {};
}

bool isEdgeConstrained(const Triangulation3d& mesh, VertexId a, VertexId b)
{
    const TetId tet = mesh.findEdge(a, b);
    return tet.isValid() &&
           mesh.isEdgeConstrained(tet, kEdgeOfSlots[mesh.slotOf(tet, a)][mesh.slotOf(tet, b)]);
}

bool isFaceConstrained(const Triangulation3d& mesh, VertexId a, VertexId b, VertexId c)
{
    const TetFace face = mesh.findFace(a, b, c);
    return face.isValid() && mesh.isFaceConstrained(face);
}

int constrainedFaceCount(const Triangulation3d& mesh)
{
    int count = 0;
    for (const TetId t : liveTets(mesh)) {
        for (int i = 0; i < 4; ++i) count += mesh.isFaceConstrained({t, i}) ? 1 : 0;
    }
    return count / 2;
}

/// The four points of a flat horizontal square and two far above and below: (a, b, c) and (a, c, d) are faces.
class Square : public testing::Test
{
protected:
    const Vec3 place_[6] = {{-2, -2, 0}, {2, -2, 0},        {2, 2, 0},
                            {-2, 2, 0},  {0.25, 0.5, 3.25}, {-0.5, 0.125, -3.5}};

    Square()
    {
        insertEach(delaunay_, place_);
        for (int i = 0; i < 6; ++i) v_[i] = vertexAt(mesh(), place_[i]);
        diagonal_ = mesh().findEdge(v_[0], v_[2]).isValid() ? 0 : 1;
        end_[0] = v_[diagonal_];
        end_[1] = v_[diagonal_ + 2];
        apex_[0] = v_[diagonal_ + 1];
        apex_[1] = v_[(diagonal_ + 3) % 4];
    }
    Triangulation3d& mesh() { return delaunay_.triangulation(); }
    void constrainFace(int i)
    {
        mesh().setFaceConstrained(mesh().findFace(end_[0], end_[1], apex_[i]), true);
    }
    void constrainEdge(VertexId a, VertexId b)
    {
        mesh().setEdgeConstrained(mesh().findEdge(a, b), a, b, true);
    }
    [[nodiscard]] Vec3 centreOf(int i)
    {
        return 0.25 * (mesh().position(end_[0]) + mesh().position(end_[1]) + 2.0 * mesh().position(apex_[i]));
    }

    Delaunay3d delaunay_;
    VertexId v_[6];
    int diagonal_ = 0;
    VertexId end_[2];   ///< of the diagonal
    VertexId apex_[2];  ///< the third corners of the two triangles
};

TEST_F(Square, HasBothTriangles)
{
    for (int i = 0; i < 2; ++i) ASSERT_TRUE(mesh().findFace(end_[0], end_[1], apex_[i]).isValid());
}

TEST_F(Square, SplitsAConstrainedFaceIntoThree)
{
    constrainFace(0);
    const Vec3 point = centreOf(0);
    const Result<Insertion3d> refused = delaunay_.insert(point);
    EXPECT_EQ(refused->status, InsertionStatus::OnConstraint);
    EXPECT_EQ(refused->location.kind, Location3d::Kind::Face);
    const Result<Insertion3d> split = delaunay_.insert(point, {}, ConstraintPolicy::Split);
    ASSERT_EQ(split->status, InsertionStatus::Inserted);
    EXPECT_TRUE(isSoundTopology(mesh()));
    EXPECT_EQ(constrainedFaceCount(mesh()), 3);
    const VertexId corner[3] = {end_[0], end_[1], apex_[0]};
    for (int k = 0; k < 3; ++k) {
        EXPECT_TRUE(isFaceConstrained(mesh(), corner[k], corner[(k + 1) % 3], split->vertex));
        EXPECT_FALSE(isEdgeConstrained(mesh(), corner[k], split->vertex));
    }
}

TEST_F(Square, SplitsAnEdgeAndTheFacesAtIt)
{
    constrainFace(0);
    constrainFace(1);
    constrainEdge(end_[0], end_[1]);
    const Vec3 point = 0.25 * mesh().position(end_[0]) + 0.75 * mesh().position(end_[1]);
    EXPECT_EQ(delaunay_.insert(point)->status, InsertionStatus::OnConstraint);
    const Result<Insertion3d> split = delaunay_.insert(point, {}, ConstraintPolicy::Split);
    ASSERT_EQ(split->status, InsertionStatus::Inserted);
    EXPECT_TRUE(isSoundTopology(mesh()));
    EXPECT_EQ(constrainedFaceCount(mesh()), 4);
    EXPECT_FALSE(mesh().findEdge(end_[0], end_[1]).isValid());
    for (const VertexId end : end_) {
        EXPECT_TRUE(isEdgeConstrained(mesh(), end, split->vertex));
        for (const VertexId apex : apex_) EXPECT_TRUE(isFaceConstrained(mesh(), end, apex, split->vertex));
    }
    for (const VertexId apex : apex_) EXPECT_FALSE(isEdgeConstrained(mesh(), apex, split->vertex));
}

TEST_F(Square, SplitsTheFacesAtAnEdgeThatIsNotConstrainedItself)
{
    constrainFace(1);
    const Vec3 point = 0.5 * (mesh().position(end_[0]) + mesh().position(end_[1]));
    EXPECT_EQ(delaunay_.insert(point)->status, InsertionStatus::OnConstraint);
    const Result<Insertion3d> split = delaunay_.insert(point, {}, ConstraintPolicy::Split);
    ASSERT_EQ(split->status, InsertionStatus::Inserted);
    EXPECT_TRUE(isSoundTopology(mesh()));
    EXPECT_EQ(constrainedFaceCount(mesh()), 2);
    for (const VertexId end : end_) {
        EXPECT_TRUE(isFaceConstrained(mesh(), end, apex_[1], split->vertex));
        EXPECT_FALSE(isEdgeConstrained(mesh(), end, split->vertex));
    }
}

TEST_F(Square, KeepsAConstrainedFaceThatTheCavityWouldSwallow)
{
    constrainFace(0);
    constrainFace(1);
    const Vec3 point{0.25, 0.25, 0.015625};  // close above the square: in the spheres of both sides
    const Cavity3d& cavity = delaunay_.findCavity(point, *delaunay_.locate(point), ConstraintPolicy::Refuse);
    ASSERT_EQ(cavity.status, CavityStatus::Ready);
    // The diagonal's two faces are on its surface, seen from below.
    std::set<VertexId> seen;
    EXPECT_EQ(cavity.constrainedFaces.size(), 2u);
    for (const TetFace face : cavity.constrainedFaces) {
        EXPECT_TRUE(mesh().isFaceConstrained(face));
        for (const VertexId v : mesh().faceVertices(face)) seen.insert(v);
    }
    EXPECT_EQ(seen.size(), 4u);
    EXPECT_EQ(delaunay_.commit().status, InsertionStatus::Inserted);
    EXPECT_TRUE(isSoundTopology(mesh()));
    for (const VertexId apex : apex_) EXPECT_TRUE(isFaceConstrained(mesh(), end_[0], end_[1], apex));
}

TEST_F(Square, KeepsADanglingConstrainedEdgeByARepair)
{
    constrainEdge(end_[0], end_[1]);
    const Vec3 point{0.25, 0.25, 0.015625};
    const Cavity3d& cavity = delaunay_.findCavity(point, *delaunay_.locate(point), ConstraintPolicy::Refuse);
    ASSERT_EQ(cavity.status, CavityStatus::Ready);
    EXPECT_GT(cavity.repairs, 0u);
    const std::uint32_t repairs = cavity.repairs;
    EXPECT_EQ(delaunay_.commit().status, InsertionStatus::Inserted);
    EXPECT_EQ(delaunay_.counters().cavityRepairs, repairs);
    EXPECT_TRUE(isEdgeConstrained(mesh(), end_[0], end_[1]));
    EXPECT_TRUE(isSoundTopology(mesh()));
}

TEST_F(Square, KeepsADanglingConstrainedFaceByARepair)
{
    constrainFace(0);  // alone: the cavity reaches its other side around it
    const Vec3 point = centreOf(0) + Vec3{0, 0, 0.015625};
    const Cavity3d& cavity = delaunay_.findCavity(point, *delaunay_.locate(point), ConstraintPolicy::Refuse);
    ASSERT_EQ(cavity.status, CavityStatus::Ready);
    EXPECT_GT(cavity.repairs, 0u);
    EXPECT_EQ(delaunay_.commit().status, InsertionStatus::Inserted);
    EXPECT_TRUE(isFaceConstrained(mesh(), end_[0], end_[1], apex_[0]));
    EXPECT_TRUE(isSoundTopology(mesh()));
}

TEST_F(Square, NamesTheConstraintInTheWay)
{
    constrainFace(0);
    const Vec3 onFace = centreOf(0);
    const Cavity3d& byFace =
        delaunay_.findCavity(onFace, *delaunay_.locate(onFace), ConstraintPolicy::Refuse);
    EXPECT_EQ(byFace.status, CavityStatus::BlockedByConstraint);
    EXPECT_TRUE(isFaceConstrained(mesh(), byFace.blocker[0], byFace.blocker[1], byFace.blocker[2]));
    EXPECT_EQ(delaunay_.commit().status, InsertionStatus::Blocked);
    EXPECT_EQ(delaunay_.counters().blockedInsertions, 1u);

    mesh().setFaceConstrained(mesh().findFace(end_[0], end_[1], apex_[0]), false);
    constrainEdge(end_[0], end_[1]);
    const Vec3 onEdge = 0.5 * (mesh().position(end_[0]) + mesh().position(end_[1]));
    const std::uint64_t before = stateHash(mesh());
    const Cavity3d& byEdge =
        delaunay_.findCavity(onEdge, *delaunay_.locate(onEdge), ConstraintPolicy::Refuse);
    EXPECT_EQ(byEdge.status, CavityStatus::BlockedByConstraint);
    EXPECT_FALSE(byEdge.blocker[2].isValid());
    EXPECT_EQ((std::set<VertexId>{byEdge.blocker[0], byEdge.blocker[1]}),
              (std::set<VertexId>{end_[0], end_[1]}));
    EXPECT_EQ(stateHash(mesh()), before);
}

TEST_F(Square, TellsSeedsThatThePointDoesNotSee)
{
    // A seed on the other side of the square: its own faces are seen from behind.
    Cavity3d cavity;
    CavityOperator3d cavities(mesh());
    constrainFace(0);
    constrainFace(1);
    const Vec3 point{0.25, 0.25, 0.25};
    std::vector<TetId> seeds;
    for (const TetId t : finiteTets(mesh())) {
        if (mesh().slotOf(t, v_[5]) >= 0) seeds.push_back(t);
    }
    const std::uint64_t before = stateHash(mesh());
    const Cavity3d& found = cavities.find(point, std::span(seeds).first(1), {}, delaunay_.filter());
    EXPECT_NE(found.status, CavityStatus::Ready);
    EXPECT_EQ(stateHash(mesh()), before);
}

TEST(Cavity3d, HandsRegionsOn)
{
    Delaunay3d delaunay;
    insertAll(delaunay, gridPoints3d(64));
    Triangulation3d& mesh = delaunay.triangulation();
    // Two boxes with a wall between them, at x = 1.
    for (const TetId t : finiteTets(mesh)) {
        Vec3 middle;
        for (const VertexId v : mesh.tet(t).vertex) middle = middle + 0.25 * mesh.position(v);
        mesh.setRegion(t, RegionId(middle.x < 1 ? 1u : 2u));
    }
    for (const TetId t : liveTets(mesh)) {
        for (int i = 0; i < 4; ++i) {
            if (mesh.region(t) != mesh.region(mesh.neighbour(t, i).tet()))
                mesh.setFaceConstrained({t, i}, true);
        }
    }
    ASSERT_TRUE(isSoundTopology(mesh));
    std::map<std::uint32_t, double> before;
    for (const TetId t : finiteTets(mesh)) before[mesh.region(t).value] += volumeOf(mesh, t);
    Random random(3);
    for (int i = 0; i < 300; ++i) {
        const Vec3 p{random.between(-1, 4), random.between(-1, 4), random.between(-1, 4)};
        ASSERT_EQ(delaunay.insert(p, {}, ConstraintPolicy::Split)->status, InsertionStatus::Inserted);
    }
    for (const Vec3& p : {Vec3{1, 0.5, 0.75}, Vec3{1, 1.5, 1.5}, Vec3{1, 1, 2.5}, Vec3{0, 1.25, 1.5}}) {
        ASSERT_EQ(delaunay.insert(p, {}, ConstraintPolicy::Split)->status, InsertionStatus::Inserted);
    }
    EXPECT_TRUE(isSoundTopology(mesh));
    std::map<std::uint32_t, double> after;
    for (const TetId t : finiteTets(mesh)) after[mesh.region(t).value] += volumeOf(mesh, t);
    for (const auto& [region, volume] : before) EXPECT_NEAR(after[region], volume, 1e-9) << region;
    EXPECT_GT(after[0], 1.0);
}

TEST(Cavity3d, GrowsTheHull)
{
    for (const auto& points : {uniformPoints3d(50, 2), gridPoints3d(27)}) {
        std::vector<Vec3> all = points;
        Delaunay3d delaunay;
        insertAll(delaunay, points);
        // Beyond a facet, in the plane of facets, on the line of an edge, beyond a corner, far.
        for (const Vec3& p :
             {Vec3{1, 1, 4}, Vec3{5, 1, 2}, Vec3{6, 2, 2}, Vec3{-3, -3, -3}, Vec3{1e6, 1, 1}}) {
            ASSERT_EQ(delaunay.locate(p)->kind, Location3d::Kind::Outside);
            const std::uint64_t before = stateHash(delaunay.triangulation());
            const Cavity3d& cavity = delaunay.findCavity(p, *delaunay.locate(p), ConstraintPolicy::Refuse);
            ASSERT_EQ(cavity.status, CavityStatus::Ready);
            EXPECT_EQ(cavity.repairs, 0u);
            EXPECT_EQ(cavity.faces.size(), cavity.constraints.size());
            EXPECT_EQ(stateHash(delaunay.triangulation()), before);
            EXPECT_EQ(delaunay.commit({1, 0, 5}).status, InsertionStatus::Inserted);
            all.push_back(p);
            EXPECT_EQ(meshHash3d(delaunay.triangulation()), hashOf(all));
            EXPECT_TRUE(isSoundTopology(delaunay.triangulation()));
        }
    }
}

/// Whether the segment (p, q) meets the triangle; the border counts.
bool meets(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Sign sideP = orient3d(a, b, c, p);
    const Sign sideQ = orient3d(a, b, c, q);
    if (sideP == sideQ && sideP != Sign::Zero) return false;
    const Sign s[3] = {orient3d(p, q, a, b), orient3d(p, q, b, c), orient3d(p, q, c, a)};
    const bool hasPositive = std::count(std::begin(s), std::end(s), Sign::Positive) > 0;
    const bool hasNegative = std::count(std::begin(s), std::end(s), Sign::Negative) > 0;
    return !(hasPositive && hasNegative);
}

/// A constrained face is encroached by a point that it sees (from its middle, past all other constrained faces) and
/// that lies in its smallest sphere, but for a face that its own tetrahedron on that side encroaches already.
TEST(Cavity3d, FindsAllCandidatesForEncroachment)
{
    int encroached = 0;
    for (int number = 0; number < repetitions(300); ++number) {
        SCOPED_TRACE(number);
        Delaunay3d delaunay;
        insertAll(delaunay, uniformPoints3d(60, static_cast<std::uint64_t>(number)));
        Triangulation3d& mesh = delaunay.triangulation();
        Random random(static_cast<std::uint64_t>(number));
        std::vector<TetFace> faces;
        const std::vector<TetId> tets = finiteTets(mesh);
        for (int i = 0; i < 25; ++i) {
            const TetFace face(tets[random.below(static_cast<std::uint32_t>(tets.size()))],
                               static_cast<int>(random.below(4)));
            if (mesh.isFaceConstrained(face)) continue;
            mesh.setFaceConstrained(face, true);
            faces.push_back(face);
        }
        for (int i = 0; i < 5; ++i) {
            const Vec3 p{random.unit(), random.unit(), random.unit()};
            const Cavity3d& cavity = delaunay.findCavity(p, *delaunay.locate(p), ConstraintPolicy::Refuse);
            if (cavity.status != CavityStatus::Ready || cavity.repairs > 0) continue;
            std::set<std::array<VertexId, 3>> candidates;
            for (const TetFace face : cavity.constrainedFaces) {
                auto corner = mesh.faceVertices(face);
                std::sort(corner.begin(), corner.end());
                candidates.insert(corner);
            }
            for (const TetFace face : faces) {
                auto corner = mesh.faceVertices(face);
                const Vec3 a = mesh.position(corner[0]), b = mesh.position(corner[1]),
                           c = mesh.position(corner[2]);
                const Vec3 normal = cross(b - a, c - a);
                const Vec3 centre =
                    a + (0.5 / squaredLength(normal)) * (squaredLength(b - a) * cross(c - a, normal) +
                                                         squaredLength(c - a) * cross(normal, b - a));
                const double radius = length(a - centre);
                if (length(p - centre) >= 0.999999 * radius) continue;
                const bool isInFront = orient3d(a, b, c, p) == Sign::Positive;
                const TetFace side = isInFront ? face : mesh.neighbour(face);
                const VertexId apex = mesh.vertex(side.tet(), side.face());
                if (!isGhost(apex) && length(mesh.position(apex) - centre) <= 1.000001 * radius) continue;
                const Vec3 middle = (1.0 / 3.0) * (a + b + c);
                const bool isHidden = std::any_of(faces.begin(), faces.end(), [&](TetFace other) {
                    if (other == face) return false;
                    const auto [x, y, z] = mesh.faceVertices(other);
                    return meets(middle, p, mesh.position(x), mesh.position(y), mesh.position(z));
                });
                if (isHidden) continue;
                ++encroached;
                std::sort(corner.begin(), corner.end());
                EXPECT_EQ(candidates.count(corner), 1u);
            }
        }
    }
    EXPECT_GT(encroached, repetitions(300) / 4);
}

/// An octahedron in region 1 whose eight facets are constrained.
struct Octahedron
{
    Delaunay3d delaunay;
    std::array<VertexId, 3> facet;  ///< in x, y, z > 0

    Octahedron()
    {
        const std::vector<Vec3> corners = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                           {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
        const BulkInsertion3d inserted = insertAll(delaunay, corners);
        facet = {inserted.vertex[0], inserted.vertex[1], inserted.vertex[2]};
        std::sort(facet.begin(), facet.end());
        Triangulation3d& mesh = delaunay.triangulation();
        for (const TetId tet : finiteTets(mesh)) mesh.setRegion(tet, RegionId(1u));
        for (const TetId tet : liveTets(mesh)) {
            if (mesh.isGhostTet(tet)) mesh.setFaceConstrained({tet, 3}, true);
        }
    }

    [[nodiscard]] double regionVolume() const
    {
        double volume = 0.0;
        for (const TetId tet : finiteTets(delaunay.triangulation())) {
            if (delaunay.triangulation().region(tet) == RegionId(1u))
                volume += volumeOf(delaunay.triangulation(), tet);
        }
        return volume;
    }

    CavityStatus replaceFacetBy(const Vec3& point)
    {
        const std::vector<std::array<VertexId, 3>> faces = {facet};
        const std::vector<std::array<VertexId, 2>> perimeter = {
            {facet[0], facet[1]}, {facet[1], facet[2]}, {facet[2], facet[0]}};
        const CavityStatus status =
            delaunay.findCavity(point, {CavitySplit3d::Kind::Facets, {}, faces, perimeter}).status;
        if (status != CavityStatus::Ready) return status;
        const VertexId v = delaunay.commit().vertex;
        const Triangulation3d& mesh = delaunay.triangulation();
        for (const auto& [a, b] : perimeter) {
            const TetFace face = mesh.findFace(a, b, v);
            EXPECT_TRUE(face.isValid() && mesh.isFaceConstrained(face));
        }
        const TetFace old = mesh.findFace(facet[0], facet[1], facet[2]);
        EXPECT_FALSE(old.isValid() && mesh.isFaceConstrained(old));
        EXPECT_TRUE(isSoundTopology(mesh));
        return status;
    }
};

TEST(Cavity3dFacets, GiveTheirRegionToAPointInFront)
{
    Octahedron solid;
    ASSERT_EQ(solid.replaceFacetBy({0.5, 0.5, 0.5}), CavityStatus::Ready);
    EXPECT_NEAR(solid.regionVolume(), (8.0 + 0.5) / 6.0, 1e-15);
}

TEST(Cavity3dFacets, StayAsOrdinaryFacesBeforeAPointBehind)
{
    Octahedron solid;
    ASSERT_EQ(solid.replaceFacetBy({0.3, 0.3, 0.3}), CavityStatus::Ready);
    EXPECT_NEAR(solid.regionVolume(), (8.0 - 0.1) / 6.0, 1e-15);
    const auto& f = solid.facet;
    EXPECT_TRUE(solid.delaunay.triangulation().findFace(f[0], f[1], f[2]).isValid());
}

TEST(Cavity3dFacets, AreHalvedByAPointInTheirPlane)
{
    Octahedron solid;
    ASSERT_EQ(solid.replaceFacetBy({0.25, 0.25, 0.5}), CavityStatus::Ready);
    EXPECT_NEAR(solid.regionVolume(), 8.0 / 6.0, 1e-15);
}

TEST(Cavity3dFacets, AreLeftAloneByAPointBehindOtherFacets)
{
    Octahedron solid;
    const std::uint64_t before = stateHash(solid.delaunay.triangulation());
    EXPECT_NE(solid.replaceFacetBy({-2, -2, -2}), CavityStatus::Ready);
    EXPECT_EQ(stateHash(solid.delaunay.triangulation()), before);
}

}  // namespace
}  // namespace mesher::test
