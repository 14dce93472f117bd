#include "io/format_readers.h"
#include "io/text_scanner.h"
#include "io/vtu_data.h"
#include "io/xml_scanner.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

namespace mesher {

namespace {

/// What the tags of the file say; the data are decoded afterwards.
struct VtuOutline
{
    VtuPacking packing;
    std::int64_t pointCount = 0;
    std::int64_t cellCount = 0;
    std::vector<VtuArraySource> arrays;

    [[nodiscard]] const VtuArraySource* find(std::string_view section, std::string_view name) const
    {
        for (const VtuArraySource& array : arrays) {
            if (array.section == section && (name.empty() || array.name == name)) return &array;
        }
        return nullptr;
    }
};

class OutlineReader
{
public:
    explicit OutlineReader(std::string_view text) : text_(text), xml_(text) {}

    Result<VtuOutline> read();

private:
    void visit(const XmlTag& tag);
    void readFileTag(const XmlTag& tag);
    void readPiece(const XmlTag& tag);
    void readArray(const XmlTag& tag);
    void readAppended(const XmlTag& tag);
    void fail(std::size_t offset, const std::string& message)
    {
        if (!error_) error_ = unreadableAt(offset, message);
    }
    [[nodiscard]] std::int64_t numberIn(const XmlTag& tag, std::string_view attribute);

    /// An appended array whose place is known only once the data section is met.
    struct Appended
    {
        std::size_t array;
        std::int64_t offset;
    };

    std::string_view text_;
    XmlScanner xml_;
    VtuOutline outline_;
    std::vector<Appended> appended_;
    std::vector<std::string_view> open_;
    int pieceCount_ = 0;
    bool isVtu_ = false;
    bool isDone_ = false;
    std::optional<Error> error_;
};

Result<VtuOutline> OutlineReader::read()
{
    while (!isDone_ && !error_) {
        const std::optional<XmlTag> tag = xml_.next();
        if (!tag) break;
        visit(*tag);
    }
    if (!xml_.failure().empty() && !error_) {
        error_ = Error{
            ErrorCode::Unreadable, xml_.failure(), {}, {}, "write the file again, it is cut off or broken"};
    }
    if (!isVtu_) fail(0, "this is no VTK XML file");
    if (pieceCount_ == 0) fail(0, "the file has no piece of an unstructured grid");
    if (!isDone_) fail(text_.size(), "the file is cut off");
    if (error_) return *error_;
    return std::move(outline_);
}

void OutlineReader::visit(const XmlTag& tag)
{
    if (tag.isClosing) {
        if (open_.empty() || open_.back() != tag.name) {
            fail(tag.offset, "a tag is closed that is not open");
            return;
        }
        open_.pop_back();
        isDone_ = open_.empty();
        return;
    }
    if (tag.name == "VTKFile") {
        readFileTag(tag);
    } else if (!isVtu_) {
        fail(tag.offset, "this is no VTK XML file");
    } else if (tag.name == "Piece") {
        readPiece(tag);
    } else if (tag.name == "DataArray") {
        readArray(tag);
    } else if (tag.name == "AppendedData") {
        readAppended(tag);
    }
    if (!tag.isEmpty) open_.push_back(tag.name);
}

void OutlineReader::readFileTag(const XmlTag& tag)
{
    isVtu_ = true;
    if (tag.attribute("type") != "UnstructuredGrid") {
        fail(tag.offset, "the file is not an unstructured grid");
    } else if (tag.attribute("byte_order") == "BigEndian") {
        fail(tag.offset, "the file is written in big-endian order");
    }
    const std::string_view compressor = tag.attribute("compressor");
    outline_.packing.isCompressed = !compressor.empty();
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor") {
        fail(tag.offset, "the data are compressed by another method than zlib");
    }
    const std::string_view header = tag.attribute("header_type");
    if (!header.empty() && header != "UInt32" && header != "UInt64")
        fail(tag.offset, "the type of the headers is unknown");
    outline_.packing.headerSize = header == "UInt64" ? 8 : 4;
}

std::int64_t OutlineReader::numberIn(const XmlTag& tag, std::string_view attribute)
{
    TextScanner in(tag.attribute(attribute));
    const std::int64_t value = in.integer();
    if (in.failed() || !in.atEnd() || value < 0) fail(tag.offset, std::string(attribute) + " is no number");
    return error_ ? 0 : value;
}

void OutlineReader::readPiece(const XmlTag& tag)
{
    if (++pieceCount_ > 1) fail(tag.offset, "the file has several pieces; merge them");
    outline_.pointCount = numberIn(tag, "NumberOfPoints");
    outline_.cellCount = numberIn(tag, "NumberOfCells");
}

void OutlineReader::readArray(const XmlTag& tag)
{
    VtuArraySource array;
    array.section = open_.empty() ? std::string_view() : open_.back();
    array.name = tag.attribute("Name");
    array.type = tag.attribute("type");
    array.offset = tag.offset;
    if (!tag.attribute("NumberOfComponents").empty()) {
        array.components = static_cast<std::size_t>(numberIn(tag, "NumberOfComponents"));
    }
    const std::string_view format = tag.attribute("format");
    if (format == "appended") {
        appended_.push_back({outline_.arrays.size(), numberIn(tag, "offset")});
    } else if (format == "ascii" || format == "binary" || format.empty()) {
        array.encoding = format == "binary" ? VtuEncoding::Base64 : VtuEncoding::Text;
        if (!tag.isEmpty) array.data = xml_.content();
    } else {
        fail(tag.offset, "the format of an array is unknown");
    }
    outline_.arrays.push_back(array);
}

void OutlineReader::readAppended(const XmlTag& tag)
{
    const std::string_view encoding = tag.attribute("encoding");
    if (encoding != "base64" && encoding != "raw") {
        fail(tag.offset, "the encoding of the appended data is unknown");
        return;
    }
    const std::size_t mark = text_.find('_', xml_.position());
    if (mark == std::string_view::npos) {
        fail(tag.offset, "the appended data do not begin");
        return;
    }
    std::string_view data = text_.substr(mark + 1);
    const bool isRaw = encoding == "raw";
    if (!isRaw) data = data.substr(0, std::min(data.find('<'), data.size()));
    for (const auto& [array, offset] : appended_) {
        VtuArraySource& source = outline_.arrays[array];
        if (static_cast<std::uint64_t>(offset) > data.size()) {
            fail(source.offset, "the data of an array lie outside of the file");
            return;
        }
        source.encoding = isRaw ? VtuEncoding::Raw : VtuEncoding::Base64;
        source.data = data.substr(static_cast<std::size_t>(offset));
    }
    isDone_ = true;
}

/// Turns the arrays into a mesh.
class VtuReader
{
public:
    explicit VtuReader(VtuOutline outline) : outline_(std::move(outline)) {}

    Result<MeshFile> read();

private:
    [[nodiscard]] std::vector<double> reals(const VtuArraySource* source, std::int64_t itemCount);
    [[nodiscard]] std::vector<std::int64_t> integers(std::string_view section, std::string_view name);
    [[nodiscard]] std::vector<EntityRef> entities(std::string_view section, std::int64_t itemCount);
    void readNodes();
    void readCells();
    void addCell(std::int64_t type, std::span<const std::int64_t> nodes, EntityRef entity, std::size_t index);
    void readFields();
    void fail(Error error)
    {
        if (!error_) error_ = std::move(error);
    }
    void fail(const VtuArraySource& source, const std::string& message)
    {
        fail(unreadableAt(source.offset,
                          "array '" + std::string(source.name.substr(0, 40)) + "': " + message));
    }

    VtuOutline outline_;
    MeshFile file_;
    std::optional<Error> error_;
};

Result<MeshFile> VtuReader::read()
{
    readNodes();
    if (!error_) readCells();
    if (!error_) readFields();
    if (error_) return *error_;
    return std::move(file_);
}

/// Values of an array that has `components` of them for each of the items.
std::vector<double> VtuReader::reals(const VtuArraySource* source, std::int64_t itemCount)
{
    Result<std::vector<double>> values = readReals(*source, outline_.packing);
    if (!values) {
        fail(values.error());
        return {};
    }
    const std::size_t components = std::max<std::size_t>(source->components, 1);
    if (values->size() % components != 0 ||
        values->size() / components != static_cast<std::uint64_t>(itemCount)) {
        fail(*source, "it has not as many values as the file announces");
        return {};
    }
    return std::move(values).value();
}

std::vector<std::int64_t> VtuReader::integers(std::string_view section, std::string_view name)
{
    const VtuArraySource* source = outline_.find(section, name);
    if (source == nullptr) {
        fail(unreadableAt(0, "there is no array '" + std::string(name) + "' in " + std::string(section)));
        return {};
    }
    Result<std::vector<std::int64_t>> values = readIntegers(*source, outline_.packing);
    if (!values) {
        fail(values.error());
        return {};
    }
    return std::move(values).value();
}

/// From the arrays 'entity' (a number from 1, 0 for none) and 'dimension'; no entities where the file lacks them.
std::vector<EntityRef> VtuReader::entities(std::string_view section, std::int64_t itemCount)
{
    if (outline_.find(section, "entity") == nullptr || outline_.find(section, "dimension") == nullptr)
        return {};
    const std::vector<std::int64_t> number = integers(section, "entity");
    const std::vector<std::int64_t> dimension = integers(section, "dimension");
    if (error_) return {};
    const auto count = static_cast<std::uint64_t>(itemCount);
    if (number.size() != count || dimension.size() != count) {
        fail(*outline_.find(section, "entity"), "it has not as many values as the file announces");
        return {};
    }
    std::vector<EntityRef> entities(number.size());
    for (std::size_t i = 0; i < number.size(); ++i) {
        const bool isValid =
            number[i] >= 0 && number[i] < std::int64_t{0xFFFFFFFF} && dimension[i] >= 0 && dimension[i] <= 3;
        if (!isValid) {
            fail(*outline_.find(section, "entity"), "a number or dimension is out of range");
            return {};
        }
        const auto index = number[i] == 0 ? EntityRef::kNone : static_cast<std::uint32_t>(number[i] - 1);
        entities[i] = {static_cast<std::uint8_t>(dimension[i]), index};
    }
    return entities;
}

void VtuReader::readNodes()
{
    const VtuArraySource* points = outline_.find("Points", "");
    if (points == nullptr || points->components != 3) {
        fail(unreadableAt(0, "there is no array of points with three components"));
        return;
    }
    const std::vector<double> coordinates = reals(points, outline_.pointCount);
    const std::vector<EntityRef> entity = entities("PointData", outline_.pointCount);
    const VtuArraySource* parameterSource = outline_.find("PointData", "parameters");
    std::vector<double> parameters;
    if (parameterSource != nullptr && parameterSource->components == 2) {
        parameters = reals(parameterSource, outline_.pointCount);
    }
    if (error_) return;
    const std::size_t count = coordinates.size() / 3;
    file_.mesh.nodes.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        MeshNode node;
        node.position = {coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]};
        if (!entity.empty()) node.entity = entity[i];
        if (!parameters.empty()) node.parameters = {parameters[2 * i], parameters[2 * i + 1]};
        file_.mesh.nodes.push_back(node);
    }
}

void VtuReader::readCells()
{
    const std::vector<std::int64_t> connectivity = integers("Cells", "connectivity");
    const std::vector<std::int64_t> offsets = integers("Cells", "offsets");
    const std::vector<std::int64_t> types = integers("Cells", "types");
    const std::vector<EntityRef> entity = entities("CellData", outline_.cellCount);
    if (error_) return;
    const auto count = static_cast<std::uint64_t>(outline_.cellCount);
    if (offsets.size() != count || types.size() != count) {
        fail(*outline_.find("Cells", "types"), "there are not as many cells as the file announces");
        return;
    }
    std::int64_t first = 0;
    for (std::size_t i = 0; i < types.size() && !error_; ++i) {
        if (offsets[i] < first || offsets[i] > static_cast<std::int64_t>(connectivity.size())) {
            fail(*outline_.find("Cells", "offsets"),
                 "cell " + std::to_string(i) + " lies outside of the connectivity");
            return;
        }
        const std::span<const std::int64_t> nodes(connectivity.data() + first,
                                                  connectivity.data() + offsets[i]);
        addCell(types[i], nodes, entity.empty() ? EntityRef{} : entity[i], i);
        first = offsets[i];
    }
}

template <std::size_t N>
MeshElement<N> elementOf(std::span<const std::int64_t> nodes, EntityRef entity)
{
    MeshElement<N> element;
    for (std::size_t k = 0; k < N; ++k) element.node[k] = NodeId(static_cast<std::uint32_t>(nodes[k]));
    element.entity = entity.index == EntityRef::kNone ? EntityRef{N - 1, EntityRef::kNone} : entity;
    return element;
}

void VtuReader::addCell(std::int64_t type, std::span<const std::int64_t> nodes, EntityRef entity,
                        std::size_t index)
{
    const std::size_t wanted = type == 1 ? 1 : (type == 3 ? 2 : (type == 5 ? 3 : (type == 10 ? 4 : 0)));
    if (wanted == 0 || nodes.size() != wanted) {
        fail(*outline_.find("Cells", "types"), "cell " + std::to_string(index) + " of VTK's type " +
                                                   std::to_string(type) + " with " +
                                                   std::to_string(nodes.size()) + " nodes is not read");
        return;
    }
    for (const std::int64_t node : nodes) {
        if (node < 0 || static_cast<std::uint64_t>(node) >= file_.mesh.nodes.size()) {
            fail(*outline_.find("Cells", "connectivity"), "cell " + std::to_string(index) + " has a node " +
                                                              std::to_string(node) + " that is not there");
            return;
        }
    }
    switch (wanted) {
        case 1: file_.mesh.points.push_back(elementOf<1>(nodes, entity)); break;
        case 2: file_.mesh.lines.push_back(elementOf<2>(nodes, entity)); break;
        case 3: file_.mesh.triangles.push_back(elementOf<3>(nodes, entity)); break;
        default: file_.mesh.tets.push_back(elementOf<4>(nodes, entity)); break;
    }
}

/// Every number at the nodes but those that classify them.
void VtuReader::readFields()
{
    for (const VtuArraySource& array : outline_.arrays) {
        const bool isField = array.section == "PointData" && array.components == 1 &&
                             array.type != "String" && array.name != "entity" && array.name != "dimension";
        if (!isField) continue;
        std::vector<double> values = reals(&array, outline_.pointCount);
        if (error_) return;
        file_.fields.push_back({std::string(array.name), std::move(values)});
    }
}

}  // namespace

Result<MeshFile> readVtu(std::string_view text)
{
    Result<VtuOutline> outline = OutlineReader(text).read();
    if (!outline) return outline.error();
    return VtuReader(std::move(outline).value()).read();
}

}  // namespace mesher
