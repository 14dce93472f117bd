#include "brep/occt/shape_repair.h"

#include "brep/occt/occt_error.h"

#include <BRepTools_ReShape.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Shape.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

namespace mesher {

namespace {

void listChanges(const TopoDS_Shape& shape, TopAbs_ShapeEnum type, const char* name, BRepTools_ReShape& changes,
                 std::vector<std::string>& list)
{
    TopTools_IndexedMapOfShape entities;
    TopExp::MapShapes(shape, type, entities);
    for (int i = 1; i <= entities.Extent(); ++i) {
        if (!changes.IsRecorded(entities(i))) continue;
        const bool isRemoved = changes.Value(entities(i)).IsNull();
        list.push_back(name + std::to_string(i) + (isRemoved ? " was removed by healing" : " was changed by healing"));
    }
}

}  // namespace

Result<RepairedShape> repairShape(const TopoDS_Shape& shape)
{
    return guarded("the model", "repair it in the CAD program", [&]() -> Result<RepairedShape> {
        ShapeFix_Shape fix(shape);
        fix.Perform();
        RepairedShape result{fix.Shape(), {}};
        if (result.shape.IsNull()) {
            return Error{ErrorCode::DegenerateInput, "healing leaves nothing of it", "the model", {}, "read it without healing"};
        }
        const Handle(ShapeBuild_ReShape) changes = fix.Context();
        listChanges(shape, TopAbs_FACE, "Face", *changes, result.changes);
        listChanges(shape, TopAbs_EDGE, "Edge", *changes, result.changes);
        listChanges(shape, TopAbs_VERTEX, "Vertex", *changes, result.changes);
        return result;
    });
}

}  // namespace mesher
