#include "predicates/fp_environment.h"

#include <string>

namespace mesher {

namespace {

/// A double that the compiler must load, so that nothing is computed at compile time.
class Opaque
{
public:
    explicit Opaque(double value) : value_(value) {}
    operator double() const { return value_; }

private:
    volatile double value_;
};

bool roundsToNearestEven()
{
    const Opaque one(1.0);
    const Opaque next(0x1.0000000000001p0);
    const Opaque halfUlp(0x1p-53);
    const Opaque moreThanHalfUlp(0x1.8p-53);
    const bool isTieDown = one + halfUlp == 1.0 && -one - halfUlp == -1.0;
    const bool isTieUp = next + halfUlp == 0x1.0000000000002p0 && -next - halfUlp == -0x1.0000000000002p0;
    const bool isNearest = one + moreThanHalfUlp == next && -one - moreThanHalfUlp == -next;
    return isTieDown && isTieUp && isNearest;
}

bool producesSubnormals()
{
    const Opaque smallestNormal(0x1p-1022);
    const Opaque half(0.5);
    // Dividing brings a result that was not flushed back to normal.
    const Opaque product(smallestNormal * half);
    return product / half == smallestNormal;
}

bool readsSubnormals()
{
    const Opaque subnormal(0x1p-1060);
    const Opaque factor(0x1p100);
    return subnormal * factor == 0x1p-960;
}

bool keepsDoublePrecision()
{
    const Opaque one(1.0);
    const Opaque tiny(0x1p-60);
    const Opaque huge(0x1p1000);
    const Opaque factor(0x1p100);
    const double sum = (one + tiny) - one;
    const double quotient = (huge * factor) / factor;
    return sum == 0.0 && quotient != huge;
}

bool roundsProductsBeforeSums()
{
    const Opaque factor(0x1.0000002p0);
    const Opaque rounded(0x1.0000004p0);
    // The exact square is 2^-54 above its rounded value.
    const double difference = factor * factor - rounded;
    const double sum = rounded - factor * factor;
    return difference == 0.0 && sum == 0.0;
}

}  // namespace

const char* nameOf(FloatingPointFault fault)
{
    switch (fault) {
        case FloatingPointFault::None: return "none";
        case FloatingPointFault::Rounding: return "rounding is not to nearest even";
        case FloatingPointFault::FlushToZero: return "subnormal results are flushed to zero";
        case FloatingPointFault::DenormalsAreZero: return "subnormal operands are read as zero";
        case FloatingPointFault::ExcessPrecision: return "intermediate results are wider than a double";
        case FloatingPointFault::Contraction: return "products and sums are fused";
    }
    return "unknown";
}

FloatingPointFault probeFloatingPoint()
{
    // Reading subnormals comes before producing them: the second test would fail for both faults.
    if (!keepsDoublePrecision()) return FloatingPointFault::ExcessPrecision;
    if (!roundsToNearestEven()) return FloatingPointFault::Rounding;
    if (!readsSubnormals()) return FloatingPointFault::DenormalsAreZero;
    if (!producesSubnormals()) return FloatingPointFault::FlushToZero;
    if (!roundsProductsBeforeSums()) return FloatingPointFault::Contraction;
    return FloatingPointFault::None;
}

Result<void> checkFloatingPointEnvironment()
{
    const FloatingPointFault fault = probeFloatingPoint();
    if (fault == FloatingPointFault::None) return {};
    return Error{ErrorCode::UnsupportedPlatform, std::string("floating-point environment: ") + nameOf(fault), "",
                 std::nullopt, "restore the default floating-point mode and build without fast-math options"};
}

}  // namespace mesher
