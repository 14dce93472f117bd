#pragma once

#include "base/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mesher {

enum class VtuEncoding
{
    Text,
    Base64,
    Raw
};

/// A <DataArray>: where its values stand and how they are written.
struct VtuArraySource
{
    std::string_view section;  ///< name of the element around it: "Points", "CellData", …
    std::string_view name;
    std::string_view type;  ///< "Float64", "UInt8", …
    std::size_t components = 1;
    VtuEncoding encoding = VtuEncoding::Text;
    std::string_view data;   ///< begins with the array's; appended data go on behind it
    std::size_t offset = 0;  ///< of the tag in the file, for messages
};

/// How binary data are packed in the whole file.
struct VtuPacking
{
    std::size_t headerSize = 4;  ///< bytes of a number of a block's header
    bool isCompressed = false;   ///< by zlib
};

[[nodiscard]] Result<std::vector<double>> readReals(const VtuArraySource& source, const VtuPacking& packing);
[[nodiscard]] Result<std::vector<std::int64_t>> readIntegers(const VtuArraySource& source,
                                                             const VtuPacking& packing);

/// An error of reading with the offset in the file.
[[nodiscard]] Error unreadableAt(std::size_t offset, const std::string& message);

}  // namespace mesher
