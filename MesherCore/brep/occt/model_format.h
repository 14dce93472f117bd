#pragma once

#include <optional>
#include <string_view>

namespace mesher {

enum class ModelFormat
{
    Step,
    Iges,
    BrepText,
    BrepBinary  ///< of OCCT or of FreeCAD's exportBinary
};

[[nodiscard]] std::string_view nameOf(ModelFormat format);

/// What the content is, whatever the file is called; nothing if none of the formats begins like it.
[[nodiscard]] std::optional<ModelFormat> recogniseFormat(std::string_view content);

/// What is missing at the end of a file that begins well, as a clause; nothing if it is whole as far as its end tells.
[[nodiscard]] std::optional<std::string_view> findTruncation(ModelFormat format, std::string_view content);

}  // namespace mesher
