#include "angle_histogram.h"

#include "formatted.h"

#include <algorithm>
#include <cmath>

namespace mesher::test {
namespace {

constexpr double kLeft = 40.0;  // of the plot, pixels; the axes' numbers stand outside
constexpr double kBottom = 150.0;
constexpr double kHeight = 130.0;
constexpr double kBarWidth = 18.0;
constexpr double kDegreesPerLabel = 30.0;

/// A round number of percent that the highest bar does not exceed.
double topOf(double highest)
{
    constexpr double kStep = 10.0;
    return std::max(kStep, kStep * std::ceil(highest / kStep));
}

}  // namespace

std::string drawHistogram(const AngleStatistics& angles)
{
    double total = 0.0;
    for (const std::size_t count : angles.histogram) total += static_cast<double>(count);
    const auto percent = [&](std::size_t bin) {
        return 100.0 * static_cast<double>(angles.histogram[bin]) / total;
    };
    double highest = 0.0;
    for (std::size_t i = 0; i < angles.histogram.size(); ++i) highest = std::max(highest, percent(i));
    const double top = topOf(highest);
    const double right = kLeft + kBarWidth * static_cast<double>(angles.histogram.size());

    std::string svg = formatted("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" "
                                "font-family=\"sans-serif\" font-size=\"11\">\n",
                                right + 20.0, kBottom + 35.0);
    svg += "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    for (std::size_t i = 0; i < angles.histogram.size(); ++i) {
        const double height = kHeight * percent(i) / top;
        svg += formatted("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"#6f9fce\"/>\n",
                         kLeft + kBarWidth * static_cast<double>(i) + 1.0, kBottom - height, kBarWidth - 2.0,
                         height);
    }
    svg += formatted("<path d=\"M%.0f %.0fV%.0fH%.0f\" fill=\"none\" stroke=\"black\"/>\n", kLeft,
                     kBottom - kHeight, kBottom, right);
    for (double degrees = 0.0; degrees <= 180.0; degrees += kDegreesPerLabel) {
        svg += formatted("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">%.0f°</text>\n",
                         kLeft + kBarWidth * degrees / AngleStatistics::kBinDegrees, kBottom + 14.0, degrees);
    }
    for (const double share : {0.0, 0.5 * top, top}) {
        svg += formatted("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"end\">%.0f %%</text>\n", kLeft - 4.0,
                         kBottom - kHeight * share / top + 4.0, share);
    }
    return svg + "</svg>\n";
}

}  // namespace mesher::test
