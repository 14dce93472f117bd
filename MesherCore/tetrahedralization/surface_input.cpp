#include "tetrahedralization/surface_input.h"

#include "base/indexed_map.h"
#include "predicates/orient2d.h"

#include <algorithm>

namespace mesher {

namespace {

bool areCollinear(const Vec3& a, const Vec3& b, const Vec3& c)
{
    return orient2d({a.x, a.y}, {b.x, b.y}, {c.x, c.y}) == Sign::Zero &&
           orient2d({a.y, a.z}, {b.y, b.z}, {c.y, c.z}) == Sign::Zero &&
           orient2d({a.x, a.z}, {b.x, b.z}, {c.x, c.z}) == Sign::Zero;
}

Error badFacet(const SurfaceFacet& facet, const std::string& message, const Vec3& point)
{
    return {ErrorCode::DegenerateInput, message, nameOf(facet.face), point,
            "sample the face again, or repair it"};
}

Result<void> checkSegments(const SurfaceMesh& surface)
{
    for (const SurfaceSegment& segment : surface.segments) {
        if (!segment.isAlive()) continue;
        const bool isInRange =
            segment.node[0].value < surface.nodes.size() && segment.node[1].value < surface.nodes.size();
        if (isInRange && segment.node[0] != segment.node[1]) continue;
        return Error{
            ErrorCode::InvalidArgument, "a segment does not join two nodes", nameOf(segment.edge), {}, {}};
    }
    return {};
}

}  // namespace

Result<void> checkSurfaceInput(const SurfaceMesh& surface, const RegionSides& sides)
{
    IndexedMap<std::array<NodeId, 3>, BrepFaceId> faceOf;
    faceOf.reserve(surface.facets.size());
    for (const SurfaceFacet& facet : surface.facets) {
        if (!facet.isAlive()) continue;
        if (facet.face.value >= sides.size()) {
            return Error{
                ErrorCode::InvalidArgument, "no regions are given for the face", nameOf(facet.face), {}, {}};
        }
        for (const NodeId node : facet.node) {
            if (node.value < surface.nodes.size()) continue;
            return Error{
                ErrorCode::InvalidArgument, "a facet has an unknown node", nameOf(facet.face), {}, {}};
        }
        const Vec3& a = surface.nodes[facet.node[0]].position;
        if (areCollinear(a, surface.nodes[facet.node[1]].position, surface.nodes[facet.node[2]].position))
            return badFacet(facet, "the corners of a facet lie on one line", a);
        auto key = facet.node;
        std::sort(key.begin(), key.end());
        const auto [other, isNew] = faceOf.insert(key, facet.face);
        if (isNew) continue;
        Error error = badFacet(facet, "two facets have the same corners", a);
        error.entity = nameOf(*other) + " and " + nameOf(facet.face);
        error.code = ErrorCode::IntersectingConstraints;
        return error;
    }
    return checkSegments(surface);
}

}  // namespace mesher
