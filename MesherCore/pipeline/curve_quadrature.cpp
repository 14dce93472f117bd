#include "pipeline/curve_quadrature.h"

#include "base/assert.h"

#include <cmath>

namespace mesher {

namespace {

/// Abscissa in [-1, 1] and its weight.
struct GaussNode
{
    double abscissa;
    double weight;
};

std::vector<GaussNode> gaussRule(int order)
{
    if (order <= 2) return {{0.0, 2.0}};
    const double third = 1.0 / std::sqrt(3.0);
    return {{-third, 1.0}, {third, 1.0}};
}

}  // namespace

std::vector<CurvedBoundaryPoint> gaussPointsOn(const Curve& curve, Interval part, const Vec3& planeNormal,
                                               int order)
{
    MESHER_PRECONDITION(order >= 2 && order <= 4);
    std::vector<CurvedBoundaryPoint> points;
    for (const GaussNode& node : gaussRule(order)) {
        CurvedBoundaryPoint point;
        point.parameter = part.at(0.5 * (1.0 + node.abscissa));
        const CurvePoint place = curve.evaluate(point.parameter);
        const double speed = length(place.d1);
        point.position = place.position;
        point.weight = 0.5 * std::abs(part.length()) * node.weight * speed;
        if (speed > 0.0) {
            point.normal = (1.0 / speed) * cross(place.d1, planeNormal);
            point.curvature = dot(cross(place.d1, place.d2), planeNormal) / (speed * speed * speed);
        }
        points.push_back(point);
    }
    return points;
}

void placeGaussPoints(const Curve& curve, const Vec3& planeNormal, int order, CurvedBoundaryEdge& edge)
{
    const Interval whole = {edge.parameter[0], edge.parameter[1]};
    const double middle = whole.at(0.5);
    edge.points = gaussPointsOn(curve, whole, planeNormal, order);
    edge.halves[0] = gaussPointsOn(curve, {whole.first, middle}, planeNormal, order);
    edge.halves[1] = gaussPointsOn(curve, {middle, whole.last}, planeNormal, order);
}

}  // namespace mesher
