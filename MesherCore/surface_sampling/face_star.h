#pragma once

#include "base/vec.h"
#include "surface_sampling/face_mesh.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace mesher {

/// How far the star of a new vertex reaches.
enum class StarExtent : std::uint8_t
{
    Delaunay,  ///< over all edges that would not be locally Delaunay beside it
    Least      ///< the triangle, or the two of the side, that it lies on
};

/// New triangles may be off the surface's normals by 60 degrees, or as much as those they replace.
inline constexpr double kUprightAgreement = 0.5;
/// The same where nothing else helps: off by 89 degrees, still on the surface's side.
inline constexpr double kSteepAgreement = 0.02;

/// A side of the polygon that the star of a new vertex fills; the star's triangles are new vertex, a, b.
struct StarSide
{
    VertexId a;
    VertexId b;
    Vec2 uvA;
    Vec2 uvB;
    Vec2 uvVertex;   ///< of the new vertex, in the same image
    EdgeLink outer;  ///< invalid at the border of the face
    SegmentId segment;
};

/// The insertion of a vertex into the mesh of a face, evaluated and not yet made: the flips by which Lawson would restore the
/// Delaunay property around the new vertex all remove edges of one polygon, which grows here without touching the mesh.
/// Guarantees   the polygon is simple, segments are not crossed, a star that is not `isFolded` looks to the surface's side
///              as well as the triangles it replaces or better than 60 degrees; commit cannot fail
/// Cost         proportional to the star
/// Reference    [lawson1977]; [chew1993] for the test of edges on a curved surface by opposite angles
class FaceStar
{
public:
    FaceStar(FaceMesh& mesh, const FaceGeometry& geometry) : mesh_(mesh), geometry_(geometry) {}

    /// Of a vertex inside of a triangle; the parameters in the triangle's image.
    void evaluateInside(TriangleId t, const FaceVertex& vertex, Vec2 uv, StarExtent extent);
    /// Of a vertex on a side; the parameters in the image of the side's triangle. If the side is a segment, `halves` are what
    /// it becomes: from its start to the vertex, and on to its end. `uvBehind` are the parameters in the image of the triangle
    /// behind a seam; without them it is brought to the same image.
    void evaluateOnSide(EdgeLink side, const FaceVertex& vertex, Vec2 uv, StarExtent extent,
                        const std::array<SegmentId, 2>& halves, std::optional<Vec2> uvBehind = {});

    [[nodiscard]] const std::vector<StarSide>& sides() const { return sides_; }
    [[nodiscard]] const std::vector<TriangleId>& cavity() const { return cavity_; }
    [[nodiscard]] const FaceVertex& vertex() const { return vertex_; }
    /// In the image of the triangle it was evaluated in.
    [[nodiscard]] Vec2 parameters() const { return uv_; }
    [[nodiscard]] bool isClosed() const { return isClosed_; }
    /// Looks a triangle of the star away from the surface, by more than those that it replaces?
    [[nodiscard]] bool isFolded(double leastAgreement = kUprightAgreement) const;
    /// To the nearest corner of the polygon.
    [[nodiscard]] double squaredSpokeLength() const;

    /// Requires   the mesh as it was evaluated
    VertexId commit();
    /// The triangles of the star that was committed last.
    [[nodiscard]] const std::vector<TriangleId>& made() const { return made_; }

private:
    struct Spoke
    {
        std::size_t at =
            0;  ///< before this side of the polygon; the number of sides at the end of an open fan
        SegmentId segment;
    };

    void begin(const FaceVertex& vertex, Vec2 uv, StarExtent extent);
    void addTriangle(TriangleId t);
    [[nodiscard]] StarSide sideOf(TriangleId t, unsigned side, Vec2 shift, Vec2 uvVertex) const;
    [[nodiscard]] Vec2 shiftBehind(const StarSide& side) const;
    void grow(const StarSide& side);
    [[nodiscard]] bool isToBeRemoved(const StarSide& side) const;
    [[nodiscard]] bool isOnPolygon(VertexId v) const;

    FaceMesh& mesh_;
    const FaceGeometry& geometry_;
    FaceVertex vertex_;
    Vec2 uv_;
    StarExtent extent_ = StarExtent::Delaunay;
    bool isClosed_ = true;
    std::vector<TriangleId> cavity_;
    std::vector<StarSide> sides_;
    std::vector<StarSide> open_;  ///< sides still to be looked at, the next one last
    std::array<Spoke, 2> spokes_;
    std::vector<TriangleId> made_;
};

}  // namespace mesher
