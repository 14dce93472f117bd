#pragma once

#include "base/result.h"
#include "pipeline/size_wishes.h"

#include <string>
#include <vector>

namespace mesher {

/// \name Texts of the command line that ask for sizes
/// Each refuses what does not look like its syntax with one sentence that shows it; whether the numbers make sense is left to
/// `validate`.
///@{
[[nodiscard]] Result<LocalSize> localSizeIn(const std::string& text);            ///< "Face6=0.5"
[[nodiscard]] Result<SizeByDistance> sizeByDistanceIn(const std::string& text);  ///< "Edge3=0.1,0.2[,1]"
[[nodiscard]] Result<SizeInBox> sizeInBoxIn(const std::string& text);            ///< "0,0,0,1,1,1=0.1[,0.2]"
[[nodiscard]] Result<SizeInBall> sizeInBallIn(const std::string& text);          ///< "0,0,0,1=0.1[,0.2]"
///@}

/// What is between the commas of a text.
[[nodiscard]] std::vector<std::string> splitAtCommas(const std::string& text);

}  // namespace mesher
