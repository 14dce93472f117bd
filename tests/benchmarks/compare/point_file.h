#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

// The file that hands one point set to every program under comparison: the eight characters of the magic, the
// dimension as 32 bits, the number of points as 64 bits, the coordinates as doubles, all little-endian. This header
// stands alone: programs that link a GPL library include it and nothing of the core.

namespace compare {

inline constexpr std::array<char, 8> kMagic = {'M', 'E', 'S', 'H', 'P', 'T', 'S', '1'};

struct PointFile
{
    std::uint32_t dimension = 0;
    std::vector<double> coordinates;  ///< point by point

    [[nodiscard]] std::size_t count() const { return dimension == 0 ? 0 : coordinates.size() / dimension; }
    [[nodiscard]] const double* point(std::size_t i) const { return coordinates.data() + i * dimension; }
};

/// False if the file cannot be written completely.
inline bool writePointFile(const std::string& path, std::uint32_t dimension,
                           std::span<const double> coordinates)
{
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) return false;
    const std::uint64_t count = coordinates.size() / dimension;
    bool isWritten = std::fwrite(kMagic.data(), kMagic.size(), 1, file) == 1;
    isWritten = isWritten && std::fwrite(&dimension, sizeof dimension, 1, file) == 1;
    isWritten = isWritten && std::fwrite(&count, sizeof count, 1, file) == 1;
    isWritten = isWritten && std::fwrite(coordinates.data(), sizeof(double), coordinates.size(), file) ==
                                 coordinates.size();
    return std::fclose(file) == 0 && isWritten;
}

/// False if there is no such file or it is not complete.
inline bool readPointFile(const std::string& path, PointFile& points)
{
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (file == nullptr) return false;
    std::array<char, 8> magic{};
    std::uint64_t count = 0;
    bool isRead = std::fread(magic.data(), magic.size(), 1, file) == 1 && magic == kMagic;
    isRead = isRead && std::fread(&points.dimension, sizeof points.dimension, 1, file) == 1;
    isRead = isRead && (points.dimension == 2 || points.dimension == 3);
    isRead = isRead && std::fread(&count, sizeof count, 1, file) == 1;
    if (isRead) {
        points.coordinates.resize(count * points.dimension);
        isRead = std::fread(points.coordinates.data(), sizeof(double), points.coordinates.size(), file) ==
                 points.coordinates.size();
    }
    std::fclose(file);
    return isRead;
}

}  // namespace compare
