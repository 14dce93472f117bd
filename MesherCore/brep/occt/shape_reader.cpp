#include "brep/occt/shape_reader.h"

#include "brep/occt/exchange_module.h"
#include "brep/occt/occt_error.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>

#include <cstdint>
#include <sstream>
#include <utility>

namespace mesher {

namespace {

/// The kernel's BREP readers go on, without end, when a stream fails: this one throws instead.
std::istringstream throwingStream(const std::string& content)
{
    std::istringstream stream(content);
    stream.exceptions(std::ios::failbit | std::ios::badbit);
    return stream;
}

ShapeFromFile readText(const std::string& content)
{
    const StandardOutputSilence silence;
    // The blank keeps the last number from ending at the end of the stream.
    std::istringstream stream = throwingStream(content + "\n");
    TopoDS_Shape shape;
    BRepTools::Read(shape, stream, BRep_Builder());
    return {shape, "", {}};
}

/// After the shapes OCCT names the root by a sign and two integers, FreeCAD by three integers.
ShapeFromFile readBinary(const std::string& content)
{
    constexpr std::size_t kFreeCadTrailer = 3 * sizeof(std::int32_t);
    std::istringstream stream = throwingStream(content);
    BinTools_ShapeSet set;
    set.Read(stream);
    if (set.NbShapes() == 0) return {};
    const auto position = static_cast<std::size_t>(stream.tellg());
    if (content.size() - position != kFreeCadTrailer) {
        std::istringstream again = throwingStream(content);
        TopoDS_Shape shape;
        BinTools::Read(shape, again);
        return {shape, "", {}};
    }
    int index = 0, location = 0, orientation = 0;
    BinTools::GetInteger(stream, index);
    BinTools::GetInteger(stream, location);
    BinTools::GetInteger(stream, orientation);
    const bool isValid = 1 <= index && index <= set.NbShapes() && 0 <= location &&
                         location <= set.Locations().NbLocations() && TopAbs_FORWARD <= orientation &&
                         orientation <= TopAbs_EXTERNAL;
    if (!isValid) return {};
    TopoDS_Shape shape = set.Shape(index);
    shape.Location(set.Locations().Location(location));
    shape.Orientation(static_cast<TopAbs_Orientation>(orientation));
    return {shape, "", {}};
}

/// Runs one of the two readers of BREP; a null shape from it means damage, as does an end of the stream before its own.
template <class Read>
Result<ShapeFromFile> readBrep(const std::string& name, Read read)
{
    const Error damaged = unreadableFile(name, "the BREP is truncated or damaged");
    try {
        ShapeFromFile result = read();
        if (result.shape.IsNull()) return damaged;
        return result;
    } catch (const std::ios_base::failure&) {
        return damaged;
    }
}

/// By the function of a module.
Result<ShapeFromFile> readBy(const Result<FileReader>& reader, const std::string& content,
                             const std::string& name)
{
    if (!reader) return reader.error();
    Result<ShapeFromFile> result = ShapeFromFile{};
    reader->read(content, name, result);
    return result;
}

}  // namespace

Result<void> prepareReader(ModelFormat format)
{
    const auto done = [](FileReader) -> Result<void> { return {}; };
    switch (format) {
        case ModelFormat::Step: return loadStepReader().andThen(done);
        case ModelFormat::Iges: return loadIgesReader().andThen(done);
        case ModelFormat::BrepText:
        case ModelFormat::BrepBinary: break;
    }
    return {};
}

Result<ShapeFromFile> readShape(ModelFormat format, const std::string& content, const std::string& name)
{
    return guarded(name, "export the model again", [&]() -> Result<ShapeFromFile> {
        switch (format) {
            case ModelFormat::Step: return readBy(loadStepReader(), content, name);
            case ModelFormat::Iges: return readBy(loadIgesReader(), content, name);
            case ModelFormat::BrepText: return readBrep(name, [&] { return readText(content); });
            case ModelFormat::BrepBinary: return readBrep(name, [&] { return readBinary(content); });
        }
        return unreadableFile(name, "its format is unknown");
    });
}

}  // namespace mesher
