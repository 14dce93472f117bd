#include "refinement/facet_swap3d.h"

#include "delaunay/facet_flip3d.h"

#include <algorithm>
#include <cmath>

namespace mesher {

/// The edge between exactly two facets that may be swapped.
std::optional<FacetSwap3d::Diagonal> FacetSwap3d::diagonalAt(VertexId a, VertexId b)
{
    const Triangulation3d& mesh = state_.mesh;
    const TetId start = mesh.findEdge(a, b);
    if (!start.isValid() || state_.segmentAt(a, b) != nullptr) return std::nullopt;
    mesh.collectEdgeRing(start, a, b, ring_);
    Diagonal diagonal{{a, b}, {}, {}};
    std::size_t count = 0;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
        const TetId next = ring_[(i + 1) % ring_.size()];
        for (int face = 0; face < 4; ++face) {
            if (mesh.neighbour(ring_[i], face).tet() != next || !mesh.isFaceConstrained({ring_[i], face}))
                continue;
            const auto corners = mesh.faceVertices({ring_[i], face});
            const auto apex =
                std::find_if(corners.begin(), corners.end(), [&](VertexId v) { return v != a && v != b; });
            const FacetId* facet = state_.facetAt({ring_[i], face});
            if (facet == nullptr || count == 2) return std::nullopt;
            diagonal.apex[count] = *apex;
            diagonal.facet[count++] = *facet;
        }
    }
    if (count != 2 || !state_.splitter.maySwap(diagonal.facet[0], diagonal.facet[1])) return std::nullopt;
    return diagonal;
}

/// Of the fourth corner above the other three, as a share of the diagonal.
double FacetSwap3d::heightOf(const Diagonal& diagonal) const
{
    const auto position = [&](VertexId v) { return state_.mesh.position(v); };
    const Vec3 origin = position(diagonal.end[0]);
    const Vec3 along = position(diagonal.end[1]) - origin;
    const Vec3 normal = cross(along, position(diagonal.apex[0]) - origin);
    return std::abs(dot(normal, position(diagonal.apex[1]) - origin)) / (length(normal) * length(along));
}

/// The tetrahedron of the four corners, if there is one.
TetId FacetSwap3d::sliverAt(const Diagonal& diagonal) const
{
    for (const TetId tet : ring_) {
        if (state_.mesh.slotOf(tet, diagonal.apex[0]) >= 0 && state_.mesh.slotOf(tet, diagonal.apex[1]) >= 0)
            return tet;
    }
    return {};
}

bool FacetSwap3d::swapAt(TetFace face, double mostHeight)
{
    const Triangulation3d& mesh = state_.mesh;
    changed_.clear();
    const auto corner = mesh.faceVertices(face);
    const TetFace other = mesh.neighbour(face);
    const std::array<VertexId, 2> apices{mesh.vertex(face.tet(), face.face()),
                                         mesh.vertex(other.tet(), other.face())};
    for (unsigned k = 0; k < 3; ++k) {
        const std::optional<Diagonal> diagonal = diagonalAt(corner[k], corner[(k + 1) % 3]);
        if (!diagonal || !std::is_permutation(apices.begin(), apices.end(), diagonal->apex.begin())) continue;
        if (!(heightOf(*diagonal) <= mostHeight)) continue;
        return swapWhatIsThere(*diagonal) || (clearOutside(*diagonal) && swapWhatIsThere(*diagonal));
    }
    return false;
}

/// Nothing of the surface is on the other two faces of the tetrahedron of the four corners, nor on the edge between them: in
/// walls and at sharp edges they can be facets of another face.
bool FacetSwap3d::isFreeBehind(TetId sliver, const Diagonal& diagonal) const
{
    const Triangulation3d& mesh = state_.mesh;
    const int edge =
        kEdgeOfSlots[mesh.slotOf(sliver, diagonal.apex[0])][mesh.slotOf(sliver, diagonal.apex[1])];
    return !mesh.isEdgeConstrained(sliver, edge) &&
           std::none_of(diagonal.end.begin(), diagonal.end.end(), [&](VertexId end) {
               return mesh.isFaceConstrained({sliver, mesh.slotOf(sliver, end)});
           });
}

/// Four tetrahedra around the diagonal, or that of the four corners among them.
bool FacetSwap3d::swapWhatIsThere(const Diagonal& diagonal)
{
    const TetId sliver = sliverAt(diagonal);
    if (!sliver.isValid()) return flipFlat(diagonal);
    if (!isFreeBehind(sliver, diagonal)) return false;
    giveToOtherSide(sliver, diagonal);
    return true;
}

/// Outside of the solids nothing has to be Delaunay.
bool FacetSwap3d::clearOutside(const Diagonal& diagonal)
{
    const auto centre = clearBesideEdge(state_.mesh, diagonal.end, kExteriorRegion);
    if (!centre) return false;
    state_.addOutside(*centre);
    ++state_.counts.outsideVertices;
    state_.mesh.collectEdgeRing(state_.mesh.findEdge(diagonal.end[0], diagonal.end[1]), diagonal.end[0],
                                diagonal.end[1], ring_);
    return true;
}

bool FacetSwap3d::expel(TetId tet, double mostHeight)
{
    const Triangulation3d& mesh = state_.mesh;
    changed_.clear();
    if (!state_.isMeshed(tet)) return false;
    for (int edge = 0; edge < 6; ++edge) {
        const int first = kEdgeSlots[5 - edge][0];
        const int second = kEdgeSlots[5 - edge][1];
        const TetFace faces[2] = {{tet, first}, {tet, second}};
        const bool isBetweenFacets = std::all_of(std::begin(faces), std::end(faces), [&](TetFace face) {
            return mesh.isFaceConstrained(face) && mesh.region(mesh.neighbour(face).tet()) == kExteriorRegion;
        });
        if (!isBetweenFacets) continue;
        const auto diagonal =
            diagonalAt(mesh.vertex(tet, kEdgeSlots[edge][0]), mesh.vertex(tet, kEdgeSlots[edge][1]));
        if (!diagonal || !(heightOf(*diagonal) <= mostHeight) || !isFreeBehind(tet, *diagonal)) continue;
        giveToOtherSide(tet, *diagonal);
        return true;
    }
    return false;
}

/// The four tetrahedra around the diagonal, two on either side, where all four corners lie exactly in one plane.
bool FacetSwap3d::flipFlat(const Diagonal& diagonal)
{
    if (!flipFacetPair(state_.mesh, diagonal.end, diagonal.apex, changed_)) return false;
    swapOnSurface(diagonal);
    return true;
}

/// What was behind two of its faces is then behind the other two, which become the facets.
void FacetSwap3d::giveToOtherSide(TetId sliver, const Diagonal& diagonal)
{
    Triangulation3d& mesh = state_.mesh;
    if (heightOf(diagonal) > kNearlyPlane) ++state_.counts.bentSwaps;
    for (const VertexId end : diagonal.end) mesh.setFaceConstrained({sliver, mesh.slotOf(sliver, end)}, true);
    for (const VertexId apex : diagonal.apex) {
        const TetFace face(sliver, mesh.slotOf(sliver, apex));
        mesh.setFaceConstrained(face, false);
        mesh.setRegion(sliver, mesh.region(mesh.neighbour(face).tet()));
    }
    swapOnSurface(diagonal);
    changed_.push_back(sliver);
    for (int face = 0; face < 4; ++face) changed_.push_back(mesh.neighbour(sliver, face).tet());
}

void FacetSwap3d::swapOnSurface(const Diagonal& diagonal)
{
    const auto keyOf = [](VertexId a, VertexId b, VertexId c) {
        std::array<VertexId, 3> key{a, b, c};
        std::sort(key.begin(), key.end());
        return key;
    };
    for (const VertexId apex : diagonal.apex)
        state_.t.facetOf.erase(keyOf(diagonal.end[0], diagonal.end[1], apex));
    for (const FacetId added : state_.splitter.swap(diagonal.facet[0], diagonal.facet[1])) {
        const auto [a, b, c] = state_.cornersOf(added);
        state_.t.facetOf.insertOrAssign(keyOf(a, b, c), added);
    }
    ++state_.counts.facetSwaps;
}

}  // namespace mesher
