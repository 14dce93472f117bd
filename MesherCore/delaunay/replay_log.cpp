#include "delaunay/replay_log.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <system_error>

namespace mesher {
namespace {

struct KindName
{
    ReplayKind kind;
    std::string_view name;
};
constexpr KindName kNames[] = {{ReplayKind::Insert, "insert"},
                               {ReplayKind::Remove, "remove"},
                               {ReplayKind::RemoveFromChain, "remove_from_chain"},
                               {ReplayKind::Constrain, "constrain"},
                               {ReplayKind::Unconstrain, "unconstrain"}};

std::string_view nameOf(ReplayKind kind) { return kNames[static_cast<std::size_t>(kind)].name; }

void appendHexadecimal(std::string& text, double value)
{
    char buffer[40];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::hex);
    text.append(" ").append(buffer, end.ptr);
}

/// The words of a line, taken one by one.
class Words
{
public:
    explicit Words(std::string_view line) : rest_(line) {}

    std::string_view next()
    {
        const std::size_t begin = std::min(rest_.find_first_not_of(' '), rest_.size());
        const std::size_t end = std::min(rest_.find(' ', begin), rest_.size());
        const std::string_view word = rest_.substr(begin, end - begin);
        rest_.remove_prefix(end);
        return word;
    }

private:
    std::string_view rest_;
};

/// All of the word must be a number.
template <class Number, class... Format>
std::optional<Number> parse(std::string_view word, Format... format)
{
    Number value{};
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value, format...);
    if (word.empty() || result.ec != std::errc() || result.ptr != word.data() + word.size())
        return std::nullopt;
    return value;
}

bool hasRightShape(const ReplayOperation& operation)
{
    switch (operation.kind) {
        case ReplayKind::Insert: return operation.labelCount == 1 && operation.coordinateCount >= 2;
        case ReplayKind::Remove:
        case ReplayKind::RemoveFromChain: return operation.labelCount == 1 && operation.coordinateCount == 0;
        case ReplayKind::Constrain:
        case ReplayKind::Unconstrain: return operation.labelCount >= 2 && operation.coordinateCount == 0;
    }
    return false;
}

std::optional<ReplayOperation> parseLine(std::string_view line)
{
    Words words(line);
    const std::string_view name = words.next();
    ReplayOperation operation;
    const KindName* known =
        std::find_if(std::begin(kNames), std::end(kNames),
                     [name](const KindName& candidate) { return candidate.name == name; });
    if (known == std::end(kNames)) return std::nullopt;
    operation.kind = known->kind;
    const unsigned labels = operation.kind == ReplayKind::Insert ? 1 : 3;
    std::string_view word = words.next();
    for (; !word.empty() && operation.labelCount < labels; word = words.next()) {
        const auto label = parse<std::uint32_t>(word);
        if (!label) return std::nullopt;
        operation.labels[operation.labelCount++] = *label;
    }
    for (; !word.empty() && operation.coordinateCount < 3; word = words.next()) {
        const auto coordinate = parse<double>(word, std::chars_format::hex);
        if (!coordinate) return std::nullopt;
        operation.coordinates[operation.coordinateCount++] = *coordinate;
    }
    if (!word.empty() || !hasRightShape(operation)) return std::nullopt;
    return operation;
}

}  // namespace

ReplayOperation ReplayOperation::insert(std::uint32_t label, Vec2 point)
{
    return {ReplayKind::Insert, 1, 2, {label, 0, 0}, {point.x, point.y, 0.0}};
}

ReplayOperation ReplayOperation::insert(std::uint32_t label, Vec3 point)
{
    return {ReplayKind::Insert, 1, 3, {label, 0, 0}, {point.x, point.y, point.z}};
}

ReplayOperation ReplayOperation::on(ReplayKind kind, std::initializer_list<std::uint32_t> labels)
{
    MESHER_PRECONDITION(kind != ReplayKind::Insert && labels.size() <= 3);
    ReplayOperation operation;
    operation.kind = kind;
    for (const std::uint32_t label : labels) operation.labels[operation.labelCount++] = label;
    return operation;
}

std::string ReplayLog::toText() const
{
    std::string text;
    for (const ReplayOperation& operation : operations_) {
        text += nameOf(operation.kind);
        for (unsigned i = 0; i < operation.labelCount; ++i)
            text.append(" ").append(std::to_string(operation.labels[i]));
        for (unsigned i = 0; i < operation.coordinateCount; ++i)
            appendHexadecimal(text, operation.coordinates[i]);
        text += '\n';
    }
    return text;
}

Result<ReplayLog> ReplayLog::fromText(std::string_view text)
{
    ReplayLog log;
    for (std::size_t line = 1; !text.empty(); ++line) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const auto operation = parseLine(text.substr(0, end));
        if (!operation) {
            Error error;
            error.code = ErrorCode::Unreadable;
            error.message = "not an operation of a replay log";
            error.entity = "line " + std::to_string(line);
            return error;
        }
        log.add(*operation);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return log;
}

}  // namespace mesher
