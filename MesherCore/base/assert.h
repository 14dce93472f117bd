#pragma once

namespace mesher::detail {

/// Prints the broken condition and aborts: the state cannot be trusted any further.
[[noreturn]] void assertionFailed(const char* kind, const char* condition, const char* file, int line);

}  // namespace mesher::detail

// Three error kinds that never mix: a broken invariant or precondition is a bug of the program and is
// asserted here; bad input is a typed Error (error.h); cancel and limits are a StopReason (budget.h).
#ifdef NDEBUG
#define MESHER_INVARIANT(condition) static_cast<void>(0)
#define MESHER_PRECONDITION(condition) static_cast<void>(0)
#else
#define MESHER_INVARIANT(condition) \
    ((condition) ? static_cast<void>(0) \
                 : ::mesher::detail::assertionFailed("invariant", #condition, __FILE__, __LINE__))
#define MESHER_PRECONDITION(condition) \
    ((condition) ? static_cast<void>(0) \
                 : ::mesher::detail::assertionFailed("precondition", #condition, __FILE__, __LINE__))
#endif
