#include "sizing/formula_size.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <utility>

namespace mesher {
namespace {

double valueOf(const std::string& text, const Vec3& point = {2.0, 3.0, 5.0})
{
    const auto formula = FormulaSize::parse(text);
    EXPECT_TRUE(formula.hasValue()) << text;
    return formula ? formula->sizeAt(point) : -1.0;
}

TEST(FormulaSize, followsTheRulesOfPrecedence)
{
    EXPECT_DOUBLE_EQ(valueOf("1 + 2 * 3"), 7.0);
    EXPECT_DOUBLE_EQ(valueOf("(1 + 2) * 3"), 9.0);
    EXPECT_DOUBLE_EQ(valueOf("10 - 2 - 3"), 5.0);
    EXPECT_DOUBLE_EQ(valueOf("16 / 4 / 2"), 2.0);
    EXPECT_DOUBLE_EQ(valueOf("2 ^ 3 ^ 2"), 512.0);
    EXPECT_DOUBLE_EQ(valueOf("20 - 2^2"), 16.0);
    EXPECT_DOUBLE_EQ(valueOf("5 + -2^2"), 1.0);
    EXPECT_DOUBLE_EQ(valueOf("2^-1"), 0.5);
    EXPECT_DOUBLE_EQ(valueOf("--3"), 3.0);
}

TEST(FormulaSize, knowsVariablesAndFunctions)
{
    EXPECT_DOUBLE_EQ(valueOf("x + 10*y + 100*z"), 532.0);
    EXPECT_DOUBLE_EQ(valueOf("0.1 + 0.05 * sqrt(x^2 + y^2)"), 0.1 + 0.05 * std::sqrt(13.0));
    EXPECT_DOUBLE_EQ(valueOf("min(x, y) + max(y, z) + abs(-1)"), 8.0);
    EXPECT_DOUBLE_EQ(valueOf("exp(log(7))"), 7.0);
    EXPECT_NEAR(valueOf("2 + sin(pi) + cos(0) + tan(0)"), 3.0, 1e-15);
    EXPECT_DOUBLE_EQ(valueOf("1.5e1"), 15.0);
}

TEST(FormulaSize, wishesForNothingWhereItIsNotPositive)
{
    EXPECT_EQ(valueOf("x - 7"), kNoSize);
    EXPECT_EQ(valueOf("log(-1)"), kNoSize);
    EXPECT_EQ(valueOf("0"), kNoSize);
}

TEST(FormulaSize, refusesWhatIsNoFormula)
{
    for (const char* text :
         {"", "1 +", "(1", "1)", "foo(1)", "x y", "min(1)", "sqrt 2", "1..2", "2 $ 3", "import os"}) {
        EXPECT_FALSE(FormulaSize::parse(text).hasValue()) << text;
    }
    EXPECT_FALSE(FormulaSize::parse(std::string(2000, '(') + "1" + std::string(2000, ')')).hasValue());
    EXPECT_FALSE(FormulaSize::parse(std::string(3000, '-') + "1").hasValue());
    EXPECT_FALSE(FormulaSize::parse(std::string(10000, '1')).hasValue());
}

TEST(FormulaSize, takesTheDeepestNestingItAllows)
{
    std::string text = "1";
    for (int i = 0; i < 60; ++i) text = "max(1, 1 + 1 * (" + text + "))";
    const auto formula = FormulaSize::parse(text);
    if (formula) {
        EXPECT_GT(formula->sizeAt({}), 0.0);
    }
    std::string shallow = "1";
    for (int i = 0; i < 15; ++i) shallow = "max(1, 1 + 1 * (" + shallow + "))";
    EXPECT_DOUBLE_EQ(valueOf(shallow), 16.0);
}

}  // namespace
}  // namespace mesher
