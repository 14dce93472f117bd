#pragma once

#include "predicates/sign.h"

#include <array>
#include <cmath>
#include <cstddef>

/// Exact sums and products of doubles as expansions: unevaluated sums of doubles that do not overlap.
///
/// Guarantees  sums and scalings are exact; components are ordered by increasing magnitude, none is zero, and
///             they are strongly nonoverlapping, so the last one has the sign of the whole
/// Requires    rounding to nearest even; no overflow, and every product a multiple of 2^-1074: the exact
///             range (coordinate_range.h) grants both for products of up to five coordinates
/// Reference   [shewchuk1997] theorems 6, 7, 13, 18, 19 (two-sum, fast-two-sum, expansion sum, two-product,
///             scaling)
namespace mesher::detail {

/// A value and the roundoff that was lost in computing it: their sum is exact.
struct TwoTerm
{
    double value;
    double roundoff;
};

inline TwoTerm twoSum(double a, double b)
{
    const double sum = a + b;
    const double partB = sum - a;
    const double partA = sum - partB;
    return {sum, (a - partA) + (b - partB)};
}

/// Requires |a| >= |b| or a == 0.
inline TwoTerm fastTwoSum(double a, double b)
{
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// Splits a double into a high part of at most 26 bits and a low part of at most 26 bits.
struct SplitDouble
{
    double high;
    double low;

    explicit SplitDouble(double a)
    {
        const double shifted = 0x8000001p0 * a;
        high = shifted - (shifted - a);
        low = a - high;
    }
};

inline TwoTerm twoProduct(double a, double b, SplitDouble splitB)
{
    const double product = a * b;
    const SplitDouble splitA(a);
    const double error1 = product - splitA.high * splitB.high;
    const double error2 = error1 - splitA.low * splitB.high;
    const double error3 = error2 - splitA.high * splitB.low;
    return {product, splitA.low * splitB.low - error3};
}

/// A stack-held expansion of at most `Capacity` components.
template <std::size_t Capacity>
class Expansion
{
public:
    Expansion() : size_(0) {}

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] double operator[](std::size_t i) const { return component_[i]; }
    [[nodiscard]] Sign sign() const { return size_ == 0 ? Sign::Zero : signOf(component_[size_ - 1]); }

    /// Appends a component larger than all before; zero is left out.
    void append(double component)
    {
        component_[size_] = component;
        size_ += component != 0.0 ? 1 : 0;
    }

private:
    std::size_t size_;
    // One more than the capacity: `append` writes before it knows whether the component counts.
    std::array<double, Capacity + 1> component_;
};

inline Expansion<2> product(double a, double b)
{
    const TwoTerm term = twoProduct(a, b, SplitDouble(b));
    Expansion<2> result;
    result.append(term.roundoff);
    result.append(term.value);
    return result;
}

/// Yields the components of a + sign * b by increasing magnitude.
template <std::size_t M, std::size_t N>
class MergedComponents
{
public:
    MergedComponents(const Expansion<M>& a, const Expansion<N>& b, double signOfB)
        : a_(a), b_(b), signOfB_(signOfB)
    {
    }

    [[nodiscard]] bool isDone() const { return i_ == a_.size() && j_ == b_.size(); }
    double next()
    {
        const bool fromA = j_ == b_.size() || (i_ != a_.size() && std::abs(a_[i_]) < std::abs(b_[j_]));
        return fromA ? a_[i_++] : signOfB_ * b_[j_++];
    }

private:
    const Expansion<M>& a_;
    const Expansion<N>& b_;
    double signOfB_;
    std::size_t i_ = 0;
    std::size_t j_ = 0;
};

template <std::size_t M, std::size_t N>
Expansion<M + N> sumWithSign(const Expansion<M>& a, const Expansion<N>& b, double signOfB)
{
    Expansion<M + N> result;
    MergedComponents<M, N> components(a, b, signOfB);
    if (components.isDone()) return result;
    double running = components.next();
    while (!components.isDone()) {
        const TwoTerm step = twoSum(running, components.next());
        result.append(step.roundoff);
        running = step.value;
    }
    result.append(running);
    return result;
}

template <std::size_t M, std::size_t N>
Expansion<M + N> operator+(const Expansion<M>& a, const Expansion<N>& b)
{
    return sumWithSign(a, b, 1.0);
}
template <std::size_t M, std::size_t N>
Expansion<M + N> operator-(const Expansion<M>& a, const Expansion<N>& b)
{
    return sumWithSign(a, b, -1.0);
}

template <std::size_t N>
Expansion<2 * N> operator*(const Expansion<N>& a, double factor)
{
    Expansion<2 * N> result;
    if (a.size() == 0 || factor == 0.0) return result;
    const SplitDouble split(factor);
    const TwoTerm first = twoProduct(a[0], factor, split);
    result.append(first.roundoff);
    double running = first.value;
    for (std::size_t i = 1; i < a.size(); ++i) {
        const TwoTerm term = twoProduct(a[i], factor, split);
        const TwoTerm low = twoSum(running, term.roundoff);
        result.append(low.roundoff);
        const TwoTerm high = fastTwoSum(term.value, low.value);
        result.append(high.roundoff);
        running = high.value;
    }
    result.append(running);
    return result;
}

}  // namespace mesher::detail
