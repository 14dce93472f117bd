#include "pipeline/model_extent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace mesher {

namespace {

constexpr double kSmallest = 1e-5;
constexpr double kLargest = 1e9;
constexpr double kLeastSteps = 1e4;  ///< of the last digit, across the model

Error wrong(const std::string& what, const std::string& remedy)
{
    return {ErrorCode::OutOfRange, what, "model", {}, remedy};
}

std::string told(double value)
{
    std::ostringstream text;
    text.precision(3);
    text << value;
    return text.str();
}

}  // namespace

Result<void> checkExtent(const BrepModel& model)
{
    const Vec3 &low = model.box.low, &high = model.box.high;
    if (model.box.isEmpty()) return {};
    if (!isFinite(low) || !isFinite(high)) return wrong("has no end", "trim its faces");
    const double size = length(model.box.extent());
    const std::string across = "is " + told(size) + ' ' + model.unit + " across";
    if (size < kSmallest || size > kLargest)
        return wrong(across + ", and sizes from 1e-05 to 1e+09 can be meshed", "scale the model");
    const std::array coordinates = {low.x, low.y, low.z, high.x, high.y, high.z};
    double farthest = 0.0;
    for (const double c : coordinates) farthest = std::max(farthest, std::abs(c));
    if (size < kLeastSteps * std::numeric_limits<double>::epsilon() * farthest)
        return wrong(across + " and " + told(farthest) +
                         " from the origin, where numbers do not tell its places apart",
                     "move the model to the origin");
    return {};
}

}  // namespace mesher
