// Random sequences of flips, insertions and removals in small triangulations with constraints. Each configuration is made
// from its number alone; MESHER_CONFIGURATION=<number> runs that one only.

#include "delaunay/flips3d.h"
#include "predicates/insphere.h"
#include "predicates/orient3d.h"
#include "property/constraint_model3d.h"
#include "support/test_effort.h"
#include "support/triangulations3d.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace mesher::test {
namespace {

constexpr int kConfigurations = 10000;
constexpr int kBatches = 4;
constexpr int kOperations = 14;

/// Coordinates are small integers, so that points exactly on edges and faces can be made a few times over.
std::vector<Vec3> configurationPoints(Random& random)
{
    const std::uint32_t count = 10 + random.below(51);
    const std::uint32_t kind = random.below(4);
    std::vector<Vec3> points;
    if (kind == 3) points = cosphericalPoints3d(count, random());
    while (points.size() < count) {
        const bool isGrid = kind == 1 || (kind == 2 && random.below(2) == 0);
        const std::uint32_t width = isGrid ? 4 : 4096;
        const double spacing = isGrid ? 1024.0 : 1.0;
        points.push_back(
            {spacing * random.below(width), spacing * random.below(width), spacing * random.below(width)});
    }
    return points;
}

double measureOf(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const double longest = std::max({squaredLength(b - a), squaredLength(c - a), squaredLength(d - a),
                                     squaredLength(c - b), squaredLength(d - b), squaredLength(d - c)});
    return volumeOf(a, b, c, d) / (longest * std::sqrt(longest));
}

class Configuration
{
public:
    explicit Configuration(std::uint64_t number) : random_(number), delaunay_(number), replacement_(mesh())
    {
        const std::vector<Vec3> points = configurationPoints(random_);
        insertAll(delaunay_, points);
        for (const Vec3& p : points) box_.include(p);
        if (delaunay_.dimension() == 3) constrain();
    }

    void run()
    {
        if (delaunay_.dimension() < 3) return;
        for (int i = 0; i < kOperations && !testing::Test::HasFailure(); ++i) {
            SCOPED_TRACE("operation " + std::to_string(i));
            const std::map<std::uint32_t, double> volumes = regionVolumes();
            changesHull_ = false;
            switch (random_.below(8)) {
                case 0: flipFace(); break;
                case 1:
                case 2: flipEdge(); break;
                case 3: removeVertex(); break;
                default: insertPoint(); break;
            }
            checkState(volumes);
        }
    }

    /// Operations that took effect, by name; a property that is never exercised is not tested.
    std::map<std::string, int> done;

private:
    Triangulation3d& mesh() { return delaunay_.triangulation(); }

    // --- set-up

    void constrain()
    {
        const bool hasRegions = random_.below(2) == 0;
        if (hasRegions) makeRegions();
        const std::uint32_t faceCount = random_.below(hasRegions ? 4 : 12);
        const bool hasEdges = random_.below(2) == 0;
        for (std::uint32_t i = 0; i < faceCount; ++i) {
            const TetFace face = randomFiniteFace();
            constrainFace(face);
            const auto [a, b, c] = mesh().faceVertices(face);
            if (!hasEdges) continue;
            for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
                constrainEdge(face.tet(), from, to);
            }
        }
        const std::uint32_t edgeCount = random_.below(4);
        for (std::uint32_t i = 0; i < edgeCount; ++i) {
            const TetFace face = randomFiniteFace();
            const auto corner = mesh().faceVertices(face);
            constrainEdge(face.tet(), corner[0], corner[1]);
        }
        EXPECT_TRUE(isSoundTopology(mesh()));
    }

    void makeRegions()
    {
        const Vec3 centre = randomPoint(0.0);
        const double radius = box_.extent().x * random_.between(0.1, 0.6);
        const bool isRandom = random_.below(4) == 0;
        for (const TetId tet : finiteTets(mesh())) {
            Vec3 middle;
            for (const VertexId v : mesh().tet(tet).vertex) middle = middle + 0.25 * mesh().position(v);
            const bool isInside = isRandom ? random_.below(4) == 0 : length(middle - centre) < radius;
            if (isInside) mesh().setRegion(tet, RegionId(1 + (middle.x > centre.x ? 1u : 0u)));
        }
        for (const TetId tet : liveTets(mesh())) {
            for (int i = 0; i < 4; ++i) {
                const TetFace face(tet, i);
                if (mesh().region(tet) != mesh().region(mesh().neighbour(face).tet())) constrainFace(face);
            }
        }
    }

    void constrainFace(TetFace face)
    {
        mesh().setFaceConstrained(face, true);
        model_.faces.insert(ConstraintModel3d::sorted(mesh().faceVertices(face)));
    }
    void constrainEdge(TetId tet, VertexId a, VertexId b)
    {
        mesh().setEdgeConstrained(tet, a, b, true);
        model_.edges.insert(ConstraintModel3d::sorted(a, b));
    }

    // --- random choices

    TetId randomTet()
    {
        const std::vector<TetId> tets = finiteTets(mesh());
        return tets[random_.below(static_cast<std::uint32_t>(tets.size()))];
    }
    TetFace randomFiniteFace() { return {randomTet(), static_cast<int>(random_.below(4))}; }
    Vec3 randomPoint(double margin)
    {
        const auto coordinate = [&](double low, double high) {
            const double room = margin * (high - low) + 1.0;
            return std::floor(random_.between(low - room, high + room));
        };
        return {coordinate(box_.low.x, box_.high.x), coordinate(box_.low.y, box_.high.y),
                coordinate(box_.low.z, box_.high.z)};
    }
    /// Of the constrained ones if there are any, half of the time.
    TetFace randomTargetFace()
    {
        if (!model_.faces.empty() && random_.below(2) == 0) {
            auto chosen = model_.faces.begin();
            std::advance(chosen, random_.below(static_cast<std::uint32_t>(model_.faces.size())));
            return mesh().findFace((*chosen)[0], (*chosen)[1], (*chosen)[2]);
        }
        return randomFiniteFace();
    }

    // --- operations

    void flipFace()
    {
        const TetFace face = randomFiniteFace();
        const std::uint64_t before = stateHash(mesh());
        const std::optional<Flip3d> flip = evaluateFlip23(mesh(), face);
        EXPECT_EQ(stateHash(mesh()), before);
        if (!flip) return;
        applyFlip(replacement_, *flip);
        ++done["flip 2-3"];
    }

    void flipEdge()
    {
        const TetFace face = randomTargetFace();
        const TetId tet = face.tet();
        const auto& slots = kFaceSlots[face.face()];
        const std::uint32_t first = random_.below(3);
        const int edge = kEdgeOfSlots[slots[first]][slots[(first + 1) % 3]];
        const VertexId a = mesh().vertex(tet, kEdgeSlots[edge][0]);
        const VertexId b = mesh().vertex(tet, kEdgeSlots[edge][1]);
        const std::uint64_t before = stateHash(mesh());
        std::optional<Flip3d> flip;
        std::string name;
        if ((flip = evaluateFlip32(mesh(), tet, edge)))
            name = "flip 3-2";
        else if ((flip = evaluateFlip22(mesh(), tet, edge)))
            name = "flip 2-2";
        else if ((flip = evaluateFlip44(mesh(), tet, edge, static_cast<int>(random_.below(2)))))
            name = "flip 4-4";
        else if ((flip = evaluateEdgeRemoval(mesh(), tet, edge, measureOf)))
            name = "edge removal";
        EXPECT_EQ(stateHash(mesh()), before);
        if (!flip) return;
        EXPECT_FALSE(model_.hasEdge(a, b));
        const std::size_t pair = model_.facesAt(a, b).size();
        if (pair > 0) {
            EXPECT_EQ(pair, 2u);
            EXPECT_TRUE(name == "flip 2-2" || name == "flip 4-4") << name;
            model_.flipPair(a, b);
            name += " of a constrained pair";
        }
        applyFlip(replacement_, *flip);
        EXPECT_FALSE(mesh().findEdge(a, b).isValid());
        ++done[name];
    }

    void removeVertex()
    {
        const std::vector<VertexId> vertices = liveVertices(mesh());
        if (vertices.size() < 10) return;
        const VertexId vertex = vertices[random_.below(static_cast<std::uint32_t>(vertices.size()))];
        std::vector<TetId> star;
        mesh().collectStar(vertex, star);
        const bool isOnHull =
            std::any_of(star.begin(), star.end(), [&](TetId t) { return mesh().isGhostTet(t); });
        const std::uint64_t before = stateHash(mesh());
        const bool wasDelaunay = checkDelaunay3d(mesh(), DelaunayScope::Local).isValid();
        const RemovalStatus status = delaunay_.remove(vertex);
        EXPECT_EQ(status == RemovalStatus::OnConstraint, model_.isUsed(vertex));
        if (status != RemovalStatus::Removed) {
            EXPECT_EQ(stateHash(mesh()), before);
            done[status == RemovalStatus::Blocked ? "removal blocked" : "removal on constraint"]++;
            return;
        }
        changesHull_ = isOnHull;
        EXPECT_FALSE(mesh().isVertexAlive(vertex));
        if (wasDelaunay) {
            EXPECT_TRUE(isDelaunay(mesh(), DelaunayScope::Local)) << "after a removal";
            ++done["Delaunay removal"];
        }
        ++done["removal"];
    }

    Vec3 choosePoint()
    {
        const std::uint32_t kind = random_.below(8);
        if (kind < 2) return randomPoint(0.0);
        if (kind == 2) return randomPoint(0.5);
        const TetFace face = randomTargetFace();
        const auto corner = mesh().faceVertices(face);
        if (isGhost(corner[0]) || isGhost(corner[1]) || isGhost(corner[2])) return randomPoint(0.0);
        const Vec3 a = mesh().position(corner[0]);
        const Vec3 b = mesh().position(corner[1]);
        const Vec3 c = mesh().position(corner[2]);
        if (kind < 5) return 0.5 * (a + b);
        return 0.25 * ((a + b) + (c + (random_.below(2) == 0 ? a : b)));
    }

    void insertPoint()
    {
        const Vec3 point = choosePoint();
        const Result<Location3d> located = delaunay_.locate(point);
        ASSERT_TRUE(located.hasValue());
        const Location3d location = *located;
        if (location.kind == Location3d::Kind::Vertex) return;
        const ConstraintPolicy policy =
            random_.below(2) == 0 ? ConstraintPolicy::Refuse : ConstraintPolicy::Split;
        const std::uint64_t before = stateHash(mesh());
        const bool wasDelaunay = checkDelaunay3d(mesh(), DelaunayScope::Local).isValid();
        const Cavity3d& cavity = delaunay_.findCavity(point, location, policy);
        EXPECT_EQ(stateHash(mesh()), before) << "looking at a cavity changed the mesh";
        const bool isReady = cavity.status == CavityStatus::Ready;
        const bool isRepaired = cavity.repairs > 0;
        if (!isReady) checkBlocker(cavity, location);
        if (random_.below(4) == 0) return;  // looked only

        const std::vector<VertexId> corners = cornersOf(location);
        const bool isOnConstraint = liesOnConstraint(corners);
        const Result<Insertion3d> result = delaunay_.insert(point, location.tet, policy);
        ASSERT_TRUE(result.hasValue());
        // The seeds alone are star-shaped, so only a constraint at the point itself can refuse it.
        const bool isRefused = policy == ConstraintPolicy::Refuse && isOnConstraint;
        EXPECT_EQ(isReady, !isRefused);
        EXPECT_EQ(result->status, isRefused ? InsertionStatus::OnConstraint : InsertionStatus::Inserted);
        if (result->status != InsertionStatus::Inserted) {
            EXPECT_EQ(stateHash(mesh()), before) << "a refused insertion changed the mesh";
            ++done["insertion on constraint refused"];
            return;
        }
        changesHull_ = location.kind == Location3d::Kind::Outside;
        EXPECT_TRUE(mesh().position(result->vertex) == point);
        updateModel(corners, result->vertex);
        ++done[std::string(isOnConstraint ? "split" : "insertion") + (isRepaired ? " with repairs" : "")];
        if (wasDelaunay && !isRepaired) checkDelaunayAfterInsertion(result->vertex);
    }

    std::vector<VertexId> cornersOf(const Location3d& location)
    {
        if (location.kind == Location3d::Kind::Face) {
            const auto face = mesh().faceVertices({location.tet, location.index});
            return {face.begin(), face.end()};
        }
        if (location.kind != Location3d::Kind::Edge) return {};
        return {mesh().vertex(location.tet, kEdgeSlots[location.index][0]),
                mesh().vertex(location.tet, kEdgeSlots[location.index][1])};
    }
    bool liesOnConstraint(const std::vector<VertexId>& corners) const
    {
        if (corners.size() == 3) return model_.hasFace(corners[0], corners[1], corners[2]);
        if (corners.size() < 2) return false;
        return model_.hasEdge(corners[0], corners[1]) || !model_.facesAt(corners[0], corners[1]).empty();
    }
    void updateModel(const std::vector<VertexId>& corners, VertexId vertex)
    {
        if (corners.size() == 3) model_.splitFace({corners[0], corners[1], corners[2]}, vertex);
        if (corners.size() == 2) model_.splitEdge(corners[0], corners[1], vertex);
    }

    /// The constraint in the way is one, or a side of the face that was to be split.
    void checkBlocker(const Cavity3d& cavity, const Location3d& location)
    {
        if (cavity.status != CavityStatus::BlockedByConstraint) return;
        const auto& [a, b, c] = cavity.blocker;
        if (c.isValid()) {
            EXPECT_TRUE(model_.hasFace(a, b, c));
            return;
        }
        const bool isSide = location.kind == Location3d::Kind::Face || location.kind == Location3d::Kind::Edge
                                ? !model_.facesAt(a, b).empty()
                                : false;
        EXPECT_TRUE(model_.hasEdge(a, b) || isSide);
    }

    // --- what holds

    /// Without a repair only a face of the new vertex p and an edge ab can have lost the property, and only if a
    /// constrained face ends at ab and the cavity is reflex there: the tetrahedra (p, a, b, c) and (p, a, b, d) then have
    /// p and d on different sides of (a, b, c), so that no old face between c and d vouches for them.
    void checkDelaunayAfterInsertion(VertexId point)
    {
        ++done["Delaunay insertion"];
        for (const TetId tet : liveTets(mesh())) {
            for (int i = 0; i < 4; ++i) {
                if (mesh().isFaceConstrained({tet, i}) || isLocallyDelaunay(tet, i)) continue;
                const auto corner = mesh().faceVertices({tet, i});
                const auto own = std::find(corner.begin(), corner.end(), point);
                ASSERT_TRUE(own != corner.end()) << "an old face lost the Delaunay property";
                ASSERT_FALSE(mesh().isGhostTet(tet));
                const VertexId a = corner[static_cast<unsigned>(own - corner.begin() + 1) % 3];
                const VertexId b = corner[static_cast<unsigned>(own - corner.begin() + 2) % 3];
                EXPECT_FALSE(model_.facesAt(a, b).empty()) << "no constrained face ends at the edge";
                const TetFace other = mesh().neighbour(tet, i);
                const Vec3& c = mesh().position(mesh().vertex(tet, i));
                const Vec3& d = mesh().position(mesh().vertex(other.tet(), other.face()));
                const auto sideOf = [&](const Vec3& p) {
                    return orient3d(mesh().position(a), mesh().position(b), c, p);
                };
                EXPECT_NE(sideOf(d), sideOf(mesh().position(point)))
                    << "the cavity is not reflex at the edge";
                ++done["reflex exception"];
            }
        }
    }

    bool isLocallyDelaunay(TetId tet, int face)
    {
        const TetFace other = mesh().neighbour(tet, face);
        const VertexId apex = mesh().vertex(other.tet(), other.face());
        if (isGhost(apex)) return true;
        const auto& v = mesh().tet(tet).vertex;
        const Vec3& p = mesh().position(apex);
        if (mesh().isGhostTet(tet)) {
            return orient3d(mesh().position(v[0]), mesh().position(v[1]), mesh().position(v[2]), p) !=
                   Sign::Positive;
        }
        return inspherePerturbed(mesh().position(v[0]), mesh().position(v[1]), mesh().position(v[2]),
                                 mesh().position(v[3]), p) != Sign::Positive;
    }

    std::map<std::uint32_t, double> regionVolumes()
    {
        std::map<std::uint32_t, double> volumes;
        for (const TetId tet : finiteTets(mesh())) volumes[mesh().region(tet).value] += volumeOf(mesh(), tet);
        return volumes;
    }

    void checkState(const std::map<std::uint32_t, double>& volumesBefore)
    {
        EXPECT_TRUE(isSoundTopology(mesh()));
        EXPECT_TRUE(ConstraintModel3d::of(mesh()) == model_) << "constraints were lost or made";
        const Vec3 extent = box_.extent();
        const double tolerance = 1e-9 * (1.0 + extent.x) * (1.0 + extent.y) * (1.0 + extent.z);
        std::map<std::uint32_t, double> volumes = regionVolumes();
        for (const auto& [region, volume] : volumesBefore) {
            if (region == kExteriorRegion.value && changesHull_) continue;
            EXPECT_NEAR(volumes[region], volume, tolerance) << "region " << region;
        }
        EXPECT_LE(volumes.size(), volumesBefore.size() + 1);
    }

    Random random_;
    Delaunay3d delaunay_;
    TetReplacement3d replacement_;
    Box3 box_;
    ConstraintModel3d model_;
    bool changesHull_ = false;
};

class ConstrainedOperations3d : public testing::TestWithParam<int>
{
};

TEST_P(ConstrainedOperations3d, KeepTopologyConstraintsAndRegions)
{
    const int share = repetitions(kConfigurations) / kBatches + 1;
    int first = GetParam() * (kConfigurations / kBatches);
    int last = first + share;
    if (const char* chosen = std::getenv("MESHER_CONFIGURATION")) {
        first = std::atoi(chosen);
        last = first + 1;
    }
    std::map<std::string, int> done;
    for (int number = first; number < last; ++number) {
        SCOPED_TRACE("configuration " + std::to_string(number));
        Configuration configuration(static_cast<std::uint64_t>(number));
        configuration.run();
        for (const auto& [name, count] : configuration.done) done[name] += count;
        if (HasFailure()) return;
    }
    for (const auto& [name, count] : done) RecordProperty(name, count);
    if (share < kConfigurations / kBatches) return;
    for (const char* name :
         {"flip 2-3", "flip 3-2", "flip 4-4", "flip 2-2", "edge removal", "flip 4-4 of a constrained pair",
          "flip 2-2 of a constrained pair", "removal", "removal blocked", "removal on constraint",
          "Delaunay removal", "insertion", "insertion with repairs", "insertion on constraint refused",
          "split", "split with repairs", "Delaunay insertion", "reflex exception"}) {
        EXPECT_GT(done[name], 0) << name << " never happened";
    }
}

INSTANTIATE_TEST_SUITE_P(Batches, ConstrainedOperations3d, testing::Range(0, kBatches));

}  // namespace
}  // namespace mesher::test
