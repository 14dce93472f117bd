#include "brep/model_inspection.h"

#include <charconv>
#include <cmath>
#include <iterator>
#include <sstream>
#include <string_view>

namespace mesher {

namespace {

constexpr std::size_t kLongestList = 10;

std::string shortNumber(double value)
{
    std::ostringstream text;
    text.precision(4);
    text << value;
    return text.str();
}

std::string listOf(const std::map<std::string, std::size_t>& counts)
{
    std::string text;
    for (const auto& [name, count] : counts) {
        if (!text.empty()) text += ", ";
        text += std::to_string(count) + " " + name;
    }
    return text;
}

template <class List, class Line>
void appendList(std::string& text, const std::string& title, const List& list, Line&& line)
{
    if (list.empty()) return;
    text += title + ": " + std::to_string(list.size()) + "\n";
    for (std::size_t i = 0; i < list.size() && i < kLongestList; ++i) text += "  " + line(list[i]) + "\n";
    if (list.size() > kLongestList) text += "  and " + std::to_string(list.size() - kLongestList) + " more\n";
}

std::string enclosed(char open, std::string_view text, char close)
{
    std::string result(1, open);
    result.append(text);
    result += close;
    return result;
}

std::string quoted(std::string_view text)
{
    constexpr char kDigits[] = "0123456789abcdef";
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        if (static_cast<unsigned char>(c) < 0x20) {
            result += "\\u00";
            result += kDigits[static_cast<unsigned char>(c) >> 4];
            result += kDigits[static_cast<unsigned char>(c) & 15];
            continue;
        }
        result += c;
    }
    return result + "\"";
}

/// The shortest form that reads back as the same double; JSON has no infinity.
std::string exactNumber(double value)
{
    if (!std::isfinite(value)) return "null";
    char digits[32];
    const std::to_chars_result end = std::to_chars(std::begin(digits), std::end(digits), value);
    return {digits, end.ptr};
}

class JsonObject
{
public:
    JsonObject& add(std::string_view key, const std::string& rawValue)
    {
        if (!text_.empty()) text_ += ", ";
        text_ += quoted(key) + ": " + rawValue;
        return *this;
    }
    JsonObject& add(std::string_view key, double value) { return add(key, exactNumber(value)); }
    JsonObject& add(std::string_view key, std::size_t value) { return add(key, std::to_string(value)); }
    [[nodiscard]] std::string text() const { return enclosed('{', text_, '}'); }

private:
    std::string text_;
};

template <class List, class Item>
std::string jsonList(const List& list, Item&& item)
{
    std::string text;
    for (const auto& entry : list) {
        if (!text.empty()) text += ", ";
        text += item(entry);
    }
    return enclosed('[', text, ']');
}

std::string jsonCounts(const std::map<std::string, std::size_t>& counts)
{
    JsonObject object;
    for (const auto& [name, count] : counts) object.add(name, count);
    return object.text();
}

std::string jsonPoint(const Vec3& p)
{
    return enclosed('[', exactNumber(p.x) + ", " + exactNumber(p.y) + ", " + exactNumber(p.z), ']');
}

}  // namespace

std::string textOf(const ModelFacts& facts)
{
    const auto edgeName = [](BrepEdgeId id) { return nameOf(id); };
    std::string text;
    text += std::to_string(facts.solids) + " solids, " + std::to_string(facts.shells) + " shells (" +
            std::to_string(facts.openShells) + " open), " + std::to_string(facts.faces) + " faces, " +
            std::to_string(facts.edges) + " edges (" + std::to_string(facts.degenerateEdges) + " degenerate), " +
            std::to_string(facts.vertices) + " vertices\n";
    text += "faces: " + listOf(facts.facesByType) + "\nedges: " + listOf(facts.edgesByType) + "\n";
    const Vec3 extent = facts.box.isEmpty() ? Vec3{} : facts.box.extent();
    text += "box: " + shortNumber(extent.x) + " x " + shortNumber(extent.y) + " x " + shortNumber(extent.z) + " " + facts.unit +
            "; area " + shortNumber(facts.area) + ", edges' length " + shortNumber(facts.length) + "\n";
    text += "largest tolerance: " + shortNumber(facts.largestTolerance.value) + " (" + facts.largestTolerance.entity + "), " +
            std::to_string(facts.looseTolerances) + " above 1e-7\n";
    if (facts.smallestEdge) {
        text += "smallest edge: " + nameOf(facts.smallestEdge->edge) + ", " + shortNumber(facts.smallestEdge->length) + "\n";
    }
    if (facts.smallestAngle) {
        text += "smallest angle: " + shortNumber(facts.smallestAngle->degrees) + " degrees at " +
                nameOf(facts.smallestAngle->vertex) + " between " + nameOf(facts.smallestAngle->first) + " and " +
                nameOf(facts.smallestAngle->second) + "\n";
    }
    appendList(text, "sliver faces", facts.slivers, [](const SliverFact& sliver) {
        return nameOf(sliver.face) + ", width " + shortNumber(sliver.width) + ", perimeter " + shortNumber(sliver.perimeter);
    });
    appendList(text, "gaps", facts.gaps, [](const GapFact& gap) {
        return nameOf(gap.edge) + " lies " + shortNumber(gap.distance) + " off " + nameOf(gap.face);
    });
    appendList(text, "free edges", facts.freeEdges, edgeName);
    appendList(text, "edges of more than two face sides", facts.nonManifoldEdges, edgeName);
    appendList(text, "edges of no face", facts.looseEdges, edgeName);
    appendList(text, "notes", facts.notes, [](const std::string& note) { return note; });
    return text;
}

std::string jsonOf(const ModelFacts& facts)
{
    const auto edgeName = [](BrepEdgeId id) { return quoted(nameOf(id)); };
    JsonObject object;
    object.add("unit", quoted(facts.unit));
    object.add("solids", facts.solids).add("shells", facts.shells).add("open_shells", facts.openShells);
    object.add("faces", facts.faces).add("edges", facts.edges).add("vertices", facts.vertices);
    object.add("degenerate_edges", facts.degenerateEdges);
    object.add("faces_by_type", jsonCounts(facts.facesByType)).add("edges_by_type", jsonCounts(facts.edgesByType));
    object.add("box_low", jsonPoint(facts.box.low)).add("box_high", jsonPoint(facts.box.high));
    object.add("area", facts.area).add("length", facts.length);
    object.add("largest_tolerance", JsonObject()
                                        .add("value", facts.largestTolerance.value)
                                        .add("entity", quoted(facts.largestTolerance.entity))
                                        .text());
    object.add("loose_tolerances", facts.looseTolerances);
    if (facts.smallestEdge) {
        object.add("smallest_edge", JsonObject()
                                        .add("edge", quoted(nameOf(facts.smallestEdge->edge)))
                                        .add("length", facts.smallestEdge->length)
                                        .text());
    }
    if (const auto& angle = facts.smallestAngle) {
        const std::string edges = enclosed('[', quoted(nameOf(angle->first)) + ", " + quoted(nameOf(angle->second)), ']');
        object.add("smallest_angle", JsonObject()
                                         .add("vertex", quoted(nameOf(angle->vertex)))
                                         .add("edges", edges)
                                         .add("degrees", angle->degrees)
                                         .text());
    }
    object.add("sliver_faces", jsonList(facts.slivers, [](const SliverFact& sliver) {
                   return JsonObject().add("face", quoted(nameOf(sliver.face))).add("width", sliver.width)
                       .add("perimeter", sliver.perimeter).text();
               }));
    object.add("gaps", jsonList(facts.gaps, [](const GapFact& gap) {
                   return JsonObject().add("edge", quoted(nameOf(gap.edge))).add("face", quoted(nameOf(gap.face)))
                       .add("distance", gap.distance).text();
               }));
    object.add("free_edges", jsonList(facts.freeEdges, edgeName));
    object.add("non_manifold_edges", jsonList(facts.nonManifoldEdges, edgeName));
    object.add("loose_edges", jsonList(facts.looseEdges, edgeName));
    object.add("notes", jsonList(facts.notes, [](const std::string& note) { return quoted(note); }));
    return object.text();
}

}  // namespace mesher
