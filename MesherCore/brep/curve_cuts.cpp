#include "brep/curve_cuts.h"

#include <algorithm>
#include <cmath>

namespace mesher {

namespace {

// A quarter circle in floating point turns by a rounding error more than 90 degrees.
constexpr double kVariationSlack = 1e-9;

/// A part of a curve between corners, and into how many pieces it is cut.
struct SmoothSpan
{
    Interval part;
    double variation = 0.0;
    int pieces = 1;
};

std::vector<SmoothSpan> smoothSpans(const TangentVariation& table, double maxVariation)
{
    std::vector<SmoothSpan> spans;
    double start = table.part().first;
    const auto add = [&](double end) {
        SmoothSpan span{{start, end}, table.variation(start, end), 1};
        span.pieces =
            std::max(1, static_cast<int>(std::ceil(span.variation / maxVariation - kVariationSlack)));
        spans.push_back(span);
        start = end;
    };
    for (const CurveCorner& corner : table.corners()) add(corner.parameter);
    add(table.part().last);
    return spans;
}

void ensurePieces(std::vector<SmoothSpan>& spans, int leastPieces)
{
    int total = 0;
    for (const SmoothSpan& span : spans) total += span.pieces;
    for (; total < leastPieces; ++total) {
        // The span whose pieces turn most; the first of equal ones.
        const auto worst =
            std::max_element(spans.begin(), spans.end(), [](const SmoothSpan& a, const SmoothSpan& b) {
                return a.variation / a.pieces < b.variation / b.pieces;
            });
        ++worst->pieces;
    }
}

double interiorParameter(const TangentVariation& table, const SmoothSpan& span, int piece)
{
    const double fraction = piece / static_cast<double>(span.pieces);
    const double t = span.variation > 0.0
                         ? table.parameterAtVariation(span.part.first, fraction * span.variation)
                         : table.parameterAtLengthFraction(span.part.first, span.part.last, fraction);
    return std::min(t, span.part.last);
}

}  // namespace

std::vector<CurveCut> cutByVariation(const TangentVariation& table, double maxVariation, int leastPieces)
{
    std::vector<SmoothSpan> spans = smoothSpans(table, maxVariation);
    ensurePieces(spans, leastPieces);
    std::vector<CurveCut> cuts;
    double start = table.part().first;
    for (const SmoothSpan& span : spans) {
        for (int piece = 1; piece <= span.pieces; ++piece) {
            const bool isEnd = piece == span.pieces;
            const double t = isEnd ? span.part.last : interiorParameter(table, span, piece);
            if (!(start < t)) continue;
            cuts.push_back({t, isEnd});
            start = t;
        }
    }
    return cuts;
}

int firstShellExponent(double shortestEdge) { return std::ilogb(2.0 / 3.0 * shortestEdge); }

}  // namespace mesher
