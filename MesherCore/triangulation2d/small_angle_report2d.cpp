#include "triangulation2d/small_angle_report2d.h"

#include <algorithm>
#include <map>
#include <utility>

namespace mesher {

std::vector<TrianglesBesideAngle2d> trianglesBesideSmallAngles(const PlanarResult& result)
{
    std::map<std::pair<SmallAngleId, std::uint32_t>, TrianglesBesideAngle2d> byAngle;
    const PlanarTriangulation& t = result.triangulation;
    for (const LeftTriangle2d& left : result.refinement.left) {
        if (left.reason != LeftReason2d::SmallInputAngle) continue;
        const SmallAngleComplex& complex = t.smallAngles.complexes[left.smallAngle];
        TrianglesBesideAngle2d& beside = byAngle[{left.smallAngle, left.inputAngle}];
        beside.angle = complex.angles[left.inputAngle];
        beside.apex = (1.0 / t.scale) * t.boundary.position(complex.apex);
        ++beside.triangles;
        beside.smallestAngle = std::min(beside.smallestAngle, left.smallestAngle);
        beside.largestAngle = std::max(beside.largestAngle, left.largestAngle);
    }
    std::vector<TrianglesBesideAngle2d> list;
    for (const auto& [key, beside] : byAngle) list.push_back(beside);
    return list;
}

}  // namespace mesher
