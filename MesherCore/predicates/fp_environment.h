#pragma once

#include "base/result.h"

namespace mesher {

/// What can be wrong with the floating-point environment. Each of these breaks a proof that the predicates
/// rest on (docs/algorithms/predicates.md).
enum class FloatingPointFault
{
    None,
    Rounding,          ///< not to nearest, ties to even
    FlushToZero,       ///< subnormal results are replaced by zero
    DenormalsAreZero,  ///< subnormal operands are read as zero
    ExcessPrecision,   ///< intermediate results are kept wider than a double
    Contraction        ///< a product and a sum are fused into one rounding
};

[[nodiscard]] const char* nameOf(FloatingPointFault fault);

/// Computes a few values whose results tell; reads no control register, so it holds on every processor. The
/// environment is a property of the thread: probe in each thread that calls predicates.
[[nodiscard]] FloatingPointFault probeFloatingPoint();

/// For start-up: ErrorCode::UnsupportedPlatform with the fault named, unless all is well.
[[nodiscard]] Result<void> checkFloatingPointEnvironment();

}  // namespace mesher
