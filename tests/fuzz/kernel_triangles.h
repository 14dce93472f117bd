#pragma once

#include <TopoDS_Face.hxx>

namespace mesher::test {

/// The area of the kernel's own fine triangles of a face. Where its quadratures contradict each other, as they do on faces whose
/// edges wind, this is what tells; too small by less than a thousandth.
[[nodiscard]] double areaOfTriangulation(const TopoDS_Face& face);

}  // namespace mesher::test
