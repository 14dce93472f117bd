#include "io/format_readers.h"
#include "io/text_scanner.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace mesher {

namespace {

constexpr std::int64_t kLargestTag = std::numeric_limits<std::int32_t>::max();
constexpr std::array<std::string_view, 4> kEntityPrefix = {"Vertex", "Edge", "Face", "Solid"};

using DimensionAndTag = std::pair<std::uint8_t, std::int64_t>;

struct ElementKind
{
    std::uint8_t dimension;
    std::uint8_t nodeCount;
};

/// The kinds of elements that are read, by Gmsh's number.
std::optional<ElementKind> kindOf(std::int64_t type)
{
    switch (type) {
        case 15: return ElementKind{0, 1};
        case 1: return ElementKind{1, 2};
        case 2: return ElementKind{2, 3};
        case 4: return ElementKind{3, 4};
        default: return std::nullopt;
    }
}

/// The index behind a name like "Face6": 5.
std::optional<std::uint32_t> indexInName(std::string_view name, std::uint8_t dimension)
{
    const std::string_view prefix = kEntityPrefix[dimension];
    if (name.substr(0, prefix.size()) != prefix) return std::nullopt;
    const char* first = name.data() + prefix.size();
    const char* last = name.data() + name.size();
    std::uint32_t number = 0;
    const auto [end, code] = std::from_chars(first, last, number);
    if (first == last || end != last || code != std::errc() || number == 0) return std::nullopt;
    return number - 1;
}

/// A value for each node of a $NodeData section, by the node's tag.
struct TaggedField
{
    std::string name;
    std::vector<std::pair<std::int64_t, double>> values;
};

class GmshReader
{
public:
    explicit GmshReader(std::string_view text) : in_(text) {}

    Result<MeshFile> read();

private:
    void readFormat();
    void readSection(std::string_view name);
    void readPhysicalNames();
    void readEntities();
    void findTagsBefore();
    void readNodes22();
    void readNodes41();
    void readElements22();
    void readElements41();
    void readNodeData();

    void addNode(std::int64_t tag, const Vec3& position, EntityRef entity);
    void addElement(ElementKind kind, EntityRef entity);
    [[nodiscard]] NodeId node();
    [[nodiscard]] EntityRef entityOf(std::uint8_t dimension, std::int64_t tag,
                                     std::span<const std::int64_t> groups) const;
    [[nodiscard]] EntityRef entityOfBlock(std::uint8_t dimension, std::int64_t tag) const;
    void finishNodes();
    void classifyNodesByElements();
    void attachFields();

    TextScanner in_;
    bool isVersion2_ = false;
    bool hasNodes_ = false;
    bool hasElements_ = false;
    std::map<DimensionAndTag, std::string, std::less<>> groupName_;
    std::map<DimensionAndTag, std::vector<std::int64_t>> entityGroups_;
    /// What tags of this dimension count on from, where one numbering goes through all dimensions.
    std::array<std::int64_t, 4> tagsBefore_{};
    /// Whether the groups of this dimension are named after entities.
    std::array<bool, 4> hasEntityNames_{};
    std::vector<std::pair<std::int64_t, MeshNode>> taggedNodes_;
    std::vector<std::int64_t> nodeTags_;  ///< sorted, once the nodes are read
    std::vector<TaggedField> fields_;
    MeshFile file_;
};

Result<MeshFile> GmshReader::read()
{
    readFormat();
    while (!in_.failed() && !in_.atEnd()) {
        const std::string section(in_.word());
        if (section.size() < 2 || section[0] != '$') {
            in_.fail("the beginning of a section is expected");
            break;
        }
        readSection(std::string_view(section).substr(1));
    }
    if (!in_.failed() && !hasNodes_) in_.fail("the file has no nodes", "write the file again, it is cut off");
    if (!in_.failed() && !hasElements_)
        in_.fail("the file has no elements", "write the file again, it is cut off");
    if (!in_.failed()) attachFields();
    if (in_.failed()) return in_.failure();
    if (isVersion2_) classifyNodesByElements();
    return std::move(file_);
}

void GmshReader::readFormat()
{
    in_.expect("$MeshFormat");
    const std::string version(in_.word());
    const std::int64_t mode = in_.integer();
    if (in_.failed()) return;
    if (version != "4.1" && version != "2.2" && version != "2") {
        in_.fail("format " + version + " is not known", "write it as Gmsh 4.1 or 2.2");
    } else if (mode != 0) {
        in_.fail("the file is binary", "write it as ASCII");
    }
    isVersion2_ = version[0] == '2';
    in_.skipPastLine("$EndMeshFormat");
}

void GmshReader::readSection(std::string_view name)
{
    const std::string end = "$End" + std::string(name);
    if (name == "PhysicalNames") {
        readPhysicalNames();
    } else if (name == "Entities" && !isVersion2_) {
        readEntities();
    } else if (name == "Nodes" && !hasNodes_) {
        isVersion2_ ? readNodes22() : readNodes41();
    } else if (name == "Elements" && !hasElements_) {
        if (!hasNodes_) in_.fail("the elements come before the nodes");
        isVersion2_ ? readElements22() : readElements41();
    } else if (name == "NodeData") {
        readNodeData();
    } else if (name == "Nodes" || name == "Elements") {
        in_.fail("the section " + std::string(name) + " is there twice");
    } else {
        in_.skipPastLine(end);
        return;
    }
    in_.expect(end);
}

void GmshReader::readPhysicalNames()
{
    const std::size_t count = in_.count(6);
    for (std::size_t i = 0; i < count && !in_.failed(); ++i) {
        const auto dimension = static_cast<std::uint8_t>(in_.integer(0, 3));
        const std::int64_t tag = in_.integer(-kLargestTag, kLargestTag);
        std::string name(in_.quoted());
        if (indexInName(name, dimension)) hasEntityNames_[dimension] = true;
        groupName_[{dimension, tag}] = std::move(name);
    }
}

void GmshReader::readEntities()
{
    std::array<std::size_t, 4> counts{};
    for (std::size_t& count : counts) count = in_.count(8);
    for (std::uint8_t dimension = 0; dimension < 4; ++dimension) {
        for (std::size_t i = 0; i < counts[dimension] && !in_.failed(); ++i) {
            const std::int64_t tag = in_.integer(-kLargestTag, kLargestTag);
            for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) static_cast<void>(in_.real());
            std::vector<std::int64_t>& groups = entityGroups_[{dimension, tag}];
            const std::size_t groupCount = in_.count(2);
            for (std::size_t k = 0; k < groupCount && !in_.failed(); ++k) {
                groups.push_back(std::abs(in_.integer(-kLargestTag, kLargestTag)));
            }
            const std::size_t sideCount = dimension == 0 ? 0 : in_.count(2);
            for (std::size_t k = 0; k < sideCount && !in_.failed(); ++k) static_cast<void>(in_.integer());
        }
    }
    findTagsBefore();
}

/// Where groups of solids or faces are named after them, and edges and vertices have tags beyond all of theirs, the tags tell
/// which edge or vertex it is by counting on.
void GmshReader::findTagsBefore()
{
    std::int64_t largest = 0;
    bool isNamed = false;
    for (std::uint8_t dimension = 4; dimension-- > 0;) {
        const auto first = entityGroups_.lower_bound({dimension, -kLargestTag});
        const auto last = entityGroups_.lower_bound({static_cast<std::uint8_t>(dimension + 1), -kLargestTag});
        if (first == last) continue;
        if (isNamed && first->first.second > largest) tagsBefore_[dimension] = largest;
        largest = std::max(largest, std::prev(last)->first.second);
        isNamed = isNamed || hasEntityNames_[dimension];
    }
}

/// The entity by the first group that is named after one; by the tag if the file does not name groups so.
EntityRef GmshReader::entityOf(std::uint8_t dimension, std::int64_t tag,
                               std::span<const std::int64_t> groups) const
{
    for (const std::int64_t group : groups) {
        const auto name = groupName_.find(DimensionAndTag(dimension, group));
        if (name == groupName_.end()) continue;
        if (const auto index = indexInName(name->second, dimension)) return {dimension, *index};
    }
    if (hasEntityNames_[dimension] || tag <= 0) return {dimension, EntityRef::kNone};
    return {dimension, static_cast<std::uint32_t>(tag - tagsBefore_[dimension] - 1)};
}

EntityRef GmshReader::entityOfBlock(std::uint8_t dimension, std::int64_t tag) const
{
    const auto groups = entityGroups_.find({dimension, tag});
    return entityOf(dimension, tag,
                    groups == entityGroups_.end() ? std::span<const std::int64_t>() : groups->second);
}

void GmshReader::addNode(std::int64_t tag, const Vec3& position, EntityRef entity)
{
    taggedNodes_.push_back({tag, MeshNode{position, entity, {}}});
}

void GmshReader::readNodes22()
{
    const std::size_t count = in_.count(8);
    taggedNodes_.reserve(count);
    for (std::size_t i = 0; i < count && !in_.failed(); ++i) {
        const std::int64_t tag = in_.integer();
        const double x = in_.real();
        const double y = in_.real();
        const double z = in_.real();
        addNode(tag, {x, y, z}, {3, EntityRef::kNone});
    }
    finishNodes();
}

void GmshReader::readNodes41()
{
    const std::size_t blockCount = in_.count(8);
    const std::size_t nodeCount = in_.count(8);
    taggedNodes_.reserve(nodeCount);
    static_cast<void>(in_.integer());
    static_cast<void>(in_.integer());
    std::vector<std::int64_t> tags;
    for (std::size_t b = 0; b < blockCount && !in_.failed(); ++b) {
        const auto dimension = static_cast<std::uint8_t>(in_.integer(0, 3));
        const EntityRef entity = entityOfBlock(dimension, in_.integer(-kLargestTag, kLargestTag));
        const bool isParametric = in_.integer(0, 1) == 1;
        tags.resize(in_.count(8));
        for (std::int64_t& tag : tags) tag = in_.integer();
        for (const std::int64_t tag : tags) {
            if (in_.failed()) break;
            const double x = in_.real();
            const double y = in_.real();
            const double z = in_.real();
            addNode(tag, {x, y, z}, entity);
            std::array<double, 3> parameter{};
            for (std::uint8_t k = 0; isParametric && k < dimension; ++k) parameter[k] = in_.real();
            taggedNodes_.back().second.parameters = {parameter[0], parameter[1]};
        }
    }
    if (!in_.failed() && taggedNodes_.size() != nodeCount) {
        in_.fail("there are " + std::to_string(taggedNodes_.size()) + " nodes where " +
                 std::to_string(nodeCount) + " are announced");
    }
    finishNodes();
}

void GmshReader::finishNodes()
{
    hasNodes_ = true;
    if (in_.failed()) return;
    const auto isBefore = [](const auto& a, const auto& b) { return a.first < b.first; };
    if (!std::is_sorted(taggedNodes_.begin(), taggedNodes_.end(), isBefore)) {
        std::sort(taggedNodes_.begin(), taggedNodes_.end(), isBefore);
    }
    file_.mesh.nodes.reserve(taggedNodes_.size());
    nodeTags_.reserve(taggedNodes_.size());
    for (const auto& [tag, meshNode] : taggedNodes_) {
        if (!nodeTags_.empty() && nodeTags_.back() == tag) {
            in_.fail("the node " + std::to_string(tag) + " is there twice");
            return;
        }
        nodeTags_.push_back(tag);
        file_.mesh.nodes.push_back(meshNode);
    }
    taggedNodes_ = {};
}

NodeId GmshReader::node()
{
    const std::int64_t tag = in_.integer();
    if (in_.failed()) return {};
    // Tags are mostly 1, 2, 3, …
    if (tag >= 1 && static_cast<std::size_t>(tag) <= nodeTags_.size() &&
        nodeTags_[static_cast<std::size_t>(tag - 1)] == tag) {
        return NodeId(static_cast<std::uint32_t>(tag - 1));
    }
    const auto found = std::lower_bound(nodeTags_.begin(), nodeTags_.end(), tag);
    if (found == nodeTags_.end() || *found != tag) {
        in_.fail("there is no node " + std::to_string(tag));
        return {};
    }
    return NodeId(static_cast<std::uint32_t>(found - nodeTags_.begin()));
}

template <std::size_t N>
MeshElement<N> elementOf(const std::array<NodeId, 4>& nodes, EntityRef entity)
{
    MeshElement<N> element;
    std::copy_n(nodes.begin(), N, element.node.begin());
    element.entity = entity;
    return element;
}

void GmshReader::addElement(ElementKind kind, EntityRef entity)
{
    std::array<NodeId, 4> nodes{};
    for (std::size_t k = 0; k < kind.nodeCount; ++k) nodes[k] = node();
    if (in_.failed()) return;
    switch (kind.dimension) {
        case 0: file_.mesh.points.push_back(elementOf<1>(nodes, entity)); break;
        case 1: file_.mesh.lines.push_back(elementOf<2>(nodes, entity)); break;
        case 2: file_.mesh.triangles.push_back(elementOf<3>(nodes, entity)); break;
        default: file_.mesh.tets.push_back(elementOf<4>(nodes, entity)); break;
    }
}

void GmshReader::readElements22()
{
    hasElements_ = true;
    const std::size_t count = in_.count(8);
    for (std::size_t i = 0; i < count && !in_.failed(); ++i) {
        static_cast<void>(in_.integer());
        const std::int64_t type = in_.integer();
        const std::int64_t tagCount = in_.integer(0, 1024);
        std::int64_t group = 0;
        std::int64_t tag = 0;
        for (std::int64_t k = 0; k < tagCount; ++k) {
            const std::int64_t value = in_.integer(-kLargestTag, kLargestTag);
            if (k == 0) group = std::abs(value);
            if (k == 1) tag = value;
        }
        const std::optional<ElementKind> kind = kindOf(type);
        if (!kind) {
            in_.fail("elements of Gmsh's type " + std::to_string(type) + " are not read",
                     "mesh with linear triangles and tetrahedra");
            return;
        }
        addElement(*kind, entityOf(kind->dimension, tag, {&group, 1}));
    }
}

void GmshReader::readElements41()
{
    hasElements_ = true;
    const std::size_t blockCount = in_.count(8);
    const std::size_t elementCount = in_.count(4);
    static_cast<void>(in_.integer());
    static_cast<void>(in_.integer());
    std::size_t found = 0;
    for (std::size_t b = 0; b < blockCount && !in_.failed(); ++b) {
        static_cast<void>(in_.integer(0, 3));
        const std::int64_t tag = in_.integer(-kLargestTag, kLargestTag);
        const std::int64_t type = in_.integer();
        const std::size_t count = in_.count(4);
        const std::optional<ElementKind> kind = kindOf(type);
        if (!in_.failed() && !kind) {
            in_.fail("elements of Gmsh's type " + std::to_string(type) + " are not read",
                     "mesh with linear triangles and tetrahedra");
        }
        if (in_.failed()) return;
        const EntityRef entity = entityOfBlock(kind->dimension, tag);
        for (std::size_t i = 0; i < count && !in_.failed(); ++i) {
            static_cast<void>(in_.integer());
            addElement(*kind, entity);
        }
        found += count;
    }
    if (!in_.failed() && found != elementCount) {
        in_.fail("there are " + std::to_string(found) + " elements where " + std::to_string(elementCount) +
                 " are announced");
    }
}

void GmshReader::readNodeData()
{
    TaggedField field;
    const std::size_t textCount = in_.count(2);
    for (std::size_t i = 0; i < textCount && !in_.failed(); ++i) {
        const std::string_view text = in_.quoted();
        if (i == 0) field.name = text;
    }
    const std::size_t realCount = in_.count(2);
    for (std::size_t i = 0; i < realCount && !in_.failed(); ++i) static_cast<void>(in_.real());
    const std::size_t integerCount = in_.count(2);
    std::int64_t components = 1;
    std::int64_t valueCount = 0;
    for (std::size_t i = 0; i < integerCount && !in_.failed(); ++i) {
        const std::int64_t value = in_.integer();
        if (i == 1) components = value;
        if (i == 2) valueCount = value;
    }
    if (!in_.failed() && (integerCount < 3 || (components != 1 && components != 3 && components != 9))) {
        in_.fail("the header of the node data is broken");
    }
    for (std::int64_t i = 0; i < valueCount && !in_.failed(); ++i) {
        const std::int64_t tag = in_.integer();
        const double value = in_.real();
        for (std::int64_t k = 1; k < components; ++k) static_cast<void>(in_.real());
        if (components == 1) field.values.emplace_back(tag, value);
    }
    if (components == 1) fields_.push_back(std::move(field));
}

/// A field that lacks a node is refused: a size that is missing cannot be made up.
void GmshReader::attachFields()
{
    for (TaggedField& field : fields_) {
        std::stable_sort(field.values.begin(), field.values.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        NodalField nodal{field.name, {}};
        nodal.values.reserve(nodeTags_.size());
        auto next = field.values.begin();
        for (const std::int64_t tag : nodeTags_) {
            while (next != field.values.end() && next->first < tag) ++next;
            if (next == field.values.end() || next->first != tag) {
                in_.fail("the node data '" + field.name + "' has no value for node " + std::to_string(tag));
                return;
            }
            nodal.values.push_back(next->second);
        }
        file_.fields.push_back(std::move(nodal));
    }
}

/// Format 2.2 does not say where a node lies: on the entity of the element of the lowest dimension that has it. Where these are
/// of several entities, the node lies on what is between them, which has no elements in the file and so no name.
void GmshReader::classifyNodesByElements()
{
    ClassifiedMesh& mesh = file_.mesh;
    std::vector<std::uint8_t> level(mesh.nodes.size(), 4);  // dimension of the elements that told last
    const auto classify = [&](const auto& elements) {
        for (const auto& element : elements) {
            const auto dimension = static_cast<std::uint8_t>(element.node.size() - 1);
            for (const NodeId id : element.node) {
                EntityRef& entity = mesh.nodes[id].entity;
                const bool isFirst = std::exchange(level[id.value], dimension) != dimension;
                if (isFirst) {
                    entity = element.entity;
                } else if (entity != element.entity && dimension > 0) {
                    entity = {static_cast<std::uint8_t>(dimension - 1), EntityRef::kNone};
                }
            }
        }
    };
    classify(mesh.tets);
    classify(mesh.triangles);
    classify(mesh.lines);
    classify(mesh.points);
}

}  // namespace

Result<MeshFile> readGmsh(std::string_view text) { return GmshReader(text).read(); }

}  // namespace mesher
