#include "pipeline/left_triangles.h"

#include "triangulation2d/small_angle_report2d.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <map>
#include <string>

namespace mesher {

namespace {

constexpr auto kAtSmallAngle = "edges of the shape meet there at a small angle";
constexpr auto kAtRim = "the rim of a thin wall is kept flat";
constexpr auto kOnStrip = "the face is so narrow there that it is kept flat";
constexpr auto kNoPlace = "no place for a better vertex was found";

std::string rounded(double value)
{
    char digits[32];
    return {digits,
            std::to_chars(std::begin(digits), std::end(digits), value, std::chars_format::general, 3).ptr};
}

std::string listed(const std::vector<std::string>& names)
{
    constexpr std::size_t kMostNames = 4;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kMostNames); ++i)
        text += (i == 0 ? "" : ", ") + names[i];
    if (names.size() > kMostNames) text += " and " + std::to_string(names.size() - kMostNames) + " more";
    return text;
}

LeftElements trianglesLeft(const char* reason, const std::string& entity, const char* remedy)
{
    LeftElements left;
    left.reason = reason;
    left.entities = {entity};
    left.remedy = remedy;
    left.dimension = 2;
    return left;
}

LeftElements trianglesLeft(FacetLeft reason, const std::string& face)
{
    switch (reason) {
        case FacetLeft::SmallAngle:
            return trianglesLeft(kAtSmallAngle, face,
                                 "no mesh is better there; round the angle off if that matters");
        case FacetLeft::Rim: return trianglesLeft(kAtRim, face, "raise --max-wall-elements");
        case FacetLeft::Strip: return trianglesLeft(kOnStrip, face, "raise --max-wall-elements");
        case FacetLeft::No:
        case FacetLeft::Resolution: break;
    }
    return trianglesLeft(kNoPlace, face,
                         "choose a smaller --size there, or remove what is tiny in the model");
}

/// One warning for each reason, with the entities of all its places.
void warnOfLeft(MeshReport& report)
{
    std::map<std::string, LeftElements> byReason;
    for (const LeftElements& left : report.left) {
        LeftElements& all = byReason.try_emplace(left.reason).first->second;
        all.count += left.count;
        all.leastAngle = std::min(all.leastAngle, left.leastAngle);
        all.entities.insert(all.entities.end(), left.entities.begin(), left.entities.end());
    }
    for (const auto& [reason, all] : byReason) {
        report.warnings.push_back(std::to_string(all.count) + " triangles at " + listed(all.entities) +
                                  " have angles below the " + rounded(report.options.minAngle) +
                                  " degrees of --min-angle, down to " + rounded(all.leastAngle) + ": " +
                                  reason);
    }
}

void warnOfUnreachableAngle(const std::string& where, double kept, MeshReport& report)
{
    report.warnings.push_back("the angle of " + rounded(report.options.minAngle) +
                              " degrees asked for by --min-angle is out of reach on " + where +
                              ": more vertices made bad triangles no fewer, and " + rounded(kept) +
                              " degrees were kept instead");
}

std::string nameOfCurve(const PlanarCurveComplex& complex, PccCurveId curve)
{
    return nameOf(complex.curves[curve.value].edge);
}

/// Those that no small angle is to blame for, by the face that they are on.
std::map<std::string, LeftElements> withoutPlace(const PlanarCurveComplex& complex,
                                                 const PlanarResult& result)
{
    const PlanarTriangulation& t = result.triangulation;
    std::map<std::string, LeftElements> byFace;
    for (const LeftTriangle2d& triangle : result.refinement.left) {
        if (triangle.reason != LeftReason2d::Resolution) continue;
        const Triangle2d& record = t.mesh().triangle(triangle.triangle);
        const std::string& face = complex.regionNames[record.region.value - 1];
        LeftElements& left =
            byFace.try_emplace(face, trianglesLeft(FacetLeft::Resolution, face)).first->second;
        ++left.count;
        left.largestAngle = std::max(left.largestAngle, triangle.largestAngle);
        if (triangle.smallestAngle >= left.leastAngle) continue;
        left.leastAngle = triangle.smallestAngle;
        const Vec2 sum =
            t.mesh().position(record.v[0]) + t.mesh().position(record.v[1]) + t.mesh().position(record.v[2]);
        left.worst = complex.frame.toSpace((1.0 / (3.0 * t.scale)) * sum);
    }
    return byFace;
}

}  // namespace

void tellLeftTriangles(const std::vector<LeftFacets>& all, MeshReport& report)
{
    for (const LeftFacets& facets : all) {
        LeftElements left = trianglesLeft(facets.reason, nameOf(facets.face));
        left.count = facets.count;
        left.leastAngle = facets.leastAngle;
        left.largestAngle = facets.largestAngle;
        left.worst = facets.worst;
        report.left.push_back(std::move(left));
    }
    warnOfLeft(report);
}

void tellUnreachableAngles(const SurfaceSamplingCounts& counts, MeshReport& report)
{
    if (counts.facesWithoutAngle.empty()) return;
    std::vector<std::string> names;
    for (const BrepFaceId face : counts.facesWithoutAngle) names.push_back(nameOf(face));
    warnOfUnreachableAngle(listed(names), FacetCriteriaOptions{}.minAngle, report);
}

void tellLeftTriangles(const PlanarCurveComplex& complex, const PlanarResult& result, MeshReport& report)
{
    for (const TrianglesBesideAngle2d& beside : trianglesBesideSmallAngles(result)) {
        LeftElements left = trianglesLeft(FacetLeft::SmallAngle, nameOfCurve(complex, beside.angle.first));
        left.entities.push_back(nameOfCurve(complex, beside.angle.last));
        left.count = beside.triangles;
        left.leastAngle = beside.smallestAngle;
        left.largestAngle = beside.largestAngle;
        left.worst = complex.frame.toSpace(beside.apex);
        report.left.push_back(std::move(left));
    }
    for (auto& [face, left] : withoutPlace(complex, result)) {
        report.left.push_back(std::move(left));
    }
    warnOfLeft(report);
    if (result.refinement.unreachable)
        warnOfUnreachableAngle("this domain", result.refinement.unreachable->kept, report);
}

}  // namespace mesher
