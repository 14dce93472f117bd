#include "cli/size_syntax.h"

#include "cli/option_reader.h"
#include "mesh/classified_mesh.h"

#include <charconv>
#include <optional>

namespace mesher {

namespace {

std::optional<std::vector<double>> numbersIn(const std::string& text)
{
    std::vector<double> numbers;
    for (const std::string& part : splitAtCommas(text)) {
        double value = 0.0;
        const char* last = part.data() + part.size();
        const auto [end, code] = std::from_chars(part.data(), last, value);
        if (code != std::errc() || end != last || part.empty()) return std::nullopt;
        numbers.push_back(value);
    }
    return numbers;
}

/// What stands before the last equals sign of a text, and the numbers behind it.
struct Assignment
{
    std::string place;
    std::vector<double> numbers;
};

/// Nothing unless there are from `least` to `most` numbers.
std::optional<Assignment> assignmentIn(const std::string& text, std::size_t least, std::size_t most)
{
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos) return std::nullopt;
    const std::optional<std::vector<double>> numbers = numbersIn(text.substr(equals + 1));
    if (!numbers || numbers->size() < least || numbers->size() > most) return std::nullopt;
    return Assignment{text.substr(0, equals), *numbers};
}

std::optional<double> growthOf(const Assignment& assignment)
{
    return assignment.numbers.size() > 1 ? std::optional(assignment.numbers[1]) : std::nullopt;
}

Error notOfForm(const char* option, const char* form, const std::string& text)
{
    return usageError(std::string("--").append(option).append(" wants ").append(form) + ", not '" + text +
                      "'");
}

}  // namespace

std::vector<std::string> splitAtCommas(const std::string& text)
{
    std::vector<std::string> parts;
    std::size_t begin = 0;
    for (std::size_t comma = 0; comma != std::string::npos; begin = comma + 1) {
        comma = text.find(',', begin);
        parts.push_back(text.substr(begin, comma == std::string::npos ? comma : comma - begin));
    }
    return parts;
}

Result<LocalSize> localSizeIn(const std::string& text)
{
    const std::optional<Assignment> found = assignmentIn(text, 1, 1);
    if (!found || !entityNamed(found->place))
        return notOfForm("local-size", "an entity and a size like Face6=0.5", text);
    return LocalSize{found->place, found->numbers[0]};
}

Result<SizeByDistance> sizeByDistanceIn(const std::string& text)
{
    const std::optional<Assignment> found = assignmentIn(text, 2, 3);
    if (!found || !entityNamed(found->place)) {
        return notOfForm("size-distance",
                         "an entity, a size, its growth and perhaps the distance from which on it grows, "
                         "like Edge3=0.1,0.2 or Edge3=0.1,0.2,1",
                         text);
    }
    const std::vector<double>& numbers = found->numbers;
    return SizeByDistance{found->place, numbers[0], numbers[1], numbers.size() > 2 ? numbers[2] : 0.0};
}

Result<SizeInBox> sizeInBoxIn(const std::string& text)
{
    const std::optional<Assignment> found = assignmentIn(text, 1, 2);
    const std::optional<std::vector<double>> box = found ? numbersIn(found->place) : std::nullopt;
    if (!box || box->size() != 6) {
        return notOfForm("size-box",
                         "two corners, a size and perhaps its growth outside, like 0,0,0,1,1,1=0.1 or "
                         "0,0,0,1,1,1=0.1,0.2",
                         text);
    }
    const std::vector<double>& b = *box;
    return SizeInBox{{b[0], b[1], b[2]}, {b[3], b[4], b[5]}, found->numbers[0], growthOf(*found)};
}

Result<SizeInBall> sizeInBallIn(const std::string& text)
{
    const std::optional<Assignment> found = assignmentIn(text, 1, 2);
    const std::optional<std::vector<double>> ball = found ? numbersIn(found->place) : std::nullopt;
    if (!ball || ball->size() != 4) {
        return notOfForm("size-ball",
                         "a centre, a radius, a size and perhaps its growth outside, like 0,0,0,1=0.1 or "
                         "0,0,0,1=0.1,0.2",
                         text);
    }
    const std::vector<double>& b = *ball;
    return SizeInBall{{b[0], b[1], b[2]}, b[3], found->numbers[0], growthOf(*found)};
}

}  // namespace mesher
