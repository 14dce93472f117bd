#pragma once

#include "brep/surface.h"

#include <Geom_Surface.hxx>

#include <memory>
#include <string>

namespace mesher {

/// The surface: plane, cylinder, cone, sphere and torus by the project's own classes on the kernel's exact data, any other by
/// the kernel's evaluation. `windowU` and `windowV`, the bounds of the face, replace the range where that has no end, when
/// a closest point is searched without a seed. Where the kernel gives up, the surface throws a GeometryFailure about `entity`.
[[nodiscard]] std::shared_ptr<const Surface> makeSurface(const std::string& entity,
                                                         const Handle(Geom_Surface) & geometry,
                                                         Interval windowU, Interval windowV);

}  // namespace mesher
