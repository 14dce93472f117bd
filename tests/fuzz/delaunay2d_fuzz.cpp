// Random changes of a 2D triangulation, checked as they go. Options: --operations N, --seed S, --check-every K,
// --log FILE (each operation is written before it is done, so that reduce_replay can shrink what led to a crash).
// Ends with 1 at the first violation.

#include "base/random.h"
#include "delaunay/delaunay_check2d.h"
#include "delaunay/mesh_hash2d.h"
#include "delaunay/replay2d.h"
#include "predicates/coordinate_range.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mesher::test {
namespace {

struct Options
{
    std::uint64_t operations = 20000;
    std::uint64_t seed = 1;
    std::uint64_t checkEvery = 50;
    std::string log;
};

std::optional<Options> parseOptions(int count, char** words)
{
    Options options;
    for (int i = 1; i + 1 < count; i += 2) {
        const std::string_view name = words[i];
        if (name == "--log")
            options.log = words[i + 1];
        else if (name == "--operations")
            options.operations = std::strtoull(words[i + 1], nullptr, 10);
        else if (name == "--seed")
            options.seed = std::strtoull(words[i + 1], nullptr, 10);
        else if (name == "--check-every")
            options.checkEvery = std::strtoull(words[i + 1], nullptr, 10);
        else
            return std::nullopt;
    }
    if (count % 2 == 0 || options.checkEvery == 0) return std::nullopt;
    return options;
}

class Fuzzer
{
public:
    explicit Fuzzer(const Options& options) : options_(options), random_(options.seed)
    {
        if (!options.log.empty()) log_.open(options.log);
    }

    /// What went wrong, or nothing.
    std::string run()
    {
        for (done_ = 0; done_ < options_.operations; ++done_) {
            step();
            if (done_ % options_.checkEvery != 0) continue;
            const CheckReport report = checkDelaunay2d(mesh());
            if (!report.isValid()) return report.problem;
            if (done_ % (16 * options_.checkEvery) == 0 && !isReproducible()) {
                return "built anew from its vertices and constraints the triangulation differs";
            }
        }
        return "";
    }

    [[nodiscard]] std::uint64_t operationsDone() const { return done_; }
    [[nodiscard]] const Delaunay2dCounters& counters() const { return replayer_.delaunay().counters(); }

private:
    [[nodiscard]] const Triangulation2d& mesh() const { return replayer_.delaunay().mesh(); }

    void step()
    {
        // The number of vertices swings between none and a few hundred; beyond, constraints are given free as well, or
        // the vertices they hold would only become more.
        constexpr std::size_t kMany = 500;
        const double phase = std::sin(static_cast<double>(done_) * 0.0007);
        const bool isCrowded = labels_.size() > kMany;
        const std::uint32_t insertBelow = isCrowded ? 5 : static_cast<std::uint32_t>(42.0 + 30.0 * phase);
        const std::uint32_t constrainBelow = isCrowded ? 60 : 95;
        const std::uint32_t removeBelow = isCrowded ? 59 : 84;
        const std::uint32_t dice = random_.below(100);
        if (labels_.empty() || dice < insertBelow)
            insert();
        else if (dice < removeBelow)
            remove();
        else if (dice < constrainBelow)
            constrain();
        else if (dice < 98)
            unconstrain();
        else
            abandonCavity();
    }

    void apply(const ReplayOperation& operation)
    {
        if (log_.is_open()) log_ << ReplayLog({operation}).toText() << std::flush;
        replayer_.apply(operation);
    }

    void insert()
    {
        const std::uint32_t label = nextLabel_++;
        apply(ReplayOperation::insert(label, randomPoint()));
        labels_.push_back(label);
    }

    void remove()
    {
        const std::size_t i = randomIndex();
        const bool joins = random_.below(2) == 0;
        const std::uint32_t label = labels_[i];
        apply(ReplayOperation::on(joins ? ReplayKind::RemoveFromChain : ReplayKind::Remove, {label}));
        if (replayer_.vertexOf(label).isValid()) return;
        labels_[i] = labels_.back();
        labels_.pop_back();
    }

    void constrain()
    {
        // Long segments would nearly all cross others: the nearest of some vertices is drawn as the other end.
        const std::uint32_t from = labels_[randomIndex()];
        std::uint32_t to = labels_[randomIndex()];
        for (std::uint32_t tries = random_.below(20); tries > 0; --tries) {
            const std::uint32_t other = labels_[randomIndex()];
            if (other != from && distance(from, other) < distance(from, to)) to = other;
        }
        apply(ReplayOperation::on(ReplayKind::Constrain, {from, to}));
    }

    [[nodiscard]] double distance(std::uint32_t a, std::uint32_t b) const
    {
        const VertexId from = replayer_.vertexOf(a);
        const VertexId to = replayer_.vertexOf(b);
        if (!from.isValid() || !to.isValid() || from == to) return std::numeric_limits<double>::infinity();
        return length(mesh().position(from) - mesh().position(to));
    }

    void unconstrain()
    {
        const std::uint32_t label = labels_[randomIndex()];
        const VertexId vertex = replayer_.vertexOf(label);
        if (!vertex.isValid() || mesh().triangleCount() == 0) return;
        for (const std::uint32_t other : labels_) {
            const VertexId end = replayer_.vertexOf(other);
            if (!end.isValid() || end == vertex) continue;
            const EdgeLink edge = mesh().findEdge(vertex, end);
            if (!edge.isValid() || !mesh().isConstrained(edge)) continue;
            apply(ReplayOperation::on(ReplayKind::Unconstrain, {label, other}));
            return;
        }
    }

    void abandonCavity()
    {
        const Vec2 p = randomPoint();
        const Location2d location = replayer_.delaunay().locate(p);
        if (location.kind == Location2d::Kind::NoTriangles || location.kind == Location2d::Kind::OnVertex)
            return;
        replayer_.delaunay().findCavity(p, location, cavity_);
    }

    Vec2 randomPoint()
    {
        const auto lattice = [this](std::uint32_t size) { return static_cast<double>(random_.below(size)); };
        switch (random_.below(8)) {
            case 0: return {random_.between(0.0, 16.0), random_.between(0.0, 16.0)};
            case 1: return {random_.between(-1e6, 1e6), random_.between(-1e6, 1e6)};
            case 2: return {lattice(17) * 0x1p-40 + 8.0, lattice(17) * 0x1p-40 + 8.0};
            case 3: return nearVertex();
            case 4: return onEdge();
            case 5: return {lattice(17), 4.0};
            default: return {lattice(17), lattice(17)};
        }
    }

    /// A vertex, or one unit in the last place beside it; the units beside 0 are out of the exact range.
    Vec2 nearVertex()
    {
        const VertexId vertex = labels_.empty() ? VertexId() : replayer_.vertexOf(labels_[randomIndex()]);
        if (!vertex.isValid()) return {};
        Vec2 p = mesh().position(vertex);
        if (random_.below(3) != 0) p.x = std::nextafter(p.x, 20.0);
        if (random_.below(3) != 0) p.y = std::nextafter(p.y, -20.0);
        return isInExactRange(p) ? p : mesh().position(vertex);
    }

    /// The rounded midpoint of an edge: exactly on it on the lattice.
    Vec2 onEdge()
    {
        if (mesh().triangleCount() == 0) return {3.0, 3.0};
        for (;;) {
            const TriangleId t(random_.below(static_cast<std::uint32_t>(mesh().triangleSlots())));
            if (!mesh().isAlive(t) || mesh().triangle(t).isGhost()) continue;
            const EdgeLink edge(t, random_.below(3));
            return 0.5 * (mesh().position(mesh().edgeFrom(edge)) + mesh().position(mesh().edgeTo(edge)));
        }
    }

    std::size_t randomIndex() { return random_.below(static_cast<std::uint32_t>(labels_.size())); }

    [[nodiscard]] bool isReproducible() const
    {
        std::vector<Vec2> points;
        for (std::uint32_t i = 0; i < mesh().vertexSlots(); ++i) {
            if (mesh().isAlive(VertexId(i))) points.push_back(mesh().position(VertexId(i)));
        }
        Delaunay2d anew;
        if (!anew.insertPoints(points)) return false;
        for (std::uint32_t i = 0; i < mesh().triangleSlots(); ++i) {
            const TriangleId t(i);
            if (!mesh().isAlive(t)) continue;
            for (unsigned side = 0; side < 3; ++side) {
                const EdgeLink edge(t, side);
                if (!mesh().isConstrained(edge)) continue;
                const auto from = anew.insert(mesh().position(mesh().edgeFrom(edge)));
                const auto to = anew.insert(mesh().position(mesh().edgeTo(edge)));
                if (!anew.recoverSegment(from->vertex, to->vertex)) return false;
            }
        }
        return meshHash2d(anew.mesh()) == meshHash2d(mesh());
    }

    Options options_;
    Random random_;
    Replayer2d replayer_;
    std::vector<std::uint32_t> labels_;
    std::uint32_t nextLabel_ = 0;
    std::uint64_t done_ = 0;
    Cavity2d cavity_;
    std::ofstream log_;
};

}  // namespace
}  // namespace mesher::test

int main(int count, char** words)
{
    using namespace mesher;
    const auto options = test::parseOptions(count, words);
    if (!options) {
        std::cerr << "usage: delaunay2d_fuzz [--operations N] [--seed S] [--check-every K] [--log FILE]\n";
        return 2;
    }
    test::Fuzzer fuzzer(*options);
    const std::string problem = fuzzer.run();
    if (!problem.empty()) {
        std::cerr << "after " << fuzzer.operationsDone() << " operations: " << problem << '\n';
        return 1;
    }
    const Delaunay2dCounters& done = fuzzer.counters();
    std::cout << done.insertions << " insertions, " << done.duplicates << " duplicates, " << done.removals
              << " removals, " << done.segments << " segments, " << done.flips << " flips, "
              << done.starRepairs << " star repairs\n";
    return done.starRepairs == 0 ? 0 : 1;
}
