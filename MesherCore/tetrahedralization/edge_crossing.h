#pragma once

#include "delaunay/triangulation3d.h"

#include <array>
#include <vector>

namespace mesher {

/// What a line from vertex to vertex passes through on its way.
struct EdgeCrossing
{
    enum class Kind : std::uint8_t
    {
        Face,   ///< the inside of `face`
        Edge,   ///< the inside of the edge (vertex[0], vertex[1]) of face.tet()
        Vertex  ///< vertex[0]: nothing behind it is listed
    };

    Kind kind = Kind::Face;
    TetFace face;
    /// Corners of the face in any order, ends of the edge, or the vertex; the others invalid.
    std::array<VertexId, 3> vertex;
};

/// Follows the line between two vertices through a tetrahedralization, exactly.
class EdgeCrossings
{
public:
    explicit EdgeCrossings(const Triangulation3d& mesh) : mesh_(mesh) {}

    /// Fills `crossings` in order from `a` to `b`; nothing if they are joined by an edge.
    /// Requires  the open segment inside of the hull
    /// Cost      the star of `a` and the tetrahedra passed
    void find(VertexId a, VertexId b, std::vector<EdgeCrossing>& crossings);

private:
    struct Candidate
    {
        TetId tet;
        int face;
    };

    void listCandidates(const EdgeCrossing& at);
    [[nodiscard]] bool hit(TetFace face, EdgeCrossing& crossing) const;
    [[nodiscard]] static bool isSame(const EdgeCrossing& first, const EdgeCrossing& second);

    const Triangulation3d& mesh_;
    VertexId from_;
    VertexId to_;
    std::vector<Candidate> candidates_;
    std::vector<TetId> tets_;
};

/// The share of `part` in `whole`, from 0 to 1; one half if these do not say.
[[nodiscard]] double clampedShare(double part, double whole);

/// The point where the line from `a` to `b` passes the crossing, rounded.
[[nodiscard]] Vec3 crossingPoint(const Triangulation3d& mesh, VertexId a, VertexId b,
                                 const EdgeCrossing& crossing);

}  // namespace mesher
