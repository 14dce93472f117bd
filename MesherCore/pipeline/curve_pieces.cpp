#include "pipeline/curve_pieces.h"

#include <algorithm>

namespace mesher {

namespace {

constexpr int kPiecesBetweenKnots = 64;

double curvatureOf(const CurvePoint& point)
{
    const double speed = length(point.d1);
    return speed > 0.0 ? length(cross(point.d1, point.d2)) / (speed * speed * speed) : 0.0;
}

}  // namespace

std::vector<CurvePiece> piecesOf(const Curve& curve, Interval part)
{
    std::vector<double> cuts = {part.first};
    for (const double knot : curve.knots()) {
        if (knot > part.first && knot < part.last) cuts.push_back(knot);
    }
    cuts.push_back(part.last);
    std::vector<CurvePiece> pieces;
    CurvePoint before = curve.evaluate(part.first);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const Interval between = {cuts[i], cuts[i + 1]};
        for (int k = 1; k <= kPiecesBetweenKnots; ++k) {
            const CurvePoint here = curve.evaluate(between.at(static_cast<double>(k) / kPiecesBetweenKnots));
            pieces.push_back(
                {before.position, here.position, std::max(curvatureOf(before), curvatureOf(here))});
            before = here;
        }
    }
    return pieces;
}

}  // namespace mesher
