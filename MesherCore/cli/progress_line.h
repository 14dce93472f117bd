#pragma once

#include <ostream>
#include <string>
#include <string_view>

namespace mesher {

/// One line on a terminal that tells stage and percent, written over itself; silent elsewhere.
class ProgressLine
{
public:
    ProgressLine(std::ostream& out, bool isTerminal) : out_(out), isTerminal_(isTerminal) {}
    ~ProgressLine() { clear(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(std::string_view stage, double fraction);
    void clear();

private:
    std::ostream& out_;
    bool isTerminal_;
    std::string shown_;
};

}  // namespace mesher
