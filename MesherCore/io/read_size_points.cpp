#include "io/read_size_points.h"

#include "io/read_whole_file.h"
#include "io/text_scanner.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace mesher {

namespace {

Error badLine(std::size_t line, const std::string& message)
{
    return {ErrorCode::Unreadable,
            "line " + std::to_string(line) + ": " + message,
            {},
            {},
            "write a line 'x y z size' for each point"};
}

Result<SizePoint> pointIn(std::string_view text, std::size_t line)
{
    TextScanner scanner(text);
    SizePoint point;
    point.position.x = scanner.real();
    point.position.y = scanner.real();
    point.position.z = scanner.real();
    point.size = scanner.real();
    if (scanner.failed() || !scanner.atEnd()) return badLine(line, "four numbers are expected");
    if (!isFinite(point.position)) return badLine(line, "the place is not finite");
    if (!(point.size > 0.0 && std::isfinite(point.size)))
        return badLine(line, "the size is no length above 0");
    return point;
}

}  // namespace

Result<std::vector<SizePoint>> readSizePointsText(std::string_view content)
{
    std::vector<SizePoint> points;
    std::size_t line = 0;
    while (!content.empty()) {
        ++line;
        const std::string_view whole = content.substr(0, content.find('\n'));
        content.remove_prefix(std::min(content.size(), whole.size() + 1));
        const std::string_view text = whole.substr(0, whole.find('#'));
        if (text.find_first_not_of(" \t\r") == std::string_view::npos) continue;
        const Result<SizePoint> point = pointIn(text, line);
        if (!point) return point.error();
        points.push_back(point.value());
    }
    if (points.empty()) return badLine(line, "the file ends without a point");
    return points;
}

Result<std::vector<SizePoint>> readSizePoints(const std::filesystem::path& path)
{
    const Result<std::string> content = readWholeFile(path);
    if (!content) return content.error();
    Result<std::vector<SizePoint>> points = readSizePointsText(content.value());
    if (points) return points;
    Error error = points.error();
    error.entity = path.string();
    return error;
}

}  // namespace mesher
