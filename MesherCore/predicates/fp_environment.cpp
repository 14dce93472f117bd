#include "predicates/fp_environment.h"

#include <string>

namespace mesher {

namespace {

/// The same value by way of memory, so that nothing is computed at compile time.
double opaque(double value)
{
    volatile double stored = value;
    return stored;
}

/// All operands by way of memory: the compiler may take the sum of negated values for the negated sum.
double sum(double a, double b) { return opaque(opaque(a) + opaque(b)); }

bool roundsToNearestEven()
{
    constexpr double kNext = 0x1.0000000000001p0;
    constexpr double kAfterNext = 0x1.0000000000002p0;
    constexpr double kHalfUlp = 0x1p-53;
    constexpr double kMoreThanHalfUlp = 0x1.8p-53;
    const bool isTieDown = sum(1.0, kHalfUlp) == 1.0 && sum(-1.0, -kHalfUlp) == -1.0;
    const bool isTieUp = sum(kNext, kHalfUlp) == kAfterNext && sum(-kNext, -kHalfUlp) == -kAfterNext;
    const bool isNearest = sum(1.0, kMoreThanHalfUlp) == kNext && sum(-1.0, -kMoreThanHalfUlp) == -kNext;
    return isTieDown && isTieUp && isNearest;
}

bool producesSubnormals()
{
    const double smallestNormal = opaque(0x1p-1022);
    const double half = opaque(0.5);
    // Dividing brings a result that was not flushed back to normal.
    const double product = opaque(smallestNormal * half);
    return product / half == smallestNormal;
}

bool readsSubnormals()
{
    const double subnormal = opaque(0x1p-1060);
    const double factor = opaque(0x1p100);
    return subnormal * factor == 0x1p-960;
}

bool keepsDoublePrecision()
{
    const double one = opaque(1.0);
    const double tiny = opaque(0x1p-60);
    const double huge = opaque(0x1p1000);
    const double factor = opaque(0x1p100);
    const double lost = (one + tiny) - one;
    const double overflown = (huge * factor) / factor;
    // Whatever the rounding, a double cannot give the tiny summand back.
    return lost != tiny && overflown != huge;
}

bool roundsProductsBeforeSums()
{
    // The exact square of the factor is 2^-54 above its rounded value. Each product has operands of its own:
    // one that is used twice might be spared from fusing.
    constexpr double kFactor = 0x1.0000002p0;
    constexpr double kRounded = 0x1.0000004p0;
    const double after = opaque(kFactor) * opaque(kFactor) - opaque(kRounded);
    const double before = opaque(kRounded) - opaque(kFactor) * opaque(kFactor);
    return after == 0.0 && before == 0.0;
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
    return Error{ErrorCode::UnsupportedPlatform, std::string("floating-point environment: ") + nameOf(fault),
                 "", std::nullopt,
                 "restore the default floating-point mode and build without fast-math options"};
}

}  // namespace mesher
