#include "brep/occt/model_format.h"

#include "base/assert.h"

#include <algorithm>
#include <cstddef>

namespace mesher {

namespace {

/// A STEP file may begin with comments, a BREP file with a line of its own.
constexpr std::size_t kHeadLength = 4096;
constexpr std::size_t kTailLength = 4096;
/// An IGES line has 80 columns; the letter of its section is in the 73rd.
constexpr std::size_t kIgesSectionColumn = 72;

bool contains(std::string_view text, std::string_view word)
{
    return text.find(word) != std::string_view::npos;
}

bool looksLikeIges(std::string_view content)
{
    const std::size_t end = content.find_first_of("\r\n");
    if (end == std::string_view::npos || end <= kIgesSectionColumn) return false;
    const char section = content[kIgesSectionColumn];
    const std::string_view number = content.substr(kIgesSectionColumn + 1, end - kIgesSectionColumn - 1);
    return (section == 'S' || section == 'C') && number.find_first_not_of(" 0123456789") == std::string_view::npos;
}

}  // namespace

std::string_view nameOf(ModelFormat format)
{
    switch (format) {
        case ModelFormat::Step: return "STEP";
        case ModelFormat::Iges: return "IGES";
        case ModelFormat::BrepText: return "BREP text";
        case ModelFormat::BrepBinary: return "BREP binary";
    }
    MESHER_INVARIANT(false);
    return "";
}

std::optional<ModelFormat> recogniseFormat(std::string_view content)
{
    const std::string_view head = content.substr(0, kHeadLength);
    // "Open CASCADE Topology" of the binary form contains the words of the text form.
    if (contains(head.substr(0, 64), "Open CASCADE Topology V")) return ModelFormat::BrepBinary;
    if (contains(head, "DBRep_DrawableShape") || contains(head.substr(0, 256), "CASCADE Topology V")) {
        return ModelFormat::BrepText;
    }
    if (contains(head, "ISO-10303-21")) return ModelFormat::Step;
    if (looksLikeIges(content)) return ModelFormat::Iges;
    return {};
}

std::optional<std::string_view> findTruncation(ModelFormat format, std::string_view content)
{
    const std::string_view tail = content.substr(content.size() - std::min(content.size(), kTailLength));
    if (format == ModelFormat::Step && !contains(tail, "END-ISO-10303-21")) return "END-ISO-10303-21 is missing";
    if (format == ModelFormat::BrepText && !contains(content, "\nTShapes ")) return "its shapes are missing";
    if (format == ModelFormat::Iges) {
        const std::size_t end = tail.find_last_not_of(" \r\n");
        const std::size_t line = end == std::string_view::npos ? end : tail.find_last_of("\r\n", end);
        const std::size_t begin = line == std::string_view::npos ? 0 : line + 1;
        const bool isTerminated = tail.size() > begin + kIgesSectionColumn && tail[begin + kIgesSectionColumn] == 'T';
        if (!isTerminated) return "its terminate section is missing";
    }
    return {};
}

}  // namespace mesher
