// Random insertions and removals in 3D Delaunay triangulations, checked after each and compared with triangulations made
// anew. A run is a row of independent rounds, round r with the seed S + r, so a run is continued with the seed that it
// prints, and a failing round is repeated alone.

#include "base/random.h"
#include "delaunay/delaunay3d.h"
#include "delaunay/delaunay_check3d.h"
#include "delaunay/mesh_hash.h"
#include "predicates/insphere.h"
#include "predicates/orient3d.h"
#include "support/degenerate_points.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <set>
#include <string>
#include <vector>

namespace mesher {
namespace {

struct Options
{
    std::uint64_t operations = 20000;
    std::uint64_t seed = 1;
    std::uint32_t size = 300;         ///< vertices around which the triangulation is kept
    std::uint64_t checkEvery = 1000;  ///< operations between two full checks
    std::string kind = "all";
};

struct Counts
{
    std::uint64_t operations = 0;
    std::uint64_t insertions = 0;
    std::uint64_t duplicates = 0;
    std::uint64_t removals = 0;
    std::uint64_t flatOperations = 0;  ///< below dimension 3
    std::uint64_t fullChecks = 0;
};

constexpr std::uint64_t kRoundLength = 10000;
const char* const kKinds[] = {"random", "grid", "cospherical", "1-ulp", "clusters", "mixed"};

std::vector<Vec3> latticePoints(std::size_t count, Random& random)
{
    std::vector<Vec3> points(count);
    for (Vec3& p : points) p = {double(random.below(8)), double(random.below(8)), double(random.below(8))};
    return points;
}

/// The places that a round inserts at; each comes and goes many times.
std::vector<Vec3> placesOf(const std::string& kind, std::size_t count, Random& random)
{
    if (kind == "random") return test::uniformPoints3d(count, random());
    if (kind == "grid") return latticePoints(count, random);
    if (kind == "cospherical") return test::cosphericalPoints3d(count, random());
    if (kind == "1-ulp") return test::ulpPoints3d(count, random());
    if (kind == "clusters") return test::clusteredPoints3d(count, random());
    std::vector<Vec3> places = latticePoints(count / 2, random);
    for (const auto& p : test::cosphericalPoints3d(count / 4, random())) places.push_back(p);
    for (const auto& p : test::coplanarPoints3d(count - places.size(), random())) places.push_back(p);
    return places;
}

/// One round; `fail` is called on the first discrepancy.
class Round
{
public:
    Round(std::string kind, std::uint64_t seed, const Options& options, Counts& counts)
        : kind_(std::move(kind)),
          seed_(seed),
          options_(options),
          counts_(counts),
          random_(seed),
          delaunay_(seed),
          places_(placesOf(kind_, 3 * std::size_t{options.size}, random_))
    {
    }

    void run(std::uint64_t operations)
    {
        for (done_ = 0; done_ < operations; ++done_) {
            // Now and then all goes, through the lower dimensions and back.
            const std::uint32_t target = done_ / 1250 % 4 == 3 ? 2 : options_.size;
            const bool isGrowing = vertices_.size() < target;
            if (vertices_.empty() || random_.below(10) < (isGrowing ? 7u : 3u)) {
                insertOne();
            } else {
                removeOne();
            }
            ++counts_.operations;
            counts_.flatOperations += delaunay_.dimension() < 3 ? 1 : 0;
            if ((done_ + 1) % options_.checkEvery == 0) checkAll();
        }
        checkAll();
    }

private:
    [[noreturn]] void fail(const std::string& what) const
    {
        std::fprintf(stderr, "delaunay3d_fuzz: kind %s, seed %llu, operation %llu: %s\n", kind_.c_str(),
                     static_cast<unsigned long long>(seed_), static_cast<unsigned long long>(done_),
                     what.c_str());
        std::exit(1);
    }

    void insertOne()
    {
        const Vec3 place = places_[random_.below(static_cast<std::uint32_t>(places_.size()))];
        const auto known = std::find_if(vertices_.begin(), vertices_.end(), [&](VertexId v) {
            return delaunay_.triangulation().position(v) == place;
        });
        const bool isKnown = known != vertices_.end();
        const Result<Insertion3d> result = delaunay_.insert(place);
        if (!result) fail(describe(result.error()));
        if (isKnown) {
            if (result->status != InsertionStatus::Duplicate || result->vertex != *known)
                fail("a duplicate went in");
            ++counts_.duplicates;
            return;
        }
        if (result->status != InsertionStatus::Inserted) fail("a new point did not go in");
        vertices_.push_back(result->vertex);
        ++counts_.insertions;
        if (delaunay_.dimension() < 3) return;
        std::vector<TetId> star;
        delaunay_.triangulation().collectStar(result->vertex, star);
        if (star.size() < 4) fail("a vertex with fewer than four tetrahedra");
        checkTets(star);
    }

    void removeOne()
    {
        const std::uint32_t chosen = random_.below(static_cast<std::uint32_t>(vertices_.size()));
        const VertexId vertex = vertices_[chosen];
        vertices_[chosen] = vertices_.back();
        vertices_.pop_back();
        std::set<VertexId> link;
        std::vector<TetId> star;
        const Triangulation3d& mesh = delaunay_.triangulation();
        if (delaunay_.dimension() == 3) mesh.collectStar(vertex, star);
        for (const TetId tet : star) link.insert(mesh.tet(tet).vertex.begin(), mesh.tet(tet).vertex.end());
        link.erase(vertex);
        link.erase(kGhostVertex);
        if (delaunay_.remove(vertex) != RemovalStatus::Removed) fail("a removal was refused");
        ++counts_.removals;
        if (delaunay_.dimension() < 3) return;
        std::set<TetId> around;
        for (const VertexId v : link) {
            mesh.collectStar(v, star);
            around.insert(star.begin(), star.end());
        }
        checkTets({around.begin(), around.end()});
    }

    void checkTets(const std::vector<TetId>& tets) const
    {
        const Triangulation3d& mesh = delaunay_.triangulation();
        for (const TetId tet : tets) {
            if (!mesh.isAlive(tet)) fail("a star has a dead tetrahedron");
            if (!mesh.isGhostTet(tet) && !isPositive(tet)) fail("a tetrahedron is not positively oriented");
            for (int face = 0; face < 4; ++face) {
                const TetFace other = mesh.neighbour(tet, face);
                if (mesh.neighbour(other) != TetFace(tet, face)) fail("a link is not symmetric");
                const VertexId apex = mesh.vertex(other.tet(), other.face());
                if (!isGhost(apex) && isInside(tet, mesh.position(apex)))
                    fail("a face is not locally Delaunay");
            }
        }
    }

    bool isPositive(TetId tet) const
    {
        const Triangulation3d& mesh = delaunay_.triangulation();
        const auto& v = mesh.tet(tet).vertex;
        return orient3d(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]), mesh.position(v[3])) ==
               Sign::Positive;
    }

    bool isInside(TetId tet, const Vec3& point) const
    {
        const Triangulation3d& mesh = delaunay_.triangulation();
        const auto& v = mesh.tet(tet).vertex;
        if (mesh.isGhostTet(tet)) {
            return orient3d(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]), point) ==
                   Sign::Positive;
        }
        return inspherePerturbed(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]),
                                 mesh.position(v[3]), point) == Sign::Positive;
    }

    void checkAll()
    {
        ++counts_.fullChecks;
        const Triangulation3d& mesh = delaunay_.triangulation();
        if (mesh.vertexCount() != vertices_.size()) fail("vertices were lost");
        if (delaunay_.dimension() == 3) {
            const CheckReport topology = checkTopology3d(mesh);
            if (!topology.isValid()) fail(topology.problem);
            const CheckReport local = checkDelaunay3d(mesh, DelaunayScope::Local);
            if (!local.isValid()) fail(local.problem);
        }
        std::vector<Vec3> points;
        for (const VertexId v : vertices_) points.push_back(mesh.position(v));
        test::shuffle(points, random_);
        Delaunay3d anew(random_());
        RunContext context;
        if (!anew.insertPoints(points, {}, context)) fail("the points were refused");
        if (anew.dimension() != delaunay_.dimension()) fail("another dimension than made anew");
        if (meshHash3d(anew.triangulation()) != meshHash3d(mesh))
            fail("another triangulation than made anew");
        if (random_.below(4) == 0) compactAll();
    }

    void compactAll()
    {
        const Renumbering3d map = delaunay_.compact();
        for (VertexId& v : vertices_) v = map.vertex[v];
    }

    std::string kind_;
    std::uint64_t seed_;
    const Options& options_;
    Counts& counts_;
    Random random_;
    Delaunay3d delaunay_;
    std::vector<Vec3> places_;
    std::vector<VertexId> vertices_;
    std::uint64_t done_ = 0;
};

[[noreturn]] void showUsage()
{
    std::fputs("usage: delaunay3d_fuzz [--operations N] [--seed S] [--size M] [--check-every N]\n"
               "                       [--kind all|random|grid|cospherical|1-ulp|clusters|mixed]\n",
               stderr);
    std::exit(2);
}

Options parse(int count, char** arguments)
{
    Options options;
    for (int i = 1; i < count; i += 2) {
        if (i + 1 >= count) showUsage();
        const char* value = arguments[i + 1];
        const std::string name = arguments[i];
        if (name == "--operations")
            options.operations = std::strtoull(value, nullptr, 10);
        else if (name == "--seed")
            options.seed = std::strtoull(value, nullptr, 10);
        else if (name == "--size")
            options.size = static_cast<std::uint32_t>(std::strtoul(value, nullptr, 10));
        else if (name == "--check-every")
            options.checkEvery = std::strtoull(value, nullptr, 10);
        else if (name == "--kind")
            options.kind = value;
        else
            showUsage();
    }
    const bool isKnown = options.kind == "all" ||
                         std::find(std::begin(kKinds), std::end(kKinds), options.kind) != std::end(kKinds);
    if (!isKnown || options.size < 8 || options.checkEvery == 0) showUsage();
    return options;
}

}  // namespace
}  // namespace mesher

int main(int argumentCount, char** arguments)
{
    using namespace mesher;
    const Options options = parse(argumentCount, arguments);
    Counts counts;
    std::uint64_t seed = options.seed;
    for (std::uint64_t done = 0; done < options.operations; done += kRoundLength, ++seed) {
        const std::string kind = options.kind == "all" ? kKinds[seed % std::size(kKinds)] : options.kind;
        Round(kind, seed, options, counts).run(std::min(kRoundLength, options.operations - done));
    }
    std::printf("{\"program\": \"delaunay3d_fuzz\", \"kind\": \"%s\", \"seed\": %llu, \"next_seed\": %llu, "
                "\"operations\": %llu, \"insertions\": %llu, \"duplicates\": %llu, \"removals\": %llu, "
                "\"below_dimension_3\": %llu, \"full_checks\": %llu, \"failures\": 0}\n",
                options.kind.c_str(), static_cast<unsigned long long>(options.seed),
                static_cast<unsigned long long>(seed), static_cast<unsigned long long>(counts.operations),
                static_cast<unsigned long long>(counts.insertions),
                static_cast<unsigned long long>(counts.duplicates),
                static_cast<unsigned long long>(counts.removals),
                static_cast<unsigned long long>(counts.flatOperations),
                static_cast<unsigned long long>(counts.fullChecks));
    return 0;
}
