#include "io/short_number.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>

namespace mesher {
namespace {

TEST(ShortNumber, IsTheShortestTextWhereThatFits)
{
    EXPECT_EQ(shortNumber(0.1, 20), "0.1");
    EXPECT_EQ(shortNumber(-0.0, 20), "0");
    EXPECT_EQ(shortNumber(1e22, 20), "1e+22");
    EXPECT_EQ(shortNumber(-12.345678901234567, 20), "-12.345678901234567");
}

TEST(ShortNumber, SavesCharactersBeforeDigits)
{
    EXPECT_EQ(shortNumber(-0.012345678901234567, 20), "-.012345678901234567");
    EXPECT_EQ(shortNumber(-9.797174393178826e-16, 20), "-9.7971743931788e-16");
    EXPECT_EQ(shortNumber(1.2345678901234567e-100, 20), "1.2345678901235e-100");
}

/// Any double, and any of the sizes that coordinates have: fits, and loses nothing that a text of its length could keep.
TEST(ShortNumber, FitsAndLosesLittle)
{
    Random random(7);
    for (int i = 0; i < 100'000; ++i) {
        double value = std::bit_cast<double>(random());
        if (i % 2 == 1)
            value = std::ldexp(1.0 + static_cast<double>(random() >> 12) * 0x1p-52,
                               static_cast<int>(random() % 80) - 60);
        if (!std::isfinite(value) || std::abs(value) < 1e-300) continue;
        for (const double signedValue : {value, -value}) {
            const std::string text = shortNumber(signedValue, 20);
            ASSERT_LE(text.size(), 20u) << text;
            const double lost = std::abs(std::strtod(text.c_str(), nullptr) - signedValue) / std::abs(value);
            ASSERT_LE(lost, 0.5e-12) << text;
            if (signedValue > 0.0 && value > 1e-3 && value < 1e9) {
                ASSERT_LE(lost, 0.5e-15) << text;
            }
        }
    }
}

}  // namespace
}  // namespace mesher
