#pragma once

#include "base/vec.h"
#include "predicates/sign.h"

#include <gmpxx.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

/// The predicates over again in GMP integers, from their geometric meaning and by formulas that the library
/// does not use: relative to the first point, with the centre of the sphere by Cramer's rule. The perturbed
/// versions raise the lifts by true powers of a number that exceeds every quotient of minors, instead of by
/// symbols.
namespace mesher::test {

/// Coordinates as integers in units of the finest bit among them.
class IntegerPoints
{
public:
    explicit IntegerPoints(const std::vector<double>& coordinates)
    {
        int finest = 5000;
        std::vector<std::pair<std::int64_t, int>> parts;
        for (const double coordinate : coordinates) {
            int exponent = 0;
            auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(coordinate, &exponent), 53));
            if (mantissa != 0) {
                const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
                mantissa /= std::int64_t{1} << zeros;
                exponent += zeros;
                finest = std::min(finest, exponent);
            }
            parts.emplace_back(mantissa, exponent);
        }
        for (const auto& [mantissa, exponent] : parts) {
            mpz_class value = static_cast<long>(mantissa);
            if (mantissa != 0) value <<= static_cast<unsigned long>(exponent - finest);
            bits_ = std::max(bits_, mpz_sizeinbase(value.get_mpz_t(), 2));
            coordinates_.push_back(std::move(value));
        }
    }

    [[nodiscard]] const mpz_class& operator[](std::size_t i) const { return coordinates_[i]; }
    [[nodiscard]] std::size_t bits() const { return bits_; }

private:
    std::vector<mpz_class> coordinates_;
    std::size_t bits_ = 1;
};

inline Sign signOf(const mpz_class& value) { return static_cast<Sign>(sgn(value)); }

template <class Point>
std::vector<double> flatten(const std::vector<Point>& points)
{
    std::vector<double> coordinates;
    for (const Point& p : points) {
        coordinates.push_back(p.x);
        coordinates.push_back(p.y);
        if constexpr (requires { p.z; }) coordinates.push_back(p.z);
    }
    return coordinates;
}

/// How many of the points are lexicographically smaller than each: equal points share a rank.
template <class Point>
std::vector<unsigned long> ranks(const std::vector<Point>& points)
{
    std::vector<unsigned long> result;
    for (const Point& p : points) {
        unsigned long smaller = 0;
        for (const Point& q : points) smaller += isLexicographicallyLess(q, p) ? 1 : 0;
        result.push_back(smaller);
    }
    return result;
}

/// For points in space (3) or the plane (2): d + 1 points make an orientation, d + 2 a sphere test.
template <std::size_t Dimension, class Point>
class ExactOracle
{
public:
    explicit ExactOracle(const std::vector<Point>& points) : points_(points), grid_(flatten(points))
    {
        for (std::size_t i = 1; i < points.size(); ++i) {
            Row row;
            for (std::size_t k = 0; k < Dimension; ++k) {
                row[k] = grid_[Dimension * i + k] - grid_[k];
            }
            rows_.push_back(std::move(row));
        }
    }

    [[nodiscard]] Sign orientation() const { return signOf(simplexDeterminant()); }

    [[nodiscard]] Sign sphere() const
    {
        std::vector<mpz_class> lifts;
        for (const Row& row : rows_) lifts.push_back(lengthOf(row));
        return sphereOf(lifts);
    }

    [[nodiscard]] Sign perturbedSphere() const
    {
        // A minor of the lift column has at most 24 terms of Dimension factors below 2^(bits + 1).
        const unsigned long digit = Dimension * (grid_.bits() + 1) + 8;
        const std::vector<unsigned long> rank = ranks(points_);
        std::vector<mpz_class> lifts;
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            mpz_class lift = lengthOf(rows_[i]) << (digit * (points_.size() + 1));
            lift += mpz_class(1) << (digit * rank[i + 1]);
            lift -= mpz_class(1) << (digit * rank[0]);
            lifts.push_back(std::move(lift));
        }
        return sphereOf(lifts);
    }

private:
    using Row = std::array<mpz_class, Dimension>;

    static mpz_class lengthOf(const Row& row)
    {
        mpz_class sum = 0;
        for (const mpz_class& x : row) sum += x * x;
        return sum;
    }

    static mpz_class determinant(const Row& u, const Row& v, const Row& w)
    {
        mpz_class sum = u[0] * (v[1] * w[2] - v[2] * w[1]);
        sum -= v[0] * (u[1] * w[2] - u[2] * w[1]);
        sum += w[0] * (u[1] * v[2] - u[2] * v[1]);
        return sum;
    }
    static mpz_class determinant(const std::array<mpz_class, 2>& u, const std::array<mpz_class, 2>& v)
    {
        return u[0] * v[1] - u[1] * v[0];
    }

    [[nodiscard]] mpz_class simplexDeterminant() const
    {
        if constexpr (Dimension == 3)
            return determinant(rows_[0], rows_[1], rows_[2]);
        else
            return determinant(rows_[0], rows_[1]);
    }

    /// The sphere through the first points is |x|^2 = 2 k x, where Cramer's rule gives 2 k in units of one
    /// over the simplex' determinant; the last point s is inside iff 2 k s - |s|^2 > 0 for a positive
    /// determinant.
    [[nodiscard]] Sign sphereOf(const std::vector<mpz_class>& lifts) const
    {
        const Row& last = rows_[Dimension];
        mpz_class sum = -lifts[Dimension] * simplexDeterminant();
        for (std::size_t k = 0; k < Dimension; ++k) {
            std::array<Row, Dimension> columns;
            for (std::size_t i = 0; i < Dimension; ++i) {
                columns[i] = rows_[i];
                columns[i][k] = lifts[i];
            }
            if constexpr (Dimension == 3)
                sum += last[k] * determinant(columns[0], columns[1], columns[2]);
            else
                sum += last[k] * determinant(columns[0], columns[1]);
        }
        return signOf(sum);
    }

    const std::vector<Point>& points_;
    IntegerPoints grid_;
    std::vector<Row> rows_;
};

using ExactOracle2d = ExactOracle<2, Vec2>;
using ExactOracle3d = ExactOracle<3, Vec3>;

}  // namespace mesher::test
