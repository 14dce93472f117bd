#pragma once

#include "base/result.h"
#include "sizing/sizing_field.h"

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace mesher {

/// A size by a formula of x, y and z, e.g. "0.1 + 0.05 * sqrt(x^2 + y^2)".
/// Grammar      + - * / ^ (right to left, before the sign), parentheses, numbers, x y z pi, and the functions sqrt abs exp
///              log sin cos tan min max (two arguments)
/// Refuses      anything else, with the place of the fault; formulas too long or nested too deeply
/// Guarantees   only arithmetic is done; where a formula is not positive or not a number it wishes for nothing
class FormulaSize final : public SizingField
{
public:
    [[nodiscard]] static Result<FormulaSize> parse(std::string_view text);
    [[nodiscard]] double sizeAt(const Vec3& point) const override;

    enum class Operation : unsigned char
    {
        Number,
        X,
        Y,
        Z,
        Add,
        Subtract,
        Multiply,
        Divide,
        Power,
        Negate,
        Sqrt,
        Abs,
        Exp,
        Log,
        Sin,
        Cos,
        Tan,
        Min,
        Max
    };
    /// A program for a stack machine.
    struct Step
    {
        Operation operation = Operation::Number;
        double number = 0.0;
    };

private:
    explicit FormulaSize(std::vector<Step> steps) : steps_(std::move(steps)) {}

    std::vector<Step> steps_;
};

}  // namespace mesher
