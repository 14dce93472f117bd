#include "brep/occt/exchange/file_damage.h"
#include "brep/occt/exchange/transfer.h"

#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <TCollection_HAsciiString.hxx>

#include <optional>
#include <string_view>

namespace mesher {

namespace {

bool isOfShape(const Handle(Standard_Transient) & entity)
{
    const std::string_view type = entity->DynamicType()->Name();
    return type.starts_with("IGESGeom_") || type.starts_with("IGESSolid_");
}

Result<ShapeFromFile> readIges(const std::string& name)
{
    IGESControl_Reader reader;
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    const IFSelect_ReturnStatus status = reader.ReadFile(name.c_str());
    if (status != IFSelect_RetDone)
        return unreadableFile(name, "the IGES file cannot be read: " + reasonOf(status));
    if (const std::optional<std::string> damage = findDamage(reader.IGESModel(), isOfShape))
        return unreadableFile(name, "the IGES file is damaged at " + *damage);
    Result<TopoDS_Shape> shape = transfer(reader, name);
    if (!shape) return shape.error();
    const Handle(TCollection_HAsciiString) unit = reader.IGESModel()->GlobalSection().UnitName();
    return ShapeFromFile{*std::move(shape), unit.IsNull() ? "" : unit->ToCString(), {}};
}

}  // namespace

}  // namespace mesher

void mesher_read_file(const std::string&, const std::string& name,
                      mesher::Result<mesher::ShapeFromFile>& result)
{
    result = mesher::readIges(name);
}
