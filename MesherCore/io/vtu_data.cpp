#include "io/vtu_data.h"

#include "io/base64.h"
#include "io/text_scanner.h"

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <span>
#include <type_traits>

namespace mesher {

namespace {

using Bytes = std::vector<std::byte>;

/// zlib cannot pack more tightly: an announced size above this factor is a lie.
constexpr std::size_t kLargestCompression = 1100;

constexpr std::string_view kCutOff = "the data of the array are cut off or broken";

std::uint64_t headerNumber(std::span<const std::byte> bytes, std::size_t size)
{
    std::uint64_t value = 0;
    std::memcpy(&value, bytes.data(), size);  // little endian, as the file is
    return value;
}

/// Gives bytes from base64 text or from raw data, one unit after another: each unit of base64 is padded for itself.
class PackedInput
{
public:
    explicit PackedInput(const VtuArraySource& source)
        : data_(source.data), isBase64_(source.encoding == VtuEncoding::Base64)
    {
        if (isBase64_) skipBlanks();
    }

    /// The first `size` bytes without going on.
    [[nodiscard]] std::optional<Bytes> peek(std::size_t size) const
    {
        if (!isBase64_) return size <= data_.size() ? std::optional(rawBytes(size)) : std::nullopt;
        const std::size_t length = base64Length(size);
        std::size_t used = 0;
        if (length > data_.size()) return std::nullopt;
        std::optional<Bytes> bytes = decodeBase64(data_.substr(0, length), used);
        if (bytes && bytes->size() < size) return std::nullopt;
        return bytes;
    }
    /// Whether the unit ends after `size` bytes.
    [[nodiscard]] bool isPaddedAfter(std::size_t size) const
    {
        return isBase64_ && size % 3 != 0 && data_.substr(0, base64Length(size)).ends_with('=');
    }
    [[nodiscard]] std::optional<Bytes> take(std::size_t size)
    {
        if (size > data_.size()) return std::nullopt;  // also keeps base64Length from overflowing
        std::optional<Bytes> bytes = peek(size);
        if (!bytes) return std::nullopt;
        bytes->resize(size);
        data_.remove_prefix(isBase64_ ? base64Length(size) : size);
        return bytes;
    }
    [[nodiscard]] std::size_t room() const { return data_.size(); }

private:
    void skipBlanks() { data_.remove_prefix(std::min(data_.find_first_not_of(" \t\r\n"), data_.size())); }
    [[nodiscard]] Bytes rawBytes(std::size_t size) const
    {
        Bytes bytes(size);
        if (size > 0) std::memcpy(bytes.data(), data_.data(), size);
        return bytes;
    }

    std::string_view data_;
    bool isBase64_;
};

std::optional<Bytes> unpackPlain(PackedInput input, std::size_t headerSize)
{
    const std::optional<Bytes> header = input.peek(headerSize);
    if (!header) return std::nullopt;
    const std::uint64_t size = headerNumber(*header, headerSize);
    if (size > input.room()) return std::nullopt;
    if (input.isPaddedAfter(headerSize)) {
        if (!input.take(headerSize)) return std::nullopt;
        return input.take(static_cast<std::size_t>(size));
    }
    std::optional<Bytes> both = input.take(headerSize + static_cast<std::size_t>(size));
    if (both) both->erase(both->begin(), both->begin() + static_cast<std::ptrdiff_t>(headerSize));
    return both;
}

bool inflateBlock(std::span<const std::byte> packed, std::size_t size, Bytes& out)
{
    const std::size_t before = out.size();
    out.resize(before + size);
    uLongf length = size;
    const int code = uncompress(reinterpret_cast<Bytef*>(out.data() + before), &length,
                                reinterpret_cast<const Bytef*>(packed.data()), packed.size());
    return code == Z_OK && length == size;
}

/// Header: number of blocks, size of a block, size of the last one if it is shorter, then the packed size of each.
std::optional<Bytes> unpackCompressed(PackedInput input, std::size_t headerSize)
{
    const std::optional<Bytes> first = input.peek(headerSize);
    if (!first) return std::nullopt;
    const std::uint64_t blockCount = headerNumber(*first, headerSize);
    if (blockCount > input.room() / headerSize) return std::nullopt;
    const std::optional<Bytes> header = input.take((3 + static_cast<std::size_t>(blockCount)) * headerSize);
    if (!header) return std::nullopt;
    const auto number = [&](std::size_t i) {
        return headerNumber(std::span(*header).subspan(i * headerSize), headerSize);
    };
    std::uint64_t packedSize = 0;
    for (std::size_t b = 0; b < blockCount; ++b) {
        if (number(3 + b) > input.room()) return std::nullopt;
        packedSize += number(3 + b);
    }
    if (packedSize > input.room()) return std::nullopt;
    const std::optional<Bytes> packed = input.take(static_cast<std::size_t>(packedSize));
    if (!packed) return std::nullopt;
    Bytes bytes;
    std::size_t at = 0;
    for (std::size_t b = 0; b < blockCount; ++b) {
        const bool isShortLast = b + 1 == blockCount && number(2) != 0;
        const std::uint64_t size = isShortLast ? number(2) : number(1);
        const auto length = static_cast<std::size_t>(number(3 + b));
        if (size / kLargestCompression > length) return std::nullopt;
        if (!inflateBlock(std::span(*packed).subspan(at, length), static_cast<std::size_t>(size), bytes)) {
            return std::nullopt;
        }
        at += length;
    }
    return bytes;
}

Error arrayError(const VtuArraySource& source, std::string_view message)
{
    return unreadableAt(source.offset,
                        "array '" + std::string(source.name.substr(0, 40)) + "': " + std::string(message));
}

template <class Stored, class Value>
bool convert(const Bytes& bytes, std::vector<Value>& values)
{
    if (bytes.size() % sizeof(Stored) != 0) return false;
    values.resize(bytes.size() / sizeof(Stored));
    for (std::size_t i = 0; i < values.size(); ++i) {
        Stored stored;
        std::memcpy(&stored, bytes.data() + i * sizeof(Stored), sizeof(Stored));
        values[i] = static_cast<Value>(stored);
    }
    return true;
}

template <class Value>
bool convert(std::string_view type, const Bytes& bytes, std::vector<Value>& values)
{
    if (type == "Int8") return convert<std::int8_t>(bytes, values);
    if (type == "UInt8") return convert<std::uint8_t>(bytes, values);
    if (type == "Int16") return convert<std::int16_t>(bytes, values);
    if (type == "UInt16") return convert<std::uint16_t>(bytes, values);
    if (type == "Int32") return convert<std::int32_t>(bytes, values);
    if (type == "UInt32") return convert<std::uint32_t>(bytes, values);
    if (type == "Int64") return convert<std::int64_t>(bytes, values);
    if (type == "UInt64") return convert<std::uint64_t>(bytes, values);
    if constexpr (std::is_floating_point_v<Value>) {
        if (type == "Float32") return convert<float>(bytes, values);
        if (type == "Float64") return convert<double>(bytes, values);
    }
    return false;
}

template <class Value>
Result<std::vector<Value>> readText(const VtuArraySource& source)
{
    std::vector<Value> values;
    TextScanner in(source.data);
    while (!in.failed() && !in.atEnd()) {
        if constexpr (std::is_floating_point_v<Value>) {
            values.push_back(in.real());
        } else {
            values.push_back(in.integer());
        }
    }
    if (in.failed()) return arrayError(source, in.failure().message);
    return values;
}

template <class Value>
Result<std::vector<Value>> readValues(const VtuArraySource& source, const VtuPacking& packing)
{
    if (source.encoding == VtuEncoding::Text) return readText<Value>(source);
    const PackedInput input(source);
    const std::optional<Bytes> bytes = packing.isCompressed ? unpackCompressed(input, packing.headerSize)
                                                            : unpackPlain(input, packing.headerSize);
    if (!bytes) return arrayError(source, kCutOff);
    std::vector<Value> values;
    if (!convert(source.type, *bytes, values)) {
        return arrayError(source,
                          "the type '" + std::string(source.type.substr(0, 20)) + "' does not fit its data");
    }
    return values;
}

}  // namespace

Result<std::vector<double>> readReals(const VtuArraySource& source, const VtuPacking& packing)
{
    return readValues<double>(source, packing);
}

Result<std::vector<std::int64_t>> readIntegers(const VtuArraySource& source, const VtuPacking& packing)
{
    return readValues<std::int64_t>(source, packing);
}

Error unreadableAt(std::size_t offset, const std::string& message)
{
    return {ErrorCode::Unreadable, "offset " + std::to_string(offset) + ": " + message, {}, {}, {}};
}

}  // namespace mesher
