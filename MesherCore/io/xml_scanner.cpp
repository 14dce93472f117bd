#include "io/xml_scanner.h"

#include <algorithm>

namespace mesher {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";

std::string_view trimmedFront(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(kBlanks);
    return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

}  // namespace

std::string_view XmlTag::attribute(std::string_view wanted) const
{
    for (const auto& [key, value] : attributes) {
        if (key == wanted) return value;
    }
    return {};
}

void XmlScanner::fail(std::size_t offset, const std::string& message)
{
    failure_ = "offset " + std::to_string(offset) + ": " + message;
    position_ = text_.size();
}

std::string_view XmlScanner::content() const
{
    const std::size_t end = std::min(text_.find('<', position_), text_.size());
    return text_.substr(position_, end - position_);
}

/// Skips <?…?>, <!--…--> and <!…>; true if there was one at `open`.
bool XmlScanner::skipMarkup(std::size_t open)
{
    const std::string_view rest = text_.substr(open);
    std::string_view close;
    if (rest.starts_with("<?")) {
        close = "?>";
    } else if (rest.starts_with("<!--")) {
        close = "-->";
    } else if (rest.starts_with("<!")) {
        close = ">";
    } else {
        return false;
    }
    const std::size_t end = text_.find(close, open);
    if (end == std::string_view::npos) {
        fail(open, "the file ends inside of a comment or declaration");
    } else {
        position_ = end + close.size();
    }
    return true;
}

/// The '>' that closes the tag, which may also occur inside of quotation marks.
std::size_t XmlScanner::endOfTag(std::size_t open) const
{
    char quote = 0;
    for (std::size_t i = open; i < text_.size(); ++i) {
        const char c = text_[i];
        if (quote != 0) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '>') {
            return i;
        }
    }
    return std::string_view::npos;
}

bool XmlScanner::readAttributes(std::string_view inside, XmlTag& tag)
{
    for (inside = trimmedFront(inside); !inside.empty(); inside = trimmedFront(inside)) {
        const std::size_t equals = inside.find('=');
        if (equals == std::string_view::npos) return false;
        std::string_view key = inside.substr(0, equals);
        key = key.substr(0, std::min(key.find_first_of(kBlanks), key.size()));
        inside = trimmedFront(inside.substr(equals + 1));
        if (inside.empty() || (inside[0] != '"' && inside[0] != '\'')) return false;
        const std::size_t close = inside.find(inside[0], 1);
        if (close == std::string_view::npos) return false;
        tag.attributes.emplace_back(key, inside.substr(1, close - 1));
        inside = inside.substr(close + 1);
    }
    return true;
}

std::optional<XmlTag> XmlScanner::next()
{
    while (failure_.empty()) {
        const std::size_t open = text_.find('<', position_);
        if (open == std::string_view::npos) return std::nullopt;
        if (skipMarkup(open)) continue;
        const std::size_t close = endOfTag(open);
        if (close == std::string_view::npos) {
            fail(open, "the file ends inside of a tag");
            return std::nullopt;
        }
        XmlTag tag;
        tag.offset = open;
        std::string_view inside = text_.substr(open + 1, close - open - 1);
        tag.isClosing = inside.starts_with('/');
        if (tag.isClosing) inside.remove_prefix(1);
        tag.isEmpty = inside.ends_with('/');
        if (tag.isEmpty) inside.remove_suffix(1);
        const std::size_t nameEnd = std::min(inside.find_first_of(kBlanks), inside.size());
        tag.name = inside.substr(0, nameEnd);
        position_ = close + 1;
        if (tag.name.empty() || !readAttributes(inside.substr(nameEnd), tag)) {
            fail(open, "this is not a tag of XML");
            return std::nullopt;
        }
        return tag;
    }
    return std::nullopt;
}

}  // namespace mesher
