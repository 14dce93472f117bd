#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace compare {

/// What a program prints about one run (Measurement::print).
struct Report
{
    double cpuSeconds = 0.0;
    double vertices = 0.0;
    double simplices = 0.0;
    double bytesPerSimplex = 0.0;
    double scaffold = 0.0;
};

[[nodiscard]] bool isKnownProgram(const std::string& program);
[[nodiscard]] bool supportsDimension(const std::string& program, std::uint32_t dimension);

/// Runs the program of that name from the folder on a point file; none if it fails or prints something else.
std::optional<Report> runProgram(const std::filesystem::path& folder, const std::string& program,
                                 const std::string& pointFile);

}  // namespace compare
