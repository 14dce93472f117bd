#pragma once

#include <cstdint>

namespace mesher {

/// splitmix64: a small deterministic generator, the same on every platform. Always seeded by the caller.
class Random
{
public:
    using result_type = std::uint64_t;

    constexpr explicit Random(std::uint64_t seed) : state_(seed) {}

    constexpr std::uint64_t operator()()
    {
        std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }

    /// Uniform in [0, bound); the bias of the multiply-shift is below bound / 2^32.
    constexpr std::uint32_t below(std::uint32_t bound)
    {
        return static_cast<std::uint32_t>(((operator()() >> 32) * bound) >> 32);
    }
    /// Uniform in [0, 1) with 53 random bits.
    constexpr double unit() { return static_cast<double>(operator()() >> 11) * 0x1p-53; }
    constexpr double between(double low, double high) { return low + (high - low) * unit(); }

    static constexpr std::uint64_t min() { return 0; }
    static constexpr std::uint64_t max() { return ~std::uint64_t{0}; }

private:
    std::uint64_t state_;
};

}  // namespace mesher
