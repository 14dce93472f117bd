#pragma once

#include "base/vec.h"

#include <optional>
#include <string>
#include <string_view>

namespace mesher {

/// What is wrong with the input of an operation. A caller may branch on it; people read `describe`.
enum class ErrorCode
{
    InvalidArgument,          ///< an option or argument outside of its documented range
    NonFinitePoint,           ///< a coordinate is infinite or not a number
    OutOfRange,               ///< a coordinate or a count is beyond what can be computed exactly or indexed
    DegenerateInput,          ///< the points do not span the dimension of the triangulation
    DuplicatePoint,           ///< two points coincide where that has no meaning
    IntersectingConstraints,  ///< two constraints cross away from a common vertex
    UnsupportedPlatform,      ///< the floating-point environment breaks the exactness of the predicates
    Unreadable,               ///< a file that cannot be read
    Unwritable                ///< a file that cannot be written
};

[[nodiscard]] std::string_view nameOf(ErrorCode code);

/// Bad input, told so that a user can act on it. Broken invariants are assertions (assert.h); limits and
/// cancellation are a StopReason (stop_reason.h).
struct Error
{
    ErrorCode code = ErrorCode::InvalidArgument;
    std::string message;        ///< what is wrong, a clause without a full stop
    std::string entity;         ///< the offending thing, e.g. "point 17" or "Face6"; empty if none
    std::optional<Vec3> point;  ///< where, in model units; 2D input has z = 0
    std::string remedy;         ///< what to do about it, a clause without a full stop; empty if unknown
};

/// One sentence: "Face6 at (1, 2, 3): two edges cross; repair the sketch."
[[nodiscard]] std::string describe(const Error& error);

}  // namespace mesher
