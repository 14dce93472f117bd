#pragma once

namespace mesher {

/// What every predicate returns.
enum class Sign : int
{
    Negative = -1,
    Zero = 0,
    Positive = 1
};

constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }
constexpr Sign operator*(Sign a, Sign b)
{
    return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b));
}
constexpr Sign signOf(double value)
{
    return value > 0.0 ? Sign::Positive : (value < 0.0 ? Sign::Negative : Sign::Zero);
}
/// The sign of a value that a filter has proven to differ from zero.
constexpr Sign signOfNonZero(double value) { return value > 0.0 ? Sign::Positive : Sign::Negative; }

}  // namespace mesher
