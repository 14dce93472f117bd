#pragma once

#include "brep/brep_model.h"
#include "brep/curve.h"

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>

#include <memory>
#include <string>

namespace mesher {

/// The curve over `part`: line, circle, ellipse, Bézier and B-spline by the project's own classes on the kernel's exact data,
/// any other by the kernel's evaluation, which throws a GeometryFailure about `entity` where the kernel gives up.
[[nodiscard]] std::shared_ptr<const Curve> makeCurve(const std::string& entity,
                                                     const Handle(Geom_Curve) & geometry, Interval part);

/// The parameter curve, whose own parameter runs over `own` while the edge's runs over `part`.
[[nodiscard]] std::shared_ptr<const ParameterCurve> makeParameterCurve(const std::string& entity,
                                                                       const Handle(Geom2d_Curve) & geometry,
                                                                       Interval own, Interval part);

}  // namespace mesher
