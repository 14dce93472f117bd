#include "kernel_triangles.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Poly_Triangulation.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <gp_Vec.hxx>

#include <cmath>

namespace mesher::test {

double areaOfTriangulation(const TopoDS_Face& face)
{
    constexpr double kDeflection = 1e-4, kTurn = 0.05;  // of the face's size; radians
    BRepBuilderAPI_Copy copy(face);                     // so that the shape itself stays without triangles
    const TopoDS_Face own = TopoDS::Face(copy.Shape());
    Bnd_Box box;
    BRepBndLib::Add(own, box, false);
    BRepMesh_IncrementalMesh(own, kDeflection * std::sqrt(box.SquareExtent()), false, kTurn);
    TopLoc_Location place;
    const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(own, place);
    if (triangles.IsNull()) return 0.0;
    double area = 0.0;
    for (int i = 1; i <= triangles->NbTriangles(); ++i) {
        int a = 0, b = 0, c = 0;
        triangles->Triangle(i).Get(a, b, c);
        const gp_Vec ab(triangles->Node(a), triangles->Node(b)), ac(triangles->Node(a), triangles->Node(c));
        area += 0.5 * ab.Crossed(ac).Magnitude();
    }
    return area * place.Transformation().ScaleFactor() * place.Transformation().ScaleFactor();
}

}  // namespace mesher::test
