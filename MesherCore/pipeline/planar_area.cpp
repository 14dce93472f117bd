#include "pipeline/planar_area.h"

#include <array>
#include <vector>

namespace mesher {

namespace {

constexpr int kPanels = 16;
/// Abscissae in [-1, 1] and weights of the Gauss rule of five points.
constexpr std::array<double, 5> kAbscissa = {-0.9061798459386640, -0.5384693101056831, 0.0,
                                             0.5384693101056831, 0.9061798459386640};
constexpr std::array<double, 5> kWeight = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                           0.4786286704993665, 0.2369268850561891};

/// Integral of p x dp / 2 over a curve in the complex's plane.
double sweptArea(const PlanarCurveComplex& complex, const PccCurve& curve)
{
    std::vector<double> cuts = {curve.part.first};
    for (const double knot : curve.curve->knots()) {
        if (knot > curve.part.first && knot < curve.part.last) cuts.push_back(knot);
    }
    cuts.push_back(curve.part.last);
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double width = (cuts[i + 1] - cuts[i]) / kPanels;
        for (int panel = 0; panel < kPanels; ++panel) {
            const double middle = cuts[i] + (panel + 0.5) * width;
            for (std::size_t k = 0; k < kAbscissa.size(); ++k) {
                const CurvePoint point = curve.curve->evaluate(middle + 0.5 * width * kAbscissa[k]);
                sum += 0.25 * width * kWeight[k] *
                       cross(complex.frame.toPlane(point.position), complex.frame.directionToPlane(point.d1));
            }
        }
    }
    return sum;
}

}  // namespace

double planarArea(const PlanarCurveComplex& complex)
{
    double area = 0.0;
    for (const PccCurve& curve : complex.curves) {
        const bool isLeftMeshed = curve.left.value != 0;
        if (isLeftMeshed == (curve.right.value != 0)) continue;
        area += (isLeftMeshed ? 1.0 : -1.0) * sweptArea(complex, curve);
    }
    return area;
}

}  // namespace mesher
