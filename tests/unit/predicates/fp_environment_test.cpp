#include "predicates/fp_environment.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <string>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace mesher {
namespace {

/// Puts the whole floating-point environment back, whatever a test did to it.
class RestoredEnvironment
{
public:
    RestoredEnvironment() { std::fegetenv(&saved_); }
    ~RestoredEnvironment() { std::fesetenv(&saved_); }
    RestoredEnvironment(const RestoredEnvironment&) = delete;
    RestoredEnvironment& operator=(const RestoredEnvironment&) = delete;

private:
    std::fenv_t saved_;
};

TEST(FloatingPointEnvironment, DefaultIsAccepted)
{
    EXPECT_EQ(probeFloatingPoint(), FloatingPointFault::None);
    EXPECT_TRUE(checkFloatingPointEnvironment());
}

TEST(FloatingPointEnvironment, OtherRoundingIsRefusedAndRestoringIsSeen)
{
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        FloatingPointFault fault = FloatingPointFault::None;
        {
            const RestoredEnvironment restored;
            ASSERT_EQ(std::fesetround(mode), 0);
            fault = probeFloatingPoint();
        }
        EXPECT_EQ(fault, FloatingPointFault::Rounding) << mode;
        EXPECT_EQ(probeFloatingPoint(), FloatingPointFault::None);
    }
}

TEST(FloatingPointEnvironment, RefusalIsATypedError)
{
    std::string message;
    ErrorCode code{};
    {
        const RestoredEnvironment restored;
        std::fesetround(FE_UPWARD);
        const Result<void> result = checkFloatingPointEnvironment();
        ASSERT_FALSE(result);
        message = result.error().message;
        code = result.error().code;
    }
    EXPECT_EQ(code, ErrorCode::UnsupportedPlatform);
    EXPECT_NE(message.find("rounding"), std::string::npos);
}

#if defined(__SSE2__)

FloatingPointFault probeWith(unsigned controlBits)
{
    const unsigned saved = _mm_getcsr();
    _mm_setcsr(saved | controlBits);
    const FloatingPointFault fault = probeFloatingPoint();
    _mm_setcsr(saved);
    return fault;
}

TEST(FloatingPointEnvironment, FlushedSubnormalsAreRefused)
{
    constexpr unsigned kFlushToZero = 0x8000;
    constexpr unsigned kDenormalsAreZero = 0x0040;
    EXPECT_EQ(probeWith(kFlushToZero), FloatingPointFault::FlushToZero);
    EXPECT_EQ(probeWith(kDenormalsAreZero), FloatingPointFault::DenormalsAreZero);
    EXPECT_EQ(probeWith(0), FloatingPointFault::None);
}

#endif

}  // namespace
}  // namespace mesher
