#include "sizing/formula_size.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace mesher {
namespace {

using Operation = FormulaSize::Operation;
using Step = FormulaSize::Step;

constexpr std::size_t kLongestFormula = 4096;
constexpr int kDeepestNesting = 64;
/// Each level of nesting holds a few values at most.
constexpr std::size_t kStackSize = 8 * kDeepestNesting;

struct NamedFunction
{
    std::string_view name;
    Operation operation;
    int arguments;
};
constexpr std::array kFunctions{
    NamedFunction{"sqrt", Operation::Sqrt, 1}, NamedFunction{"abs", Operation::Abs, 1},
    NamedFunction{"exp", Operation::Exp, 1},   NamedFunction{"log", Operation::Log, 1},
    NamedFunction{"sin", Operation::Sin, 1},   NamedFunction{"cos", Operation::Cos, 1},
    NamedFunction{"tan", Operation::Tan, 1},   NamedFunction{"min", Operation::Min, 2},
    NamedFunction{"max", Operation::Max, 2}};

/// Recursive descent; writes the steps of each part behind those of its arguments.
class Parser
{
public:
    explicit Parser(std::string_view text) : text_(text) {}

    Result<std::vector<Step>> run()
    {
        if (text_.size() > kLongestFormula) fail("the formula is too long");
        sum();
        skipBlanks();
        if (!fault_ && place_ < text_.size()) fail("this does not continue the formula");
        if (fault_) return *fault_;
        return std::move(steps_);
    }

private:
    void fail(std::string message)
    {
        if (fault_) return;
        fault_.emplace();
        fault_->code = ErrorCode::InvalidArgument;
        fault_->entity = "formula, character " + std::to_string(place_ + 1);
        fault_->message = std::move(message);
        fault_->remedy = "write it with numbers, x, y, z, + - * / ^, parentheses and known functions";
    }

    void skipBlanks()
    {
        while (place_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[place_])) != 0)
            ++place_;
    }
    bool take(char wanted)
    {
        skipBlanks();
        if (place_ >= text_.size() || text_[place_] != wanted) return false;
        ++place_;
        return true;
    }
    void emit(Operation operation, double number = 0.0) { steps_.push_back({operation, number}); }

    void sum()
    {
        product();
        while (!fault_) {
            if (take('+')) {
                product();
                emit(Operation::Add);
            } else if (take('-')) {
                product();
                emit(Operation::Subtract);
            } else {
                return;
            }
        }
    }

    void product()
    {
        signedFactor();
        while (!fault_) {
            if (take('*')) {
                signedFactor();
                emit(Operation::Multiply);
            } else if (take('/')) {
                signedFactor();
                emit(Operation::Divide);
            } else {
                return;
            }
        }
    }

    void signedFactor()
    {
        if (++depth_ > kDeepestNesting) fail("the formula is nested too deeply");
        if (fault_) return;
        if (take('-')) {
            signedFactor();
            emit(Operation::Negate);
        } else {
            power();
        }
        --depth_;
    }

    void power()
    {
        atom();
        if (fault_ || !take('^')) return;
        signedFactor();
        emit(Operation::Power);
    }

    void atom()
    {
        if (take('(')) {
            sum();
            if (!fault_ && !take(')')) fail("a closing parenthesis is missing");
            return;
        }
        skipBlanks();
        if (place_ >= text_.size()) return fail("the formula ends too early");
        const char c = text_[place_];
        if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.') return number();
        if (std::isalpha(static_cast<unsigned char>(c)) != 0) return name();
        fail("this is no number, name or parenthesis");
    }

    void number()
    {
        double value = 0.0;
        const char* begin = text_.data() + place_;
        const auto [end, code] = std::from_chars(begin, text_.data() + text_.size(), value);
        if (code != std::errc()) return fail("this is no number");
        place_ += static_cast<std::size_t>(end - begin);
        emit(Operation::Number, value);
    }

    void name()
    {
        const std::size_t begin = place_;
        while (place_ < text_.size() && std::isalnum(static_cast<unsigned char>(text_[place_])) != 0)
            ++place_;
        const std::string_view word = text_.substr(begin, place_ - begin);
        if (word == "x") return emit(Operation::X);
        if (word == "y") return emit(Operation::Y);
        if (word == "z") return emit(Operation::Z);
        if (word == "pi") return emit(Operation::Number, std::numbers::pi);
        for (const NamedFunction& function : kFunctions) {
            if (function.name == word) return call(function);
        }
        place_ = begin;
        fail("the name is not known");
    }

    void call(const NamedFunction& function)
    {
        if (!take('(')) return fail("a function needs its arguments in parentheses");
        for (int i = 0; i < function.arguments && !fault_; ++i) {
            if (i > 0 && !take(',')) return fail("an argument is missing");
            sum();
        }
        if (!fault_ && !take(')')) return fail("a closing parenthesis is missing");
        emit(function.operation);
    }

    std::string_view text_;
    std::size_t place_ = 0;
    int depth_ = 0;
    std::vector<Step> steps_;
    std::optional<Error> fault_;
};

double applyUnary(Operation operation, double a)
{
    switch (operation) {
        case Operation::Negate: return -a;
        case Operation::Sqrt: return std::sqrt(a);
        case Operation::Abs: return std::abs(a);
        case Operation::Exp: return std::exp(a);
        case Operation::Log: return std::log(a);
        case Operation::Sin: return std::sin(a);
        case Operation::Cos: return std::cos(a);
        default: return std::tan(a);
    }
}

double applyBinary(Operation operation, double a, double b)
{
    switch (operation) {
        case Operation::Add: return a + b;
        case Operation::Subtract: return a - b;
        case Operation::Multiply: return a * b;
        case Operation::Divide: return a / b;
        case Operation::Power: return std::pow(a, b);
        case Operation::Min: return std::fmin(a, b);
        default: return std::fmax(a, b);
    }
}

bool isBinary(Operation operation)
{
    return (Operation::Add <= operation && operation <= Operation::Power) || operation == Operation::Min ||
           operation == Operation::Max;
}

}  // namespace

Result<FormulaSize> FormulaSize::parse(std::string_view text)
{
    auto steps = Parser(text).run();
    if (!steps) return steps.error();
    return FormulaSize(std::move(*steps));
}

double FormulaSize::sizeAt(const Vec3& point) const
{
    std::array<double, kStackSize> stack;
    std::size_t top = 0;
    for (const Step& step : steps_) {
        switch (step.operation) {
            case Operation::Number: stack[top++] = step.number; break;
            case Operation::X: stack[top++] = point.x; break;
            case Operation::Y: stack[top++] = point.y; break;
            case Operation::Z: stack[top++] = point.z; break;
            default:
                if (isBinary(step.operation)) {
                    --top;
                    stack[top - 1] = applyBinary(step.operation, stack[top - 1], stack[top]);
                } else {
                    stack[top - 1] = applyUnary(step.operation, stack[top - 1]);
                }
        }
        MESHER_INVARIANT(0 < top && top < kStackSize);
    }
    const double size = stack[0];
    return size > 0.0 ? size : kNoSize;
}

}  // namespace mesher
