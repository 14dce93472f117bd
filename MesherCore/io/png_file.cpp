#include "io/png_file.h"

#include "base/assert.h"

#include <zlib.h>

#include <array>
#include <span>

namespace mesher {

namespace {

using Byte = unsigned char;

void appendBigEndian(std::uint32_t value, std::vector<Byte>& bytes)
{
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<Byte>(value >> shift));
}

void writeChunk(std::string_view type, std::span<const Byte> data, FileBuffer& out)
{
    std::vector<Byte> chunk;
    appendBigEndian(static_cast<std::uint32_t>(data.size()), chunk);
    chunk.insert(chunk.end(), type.begin(), type.end());
    chunk.insert(chunk.end(), data.begin(), data.end());
    const uLong check = crc32(0, chunk.data() + 4, static_cast<uInt>(chunk.size() - 4));
    appendBigEndian(static_cast<std::uint32_t>(check), chunk);
    out.append({reinterpret_cast<const char*>(chunk.data()), chunk.size()});
}

/// Each row behind the number of its filter: 0, none.
std::vector<Byte> rowsOf(const Image& image)
{
    std::vector<Byte> rows;
    rows.reserve((3 * image.width + 1) * image.height);
    for (std::size_t y = 0; y < image.height; ++y) {
        rows.push_back(0);
        for (std::size_t x = 0; x < image.width; ++x) {
            const Colour& colour = image.at(x, y);
            rows.insert(rows.end(), {colour.red, colour.green, colour.blue});
        }
    }
    return rows;
}

}  // namespace

void writePngFile(const Image& image, FileBuffer& out)
{
    const std::vector<Byte> rows = rowsOf(image);
    uLongf length = compressBound(rows.size());
    std::vector<Byte> packed(length);
    const int code = compress2(packed.data(), &length, rows.data(), rows.size(), 6);
    MESHER_INVARIANT(code == Z_OK);
    static_cast<void>(code);
    packed.resize(length);

    std::vector<Byte> header;
    appendBigEndian(static_cast<std::uint32_t>(image.width), header);
    appendBigEndian(static_cast<std::uint32_t>(image.height), header);
    header.insert(header.end(), {8, 2, 0, 0, 0});  // bits, true colour, deflate, filters, not interlaced
    constexpr std::array<char, 8> kSignature = {'\x89', 'P', 'N', 'G', '\r', '\n', '\x1a', '\n'};
    out.append(kSignature);
    writeChunk("IHDR", header, out);
    writeChunk("IDAT", packed, out);
    writeChunk("IEND", {}, out);
}

}  // namespace mesher
