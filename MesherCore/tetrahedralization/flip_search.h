#pragma once

#include "delaunay/flips3d.h"
#include "delaunay/tet_replacement3d.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mesher {

/// Flips that are tried out: made one after the other, and taken back in the reverse order if they lead nowhere.
/// Guarantees   constrained edges and faces stay; what is taken back is as before, ids of tetrahedra included, as long as
///              nobody else changes the mesh in between
class FlipSearch
{
public:
    explicit FlipSearch(Triangulation3d& mesh) : mesh_(mesh), replacement_(mesh) {}

    /// The place to come back to.
    [[nodiscard]] std::size_t mark() const { return log_.size(); }
    void takeBackTo(std::size_t mark);
    /// Forgets how to take back.
    void accept() { log_.clear(); }

    /// Limits the edge removals tried until the next call.
    void allowTrials(std::uint32_t trials) { trials_ = trials; }

    bool flipFace(TetFace face);
    /// Removes the edge by the flips of its ring whose worst tetrahedron is best; if that fails, removes up to `depth` levels
    /// of edges beside it first. True if the edge is gone; if not, nothing is changed.
    /// Reference  [si2015] section 3 has the idea of removing edges that lock an edge
    /// Requires   `at` has the edge, or is invalid: then it is looked for
    bool removeEdge(VertexId a, VertexId b, TetId at, int depth, const TetMeasure& measure);

    /// Any other replacement, with the vertices that were added for it: these are removed if it is taken back.
    void replace(std::span<const TetId> before, std::span<const TetCorners> after,
                 std::span<const VertexId> added);

    /// Flips made and not taken back.
    [[nodiscard]] std::uint64_t flips() const { return flips_; }

private:
    struct Step
    {
        std::vector<TetCorners> before;
        std::vector<TetId> created;
        std::vector<VertexId> added;
    };

    void apply(const Flip3d& flip);
    bool removeRing(VertexId a, VertexId b, std::span<const TetId> likely, const TetMeasure& measure);
    [[nodiscard]] TetId findEdge(VertexId a, VertexId b, std::span<const TetId> likely) const;
    bool shrinkRing(VertexId a, VertexId b);

    Triangulation3d& mesh_;
    TetReplacement3d replacement_;
    std::vector<Step> log_;
    std::uint32_t trials_ = 0;
    std::uint64_t flips_ = 0;
};

/// Six volumes over the cube of the longest edge: cheap, and good enough to keep slivers out of flips.
[[nodiscard]] double flatness(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace mesher
