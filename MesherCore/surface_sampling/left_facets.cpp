#include "surface_sampling/left_facets.h"

#include "quality/triangle_measures.h"
#include "surface_sampling/sampled_faces.h"

#include <algorithm>
#include <array>

namespace mesher {
namespace {

/// Degrees: an angle that is smaller by no more than rounding is none.
constexpr double kSlack = 1e-6;

constexpr std::size_t kReasons = static_cast<std::size_t>(FacetLeft::Resolution) + 1;

void addFacet(const FaceMesh& mesh, TriangleId t, double minAngle, std::array<LeftFacets, kReasons>& found)
{
    const FaceTriangle& record = mesh.triangle(t);
    const std::array<Vec3, 3> corners = {mesh.position(record.v[0]), mesh.position(record.v[1]),
                                         mesh.position(record.v[2])};
    const TriangleShape shape = shapeOf(corners);
    if (shape.minAngle >= minAngle - kSlack) return;
    const FacetLeft reason = record.left == FacetLeft::No ? FacetLeft::Resolution : record.left;
    LeftFacets& left = found[static_cast<std::size_t>(reason)];
    ++left.count;
    left.reason = reason;
    left.largestAngle = std::max(left.largestAngle, shape.maxAngle);
    if (shape.minAngle >= left.leastAngle) return;
    left.leastAngle = shape.minAngle;
    left.worst = (1.0 / 3.0) * (corners[0] + corners[1] + corners[2]);
}

}  // namespace

std::vector<LeftFacets> leftFacets(const SampledFaces& faces)
{
    std::vector<LeftFacets> all;
    for (std::uint32_t f = 0; f < faces.model().faces.size(); ++f) {
        const SampledFace* face = faces.face(BrepFaceId(f));
        if (face == nullptr) continue;
        std::array<LeftFacets, kReasons> found;
        const double minAngle = face->refiner.minAngle();
        for (std::uint32_t i = 0; i < face->mesh.triangleSlots(); ++i) {
            if (face->mesh.triangle(TriangleId(i)).isAlive)
                addFacet(face->mesh, TriangleId(i), minAngle, found);
        }
        for (LeftFacets& left : found) {
            left.face = BrepFaceId(f);
            if (left.count > 0) all.push_back(left);
        }
    }
    return all;
}

}  // namespace mesher
