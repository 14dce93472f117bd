#include "brep/face_area.h"

#include "brep/face_integral.h"

#include <cmath>

namespace mesher {

double areaOf(const BrepModel& model, const BrepFace& face)
{
    return std::abs(
        faceIntegral(model, face, [](const SurfacePoint& point) { return length(point.normal()); }));
}

}  // namespace mesher
