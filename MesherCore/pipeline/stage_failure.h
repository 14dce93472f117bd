#pragma once

#include "base/error.h"

#include <string>

namespace mesher {

/// The exception in flight as an Error that names what it is about and the stage: a backend that gives up on a face or an edge
/// (GeometryFailure), memory that does not suffice, and whatever else. To be called from a catch block only. The stages are run
/// behind one such block each for meshing and estimating, since what they ask may fail anywhere.
[[nodiscard]] Error errorInFlight(const std::string& stage);

}  // namespace mesher
