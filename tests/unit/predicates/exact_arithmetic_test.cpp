#include "base/random.h"
#include "predicates/expansion.h"
#include "predicates/fixed_integer.h"
#include "predicates/integer_grid.h"
#include "predicates/short_coordinates.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace mesher::detail {
namespace {

template <std::size_t Limbs>
FixedInteger<Limbs> randomInteger(Random& random)
{
    std::array<std::uint64_t, Limbs> limbs;
    for (std::uint64_t& limb : limbs) {
        // Limbs of all zeros and all ones lead carries through.
        const std::uint32_t what = random.below(4);
        limb = what == 0 ? 0 : (what == 1 ? ~std::uint64_t{0} : random());
    }
    return FixedInteger<Limbs>(limbs);
}

template <std::size_t Limbs>
mpz_class toGmp(const FixedInteger<Limbs>& a)
{
    mpz_class value = 0;
    for (std::size_t i = Limbs; i-- > 0;)
        value = (value << 64) + mpz_class(static_cast<unsigned long>(a.limb(i)));
    if (a.isNegative()) value -= mpz_class(1) << (64 * Limbs);
    return value;
}

/// What is left of a value in two's complement of so many limbs.
mpz_class wrapped(const mpz_class& value, unsigned long limbs)
{
    const mpz_class modulus = mpz_class(1) << (64 * limbs);
    mpz_class rest;
    mpz_fdiv_r(rest.get_mpz_t(), value.get_mpz_t(), modulus.get_mpz_t());
    if (rest >= modulus / 2) rest -= modulus;
    return rest;
}

template <std::size_t M, std::size_t N>
void expectIntegerArithmetic()
{
    Random random(M * 10 + N);
    for (int i = 0; i < 3000; ++i) {
        const auto a = randomInteger<M>(random);
        const auto b = randomInteger<M>(random);
        const auto c = randomInteger<N>(random);
        ASSERT_EQ(toGmp(a + b), wrapped(toGmp(a) + toGmp(b), M));
        ASSERT_EQ(toGmp(a - b), wrapped(toGmp(a) - toGmp(b), M));
        ASSERT_EQ(toGmp(a * c), wrapped(toGmp(a) * toGmp(c), M + N));
        ASSERT_EQ(static_cast<int>(a.sign()), sgn(toGmp(a)));
    }
}

TEST(FixedInteger, AgreesWithGmp)
{
    expectIntegerArithmetic<1, 1>();
    expectIntegerArithmetic<1, 2>();
    expectIntegerArithmetic<2, 1>();
    expectIntegerArithmetic<2, 2>();
    expectIntegerArithmetic<2, 3>();
    expectIntegerArithmetic<2, 4>();
    expectIntegerArithmetic<4, 6>();
}

TEST(IntegerGrid, KeepsRatiosAndRefusesFinerCoordinates)
{
    const std::array<double, 3> fits{0.75, -0x1p-61, 3 * 0x1p-60};
    const auto grid = toGrid64(fits);
    ASSERT_TRUE(grid);
    EXPECT_EQ(toGmp((*grid)[0]), toGmp((*grid)[1]) * mpz_class("-1729382256910270464"));
    EXPECT_EQ(toGmp((*grid)[2]), toGmp((*grid)[1]) * -6);
    EXPECT_FALSE(toGrid64(std::array<double, 2>{0.75, 0x1p-62}));
    EXPECT_TRUE(toGrid128(std::array<double, 2>{0.75, 0x1p-125}));
    EXPECT_FALSE(toGrid128(std::array<double, 2>{0.75, 0x1p-126}));
}

TEST(IntegerGrid, WideGridAgreesWithGmp)
{
    Random random(2);
    for (int i = 0; i < 3000; ++i) {
        const std::array<double, 3> coordinates{random.between(-1, 1), std::ldexp(random.between(-1, 1), -40),
                                                std::ldexp(random.between(-1, 1), -70)};
        const double scale = gridScale(coordinates, kGridBits<2>);
        const auto grid = toGrid128(coordinates);
        if (!grid) continue;
        for (std::size_t k = 0; k < 3; ++k) ASSERT_EQ(toGmp((*grid)[k]), mpz_class(coordinates[k] * scale));
    }
}

TEST(ShortCoordinates, AreMultiplesOfAUnitNearTheDifferences)
{
    EXPECT_TRUE(areShort(std::array<double, 2>{1000.0, 1007.0}, 7.0, 3));
    EXPECT_FALSE(areShort(std::array<double, 2>{1000.5, 1007.5}, 7.0, 3));
    EXPECT_FALSE(areShort(std::array<double, 2>{-1000.5, 1007.5}, 7.0, 3));
    EXPECT_TRUE(areShort(std::array<double, 2>{1000.5, 1007.5}, 7.0, 4));
    EXPECT_FALSE(areShort(std::array<double, 2>{1000.0, 1009.0}, 9.0, 3));
}

template <std::size_t N>
mpq_class valueOf(const Expansion<N>& e)
{
    mpq_class sum = 0;
    for (std::size_t i = 0; i < e.size(); ++i) sum += mpq_class(e[i]);
    return sum;
}

double lowestBit(double x)
{
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    return std::ldexp(static_cast<double>(mantissa & -mantissa), exponent - 53);
}

template <std::size_t N>
void expectOrdered(const Expansion<N>& e)
{
    ASSERT_LE(e.size(), N);
    for (std::size_t i = 0; i < e.size(); ++i) {
        ASSERT_NE(e[i], 0.0);
        if (i == 0) continue;
        // Nonoverlapping: smaller than the lowest bit that is set in the next component.
        ASSERT_LT(std::abs(e[i - 1]), lowestBit(e[i]));
    }
    ASSERT_EQ(static_cast<int>(e.sign()), sgn(valueOf(e)));
}

TEST(Expansion, SumsAndScalesExactly)
{
    Random random(3);
    const auto coordinate = [&random] {
        return random.below(5) == 0
                   ? double(random.below(3)) - 1.0
                   : std::ldexp(random.between(-1, 1), static_cast<int>(random.below(100)) - 50);
    };
    for (int i = 0; i < 5000; ++i) {
        const double p = coordinate(), q = coordinate(), r = coordinate(), s = coordinate(), t = coordinate();
        const auto pq = product(p, q);
        ASSERT_EQ(valueOf(pq), mpq_class(p) * mpq_class(q));
        const auto difference = pq - product(r, s);
        ASSERT_EQ(valueOf(difference), valueOf(pq) - mpq_class(r) * mpq_class(s));
        expectOrdered(difference);
        const auto scaled = difference * t;
        ASSERT_EQ(valueOf(scaled), valueOf(difference) * mpq_class(t));
        expectOrdered(scaled);
        const auto sum = scaled * p + (difference - product(t, t)) * q;
        ASSERT_EQ(valueOf(sum), valueOf(scaled) * mpq_class(p) +
                                    (valueOf(difference) - mpq_class(t) * mpq_class(t)) * mpq_class(q));
        expectOrdered(sum);
        ASSERT_EQ((sum - sum).sign(), Sign::Zero);
    }
}

}  // namespace
}  // namespace mesher::detail
