#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace mesher {

/// Root of a continuous function between a and b, where fa and fb, its values there, differ in sign (one may be zero).
///
/// Guarantees   the result lies in the bracket, within `tolerance` of a change of sign
/// Terminates   always: each step keeps a bracket, and bisection steps in when interpolation would be unsafe
/// Reference    [chandrupatla1997], a simpler acceptance test for inverse quadratic interpolation than Brent's
template <class Function>
[[nodiscard]] double findRoot(Function&& function, double a, double b, double fa, double fb, double tolerance)
{
    constexpr int kMostSteps = 200;
    constexpr double kRounding = 2.0 * std::numeric_limits<double>::epsilon();
    double x1 = b, x2 = a, f1 = fb, f2 = fa;
    if (f1 == 0.0) return x1;
    if (f2 == 0.0) return x2;
    double t = 0.5;
    double best = x1;
    for (int step = 0; step < kMostSteps; ++step) {
        const double x = x1 + t * (x2 - x1);
        const double f = function(x);
        const bool isOnSideOfFirst = (f > 0.0) == (f1 > 0.0);
        const double x3 = isOnSideOfFirst ? x1 : x2;
        const double f3 = isOnSideOfFirst ? f1 : f2;
        if (!isOnSideOfFirst) {
            x2 = x1;
            f2 = f1;
        }
        x1 = x;
        f1 = f;
        best = std::abs(f2) < std::abs(f1) ? x2 : x1;
        const double limit = (kRounding * std::abs(best) + 0.5 * tolerance) / std::abs(x2 - x1);
        if (f == 0.0) return x;
        if (!(limit < 0.5)) return best;
        const double xi = (x1 - x2) / (x3 - x2);
        const double phi = (f1 - f2) / (f3 - f2);
        t = 0.5;
        if (phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi) {
            t = f1 / (f2 - f1) * (f3 / (f2 - f3)) + (x3 - x1) / (x2 - x1) * (f1 / (f3 - f1)) * (f2 / (f3 - f2));
        }
        t = std::clamp(t, limit, 1.0 - limit);
    }
    return best;
}

}  // namespace mesher
