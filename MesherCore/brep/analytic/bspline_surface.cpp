#include "brep/analytic/bspline_surface.h"

#include "base/assert.h"
#include "brep/analytic/bspline_basis.h"

#include <utility>

namespace mesher {

namespace {

/// A value with its derivatives by both parameters; of points and of weights alike.
template <class T>
struct Jet
{
    T value{};
    T du{};
    T dv{};
    T duu{};
    T duv{};
    T dvv{};
};

/// The row of poles of one u, summed over v.
template <class T>
struct Row
{
    T value{};
    T d1{};
    T d2{};

    void add(const BSplineBasis& basis, std::size_t j, const T& pole)
    {
        value = value + basis.value[j] * pole;
        d1 = d1 + basis.d1[j] * pole;
        d2 = d2 + basis.d2[j] * pole;
    }
};

template <class T>
void add(Jet<T>& jet, const BSplineBasis& basis, std::size_t i, const Row<T>& row)
{
    jet.value = jet.value + basis.value[i] * row.value;
    jet.du = jet.du + basis.d1[i] * row.value;
    jet.dv = jet.dv + basis.value[i] * row.d1;
    jet.duu = jet.duu + basis.d2[i] * row.value;
    jet.duv = jet.duv + basis.d1[i] * row.d1;
    jet.dvv = jet.dvv + basis.value[i] * row.d2;
}

/// The quotient of the homogeneous point by its weight.
SurfacePoint divide(const Jet<Vec3>& p, const Jet<double>& w)
{
    const double inverse = 1.0 / w.value;
    SurfacePoint s;
    s.position = inverse * p.value;
    s.du = inverse * (p.du - w.du * s.position);
    s.dv = inverse * (p.dv - w.dv * s.position);
    s.duu = inverse * (p.duu - 2.0 * w.du * s.du - w.duu * s.position);
    s.duv = inverse * (p.duv - w.du * s.dv - w.dv * s.du - w.duv * s.position);
    s.dvv = inverse * (p.dvv - 2.0 * w.dv * s.dv - w.dvv * s.position);
    return s;
}

}  // namespace

BSplineSurface::BSplineSurface(BSplineSurfaceData data, Interval windowU, Interval windowV)
    : data_(std::move(data)), search_(windowU, windowV)
{
    MESHER_PRECONDITION(data_.poles.size() == data_.countU() * data_.countV());
    MESHER_PRECONDITION(data_.weights.empty() || data_.weights.size() == data_.poles.size());
    breaksU_ = interiorKnots(data_.knotsU, data_.degreeU, 1);
    breaksV_ = interiorKnots(data_.knotsV, data_.degreeV, 1);
}

SurfaceKind BSplineSurface::kind() const
{
    return breaksU_.empty() && breaksV_.empty() ? SurfaceKind::Bezier : SurfaceKind::BSpline;
}

Interval BSplineSurface::rangeU() const
{
    return {data_.knotsU[data_.degreeU], data_.knotsU[data_.countU()]};
}

Interval BSplineSurface::rangeV() const
{
    return {data_.knotsV[data_.degreeV], data_.knotsV[data_.countV()]};
}

Vec3 BSplineSurface::position(Vec2 uv) const
{
    const BSplineBasis u = evaluateBasis(data_.knotsU, data_.degreeU, rangeU().clamp(uv.x));
    const BSplineBasis v = evaluateBasis(data_.knotsV, data_.degreeV, rangeV().clamp(uv.y));
    Vec3 sum;
    double weightSum = 0.0;
    for (std::size_t i = 0; i <= data_.degreeU; ++i) {
        const std::size_t start = (u.first + i) * data_.countV() + v.first;
        for (std::size_t j = 0; j <= data_.degreeV; ++j) {
            const double share =
                u.value[i] * v.value[j] * (data_.weights.empty() ? 1.0 : data_.weights[start + j]);
            sum = sum + share * data_.poles[start + j];
            weightSum += share;
        }
    }
    return data_.weights.empty() ? sum : (1.0 / weightSum) * sum;
}

SurfacePoint BSplineSurface::evaluate(Vec2 uv) const
{
    const BSplineBasis u = evaluateBasis(data_.knotsU, data_.degreeU, rangeU().clamp(uv.x));
    const BSplineBasis v = evaluateBasis(data_.knotsV, data_.degreeV, rangeV().clamp(uv.y));
    const bool isRational = !data_.weights.empty();
    Jet<Vec3> p;
    Jet<double> w;
    for (std::size_t i = 0; i <= data_.degreeU; ++i) {
        const std::size_t start = (u.first + i) * data_.countV() + v.first;
        Row<Vec3> row;
        Row<double> weightRow;
        for (std::size_t j = 0; j <= data_.degreeV; ++j) {
            const double weight = isRational ? data_.weights[start + j] : 1.0;
            row.add(v, j, isRational ? weight * data_.poles[start + j] : data_.poles[start + j]);
            if (isRational) weightRow.add(v, j, weight);
        }
        add(p, u, i, row);
        if (isRational) add(w, u, i, weightRow);
    }
    if (isRational) return divide(p, w);
    return {p.value, p.du, p.dv, p.duu, p.duv, p.dvv};
}

SurfaceProjection BSplineSurface::project(const Vec3& point, std::optional<Vec2> seed) const
{
    return search_.project(*this, point, seed);
}

}  // namespace mesher
