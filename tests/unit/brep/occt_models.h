#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pnt.hxx>

#include <string>
#include <utility>
#include <vector>

namespace mesher::test {

/// Shapes made by the kernel, each with a name for messages.
[[nodiscard]] std::vector<std::pair<std::string, TopoDS_Shape>> kernelModels();

[[nodiscard]] TopoDS_Shape drilledPlate();
/// Two boxes that share a face.
[[nodiscard]] TopoDS_Shape gluedBoxes();

/// A cylinder whose wall has its upper circle twice: as an edge, and as what is marked as a pole.
[[nodiscard]] TopoDS_Shape cylinderWithFalsePole();

/// The closed polygon through the points, an open one if isClosed is false.
[[nodiscard]] TopoDS_Wire polygon(const std::vector<gp_Pnt>& points, bool isClosed = true);
/// A face of the plane z = 0 without any check of the wire.
[[nodiscard]] TopoDS_Face rawFace(const TopoDS_Wire& wire);

}  // namespace mesher::test
