#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mesher {

/// A tag of an XML text: <name a="b">, <name/> or </name>.
struct XmlTag
{
    std::string_view name;
    std::vector<std::pair<std::string_view, std::string_view>> attributes;
    bool isClosing = false;
    bool isEmpty = false;
    std::size_t offset = 0;  ///< of its '<'

    /// Empty if there is no such attribute.
    [[nodiscard]] std::string_view attribute(std::string_view wanted) const;
};

/// Goes through the tags of an XML text; comments, declarations and the like are skipped, entities in attributes are not resolved.
class XmlScanner
{
public:
    explicit XmlScanner(std::string_view text) : text_(text) {}

    /// The next tag; nothing at the end of the text or at what is no tag (`failure` is then not empty).
    [[nodiscard]] std::optional<XmlTag> next();
    /// From behind the last tag up to the next '<'.
    [[nodiscard]] std::string_view content() const;
    /// Offset behind the last tag.
    [[nodiscard]] std::size_t position() const { return position_; }
    [[nodiscard]] const std::string& failure() const { return failure_; }

private:
    bool skipMarkup(std::size_t open);
    bool readAttributes(std::string_view inside, XmlTag& tag);
    [[nodiscard]] std::size_t endOfTag(std::size_t open) const;
    void fail(std::size_t offset, const std::string& message);

    std::string_view text_;
    std::size_t position_ = 0;
    std::string failure_;
};

}  // namespace mesher
