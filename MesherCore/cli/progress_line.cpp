#include "cli/progress_line.h"

#include <algorithm>
#include <cmath>

namespace mesher {

void ProgressLine::show(std::string_view stage, double fraction)
{
    if (!isTerminal_) return;
    const long percent = std::lround(100.0 * std::clamp(fraction, 0.0, 1.0));
    std::string line = std::to_string(percent) + " % " + std::string(stage);
    if (line == shown_) return;
    out_ << "\r\033[K" << line << std::flush;
    shown_ = std::move(line);
}

void ProgressLine::clear()
{
    if (shown_.empty()) return;
    out_ << "\r\033[K" << std::flush;
    shown_.clear();
}

}  // namespace mesher
