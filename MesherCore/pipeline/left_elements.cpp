#include "pipeline/left_elements.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace mesher {

namespace {

std::string rounded(double value)
{
    char digits[32];
    return {digits,
            std::to_chars(std::begin(digits), std::end(digits), value, std::chars_format::general, 3).ptr};
}

std::string angleText(const LeftPlace3d& place)
{
    const std::string at =
        " meet at " + nameOf(place.entity[0]) + " at " + rounded(place.degrees) + " degrees";
    return nameOf(place.entity[1]) + " and " + nameOf(place.entity[2]) + at;
}

/// " beside Face5 and Edge2" or " in Solid1", as far as they are known.
std::string besideText(std::span<const EntityRef> entities)
{
    std::string text;
    for (const EntityRef entity : entities) {
        if (entity.index == EntityRef::kNone) continue;
        const std::string first = entity.dimension == 3 ? " in " : " beside ";
        text += (text.empty() ? first : " and ") + nameOf(entity);
    }
    return text;
}

std::string reasonOf(const LeftPlace3d& place)
{
    switch (place.reason) {
        case LeftReason3d::SmallInputAngle: return angleText(place);
        case LeftReason3d::ThinWall:
            return "the thin wall between " + nameOf(place.entity[0]) + " and " + nameOf(place.entity[1]) +
                   " is kept flat";
        case LeftReason3d::NarrowFace:
            return nameOf(place.entity[0]) + " is so narrow there that it is kept flat";
        case LeftReason3d::LengthScale:
            return "better ones would be far smaller than the shape around them" + besideText(place.entity);
        case LeftReason3d::Boundary:
            return nameOf(place.entity[0]) + " beside them cannot be split any further";
        case LeftReason3d::Resolution:
            return "no place for a better vertex was found" + besideText(place.entity);
        case LeftReason3d::NoHeadway: return "refinement made no headway" + besideText(place.entity);
        case LeftReason3d::Unfinished: return "the run was ended before";
    }
    return {};
}

std::string remedyOf(LeftReason3d reason)
{
    switch (reason) {
        case LeftReason3d::SmallInputAngle:
            return "no mesh is better beside such an angle; round it off if that matters";
        case LeftReason3d::ThinWall: return "raise --max-wall-elements, or mesh the wall as a shell";
        case LeftReason3d::NarrowFace: return "raise --max-wall-elements, or remove the face";
        case LeftReason3d::LengthScale:
        case LeftReason3d::Boundary: return "choose a smaller --size there";
        case LeftReason3d::NoHeadway:
        case LeftReason3d::Resolution: return "remove what is tiny in the model there";
        case LeftReason3d::Unfinished: return "raise the limit that ended the run";
    }
    return {};
}

LeftElements elementsOf(const LeftPlace3d& place)
{
    LeftElements left{.reason = reasonOf(place),
                      .entities = {},
                      .count = place.count,
                      .leastAngle = place.leastDihedral,
                      .largestAngle = place.largestDihedral,
                      .worst = place.worst,
                      .remedy = remedyOf(place.reason)};
    for (const EntityRef entity : place.entity) {
        if (entity.index != EntityRef::kNone) left.entities.push_back(nameOf(entity));
    }
    return left;
}

std::string reasonOf(const NonDelaunayFaces3d& faces)
{
    switch (faces.reason) {
        case NonDelaunayReason3d::Tie:
            return "five vertices are on one sphere to within rounding" + besideText(faces.entity);
        case NonDelaunayReason3d::Boundary:
            return "the triangles" + besideText(faces.entity) +
                   " would have to be flipped with them, and bend there";
        case NonDelaunayReason3d::Interlocked: return "flips keep each other from being made there";
        case NonDelaunayReason3d::Unfinished:
            return "flips and refinement undid each other's work to the end";
    }
    return {};
}

std::string remedyOf(NonDelaunayReason3d reason)
{
    switch (reason) {
        case NonDelaunayReason3d::Tie: return "none is needed";
        case NonDelaunayReason3d::Boundary:
        case NonDelaunayReason3d::Interlocked:
        case NonDelaunayReason3d::Unfinished:
            return "choose a smaller --size there if the solver needs Delaunay faces";
    }
    return {};
}

LeftFaces facesOf(const NonDelaunayFaces3d& faces)
{
    LeftFaces left{reasonOf(faces), {}, faces.count, faces.place, remedyOf(faces.reason)};
    for (const EntityRef entity : faces.entity) {
        if (entity.index != EntityRef::kNone) left.entities.push_back(nameOf(entity));
    }
    return left;
}

/// Over the tetrahedra that good walls are thought to take, of the number that a warning proposes.
constexpr double kSafety = 1.2;

std::string namesOf(const std::vector<BrepFaceId>& faces)
{
    constexpr std::size_t kMostNames = 4;
    std::string names;
    for (std::size_t i = 0; i < std::min(faces.size(), kMostNames); ++i)
        names += (i == 0 ? "" : ", ") + nameOf(faces[i]);
    if (faces.size() > kMostNames) names += " and " + std::to_string(faces.size() - kMostNames) + " more";
    return names;
}

std::string wallText(const std::array<BrepFaceId, 2>& face, double thickness)
{
    return "the wall between " + nameOf(face[0]) + " and " + nameOf(face[1]) + ", down to " +
           rounded(thickness) + " thick";
}

/// A number of elements as one would type it, rounded up.
std::string typed(double count)
{
    const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(std::max(count, 1.0))) - 1.0));
    return std::to_string(static_cast<std::uint64_t>(unit * std::ceil(count / unit)));
}

std::string warningOf(const SurveyedWall& wall)
{
    const std::string rims =
        wall.rims.empty() ? "" : ", and flat triangles on its rims " + namesOf(wall.rims);
    const std::string remedy = wall.isBelowLeastSize ? "they would be smaller than --min-size"
                                                     : "good ones would be about " + rounded(wall.tets) +
                                                           ", --max-wall-elements " +
                                                           typed(kSafety * wall.needed) + " allows that many";
    return wallText(wall.sides.face, wall.thickness) + ", is left with flat tetrahedra" + rims + ": " +
           remedy;
}

std::string warningOf(const SurveyedStrip& strip)
{
    const std::string remedy = strip.isBelowLeastSize
                                   ? "they would be smaller than --min-size"
                                   : "good ones would bring about " + rounded(strip.tets) +
                                         " tetrahedra, --max-wall-elements " + typed(kSafety * strip.needed) +
                                         " allows that many";
    return nameOf(strip.face) + ", down to " + rounded(strip.width) +
           " wide, is left with flat triangles and tetrahedra: " + remedy;
}

std::string warningOf(const ThinWall& wall)
{
    return wallText(wall.face, wall.thickness) + ", is left with flat tetrahedra: good ones would be about " +
           rounded(wall.tets) + ", --max-wall-elements " + typed(kSafety * wall.tets) + " allows that many";
}

std::string warningOf(const CoarseWall& wall)
{
    return "the wall between " + nameOf(wall.face[0]) + " and " + nameOf(wall.face[1]) + ", " +
           rounded(wall.thickness) + " thick at " + rounded(wall.place.x) + ", " + rounded(wall.place.y) +
           ", " + rounded(wall.place.z) + ", is up to " + rounded(100.0 * wall.sagShare) +
           " % off its thickness, by the chords of its facets; choose a larger --max-wall-elements";
}

/// Where more are left coarse than that, a user has to know.
constexpr double kCoarseEnough = 0.1;

constexpr std::size_t kMostWarnings = 20;

std::string warningOf(const NarrowGap& gap)
{
    return nameOf(gap.edge) + " and " + nameOf(gap.other) + " are " + rounded(gap.width) + " apart at " +
           rounded(gap.place.x) + ", " + rounded(gap.place.y) + ", " + rounded(gap.place.z) +
           ": elements between them are left flat, since good ones would be as small; join the two, or part "
           "them";
}

template <class Left>
void warnOf(const std::vector<Left>& left, const std::string& ofMore, MeshReport& report)
{
    for (std::size_t i = 0; i < std::min(left.size(), kMostWarnings); ++i)
        report.warnings.push_back(warningOf(left[i]));
    if (left.size() > kMostWarnings)
        report.warnings.push_back(std::to_string(left.size() - kMostWarnings) + ofMore);
}

/// Why refinement ended before all was done, and the entities where it spent its work.
std::string stallWarning(const RefinedVolume& refined)
{
    std::string places;
    for (const WorkLedger3d::Entry& entry : refined.costliest) {
        const bool isInside = entry.entity.index == EntityRef::kNone;
        places += (places.empty() ? "" : ", ") + (isInside ? "inside" : nameOf(entry.entity)) + " (" +
                  rounded(100.0 * entry.share) + " %)";
    }
    return "refinement was ended since it made no headway: what it tried in vain was beside " + places +
           "; the mesh is valid, with elements left there that are larger or flatter than wanted";
}

/// Why the limits of quality that were asked for are not kept, and which can be.
std::string warningOf(const UnreachableQuality3d& quality, const MeshOptions& options)
{
    const TetMeasureInfo& usual = infoOf(options.measure);
    std::string wish = "the quality asked for, " + std::string(usual.key) + " of at least " +
                       rounded(options.threshold.value_or(usual.threshold));
    if (options.maxDihedral) wish += " and angles up to " + rounded(*options.maxDihedral) + " degrees";
    // Entries of one bucket of the queue differ by a sixteenth.
    constexpr double kBucket = 15.0 / 16.0;
    const double reachable = std::max(std::floor(100.0 * kBucket * quality.best) / 100.0, usual.threshold);
    return wish + ", is out of reach on this shape: " + std::to_string(quality.bad) + " of " +
           std::to_string(quality.tets) +
           " tetrahedra were beyond it when more vertices made them no fewer, and the usual " +
           rounded(usual.threshold) + " was kept instead; about " + rounded(reachable) +
           " can be reached by --threshold";
}

}  // namespace

void tellWalls(const SurfaceSamplingCounts& counts, MeshReport& report)
{
    std::vector<SurveyedWall> kept = counts.surveyedWalls;
    std::erase_if(kept, [](const SurveyedWall& wall) { return !wall.isKept; });
    std::stable_sort(kept.begin(), kept.end(),
                     [](const SurveyedWall& a, const SurveyedWall& b) { return a.tets > b.tets; });
    warnOf(kept, " more walls are left with flat tetrahedra", report);
    std::vector<SurveyedStrip> strips = counts.surveyedStrips;
    std::erase_if(strips, [](const SurveyedStrip& strip) { return !strip.isKept; });
    std::stable_sort(strips.begin(), strips.end(),
                     [](const SurveyedStrip& a, const SurveyedStrip& b) { return a.tets > b.tets; });
    warnOf(strips, " more narrow faces are left with flat triangles", report);
    std::vector<CoarseWall> coarse = counts.walls.left;
    std::erase_if(coarse, [](const CoarseWall& wall) { return wall.sagShare < kCoarseEnough; });
    std::stable_sort(coarse.begin(), coarse.end(),
                     [](const CoarseWall& a, const CoarseWall& b) { return a.sagShare > b.sagShare; });
    warnOf(coarse, " more walls are off their thickness", report);
}

void nameFaceOverLimit(const SurfaceMesh& mesh, MeshReport& report)
{
    std::map<BrepFaceId, std::size_t> counts;
    for (const SurfaceFacet& facet : mesh.facets) {
        if (facet.isAlive()) ++counts[facet.face];
    }
    if (counts.empty()) return;
    const auto most = std::max_element(counts.begin(), counts.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    Error& error = report.failures.back();
    error.entity = nameOf(most->first);
    error.message += " by the triangles on the faces alone, most of them on this one";
}

void nameWallOverLimit(const RefinedVolume& refined, MeshReport& report)
{
    constexpr double kLargePart = 0.25;
    const auto elements = [](const ThinWall& wall) { return wall.isKept ? wall.facets : wall.tets; };
    const auto most =
        std::max_element(refined.walls.begin(), refined.walls.end(),
                         [&](const ThinWall& a, const ThinWall& b) { return elements(a) < elements(b); });
    if (most == refined.walls.end() ||
        elements(*most) < kLargePart * static_cast<double>(report.options.maxElements))
        return;
    Error& error = report.failures.back();
    error.entity =
        nameOf(EntityRef{2, most->face[0].value}) + " and " + nameOf(EntityRef{2, most->face[1].value});
    error.point = most->place;
    error.message = "the wall between them is " + rounded(most->thickness) + " thick, and takes more than " +
                    std::to_string(report.options.maxElements) + " elements" +
                    (most->isKept ? " even with flat ones" : "");
    error.remedy = "choose a larger --size, thicken the wall, mesh it as a shell with --dimension 2, or "
                   "raise --max-elements";
}

void tellLeftElements(const RefinedVolume& refined, MeshReport& report)
{
    for (const LeftPlace3d& place : refined.places) report.left.push_back(elementsOf(place));
    for (const NonDelaunayFaces3d& faces : refined.nonDelaunayFaces)
        report.nonDelaunay.push_back(facesOf(faces));
    if (refined.unreachable) report.warnings.push_back(warningOf(*refined.unreachable, report.options));
    if (refined.hasStalled) report.warnings.push_back(stallWarning(refined));
    std::vector<ThinWall> kept = refined.walls;
    // What its surface was made for is told already.
    std::erase_if(kept, [](const ThinWall& wall) { return !wall.isKept || wall.isAsked; });
    std::stable_sort(kept.begin(), kept.end(),
                     [](const ThinWall& a, const ThinWall& b) { return a.tets > b.tets; });
    warnOf(kept, " more walls are left with flat tetrahedra", report);
    warnOf(refined.gaps, " more gaps beside edges are too narrow to refine between", report);
}

}  // namespace mesher
