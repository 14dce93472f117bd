#include "surface_sampling/certificate.h"

#include "base/indexed_map.h"
#include "surface_sampling/facet_intersections.h"

#include <algorithm>
#include <string>

namespace mesher {
namespace {

constexpr int kRoundsOfRefinement = 200;

double squaredExtent(const SurfaceMesh& mesh, FacetId facet)
{
    double longest = 0.0;
    const auto& node = mesh.facets[facet].node;
    for (std::size_t i = 0; i < 3; ++i) {
        longest = std::max(
            longest, squaredLength(mesh.nodes[node[i]].position - mesh.nodes[node[(i + 1) % 3]].position));
    }
    return longest;
}

/// Facets beside an edge that two faces have inside of them between the same nodes, or one face where another has a segment.
std::vector<FacetIntersection> findSharedEdges(SampledSurface& surface)
{
    const SurfaceMesh& mesh = surface.mesh();
    IndexedMap<std::pair<NodeId, NodeId>, FacetId> owners;
    for (const SurfaceSegment& segment : mesh.segments) {
        if (segment.isAlive()) owners.insert(std::minmax(segment.node[0], segment.node[1]), FacetId());
    }
    std::vector<FacetIntersection> found;
    for (std::uint32_t i = 0; i < mesh.facets.size(); ++i) {
        const FacetId facet(i);
        if (!mesh.facets[facet].isAlive()) continue;
        const FaceMesh& own = surface.faces().face(mesh.facets[facet].face)->mesh;
        for (unsigned k = 0; k < 3; ++k) {
            const EdgeLink side(surface.triangleOf(facet), k);
            const FaceVertex &a = own.vertex(own.from(side)), &b = own.vertex(own.to(side));
            if (a.isFree || b.isFree || own.segment(side).isValid()) continue;
            const auto [owner, isNew] = owners.insert(std::minmax(a.node, b.node), facet);
            if (isNew) continue;
            if (owner->isValid() && mesh.facets[*owner].face == mesh.facets[facet].face) continue;
            // The last one yields, unless its surface is a plane, in which the other one has no business.
            FacetIntersection pair{owner->isValid() ? *owner : facet, facet, 0.5 * (a.position + b.position)};
            if (surface.faces().face(mesh.facets[facet].face)->geometry.isPlane())
                std::swap(pair.first, pair.second);
            found.push_back(pair);
        }
    }
    return found;
}

class Certifier
{
public:
    Certifier(SampledSurface& surface, const BudgetLimits& limits, RunContext& context)
        : surface_(surface), limits_(limits), context_(context)
    {
    }

    SurfaceCertificate run(int maxRounds)
    {
        for (;;) {
            const std::vector<FacetIntersection> crossing =
                findFacetIntersections(surface_.faces().model(), surface_.mesh(), context_);
            result_.refinement.stopReason = context_.stopReason().value_or(StopReason::Done);
            if (result_.refinement.stopReason != StopReason::Done) break;
            const std::vector<FacetIntersection> shared = findSharedEdges(surface_);
            if (result_.rounds == 0) {
                result_.found = crossing.size();
                result_.shared = shared.size();
            }
            result_.left = crossing.size() + shared.size();
            if (result_.left == 0) break;
            if (result_.rounds >= maxRounds || !(forceLarger(crossing) | forceAtEdges(shared))) {
                report(crossing);
                report(shared);
                break;
            }
            ++result_.rounds;
            const SamplingRounds rounds = surface_.faces().refine(limits_, kRoundsOfRefinement, context_);
            result_.refinement.rounds += rounds.rounds;
            result_.refinement.segmentSplits += rounds.segmentSplits;
            result_.refinement.stopReason = rounds.stopReason;
            surface_.assemble();
            if (rounds.stopReason != StopReason::Done) break;
        }
        return std::move(result_);
    }

private:
    using FacePair = std::pair<BrepFaceId, BrepFaceId>;
    struct History
    {
        double least = 0.0;  ///< number of intersections in a round
        int roundsInVain = 0;
        bool isHopeless = false;
    };

    [[nodiscard]] FacePair facesOf(const FacetIntersection& pair) const
    {
        return std::minmax(surface_.mesh().facets[pair.first].face, surface_.mesh().facets[pair.second].face);
    }
    [[nodiscard]] const FaceTriangle& triangleOf(FacetId facet) const
    {
        return surface_.faces()
            .face(surface_.mesh().facets[facet].face)
            ->mesh.triangle(surface_.triangleOf(facet));
    }
    /// Was it to be split already, in vain?
    [[nodiscard]] bool isGivenUp(FacetId facet) const { return triangleOf(facet).isForced; }

    void force(FacetId facet)
    {
        surface_.faces().force(surface_.mesh().facets[facet].face, surface_.triangleOf(facet));
    }

    /// Faces that lie in each other, as solids in contact do, only get more intersections from smaller facets.
    void findHopeless(const std::vector<FacetIntersection>& pairs)
    {
        constexpr double kFewer = 0.8, kManyMore = 1.5;
        constexpr int kMostRoundsInVain = 3;
        IndexedMap<FacePair, std::size_t> counts;
        for (const FacetIntersection& pair : pairs) ++counts[facesOf(pair)];
        for (const auto& [faces, count] : counts) {
            const auto now = static_cast<double>(count);
            const auto [history, isNew] = histories_.insert(faces, {now, 0});
            if (isNew) continue;
            if (now > kManyMore * history->least) history->roundsInVain = kMostRoundsInVain;
            history->roundsInVain += now <= kFewer * history->least ? 0 : 1;
            history->least = std::min(history->least, now);
            history->isHopeless = history->isHopeless || history->roundsInVain >= kMostRoundsInVain;
        }
    }

    bool forceLarger(const std::vector<FacetIntersection>& pairs)
    {
        findHopeless(pairs);
        std::vector<FacetId> chosen;
        for (const FacetIntersection& pair : pairs) {
            if (histories_.find(facesOf(pair))->isHopeless) continue;
            const bool isFirstLarger =
                squaredExtent(surface_.mesh(), pair.first) >= squaredExtent(surface_.mesh(), pair.second);
            FacetId larger = isFirstLarger ? pair.first : pair.second;
            if (isGivenUp(larger)) larger = isFirstLarger ? pair.second : pair.first;
            if (!isGivenUp(larger)) chosen.push_back(larger);
        }
        return forceAll(chosen);
    }

    /// Of the later face, all of whose facets at the edge go.
    bool forceAtEdges(const std::vector<FacetIntersection>& pairs)
    {
        std::vector<FacetId> chosen;
        for (const FacetIntersection& pair : pairs) {
            if (!isGivenUp(pair.second)) chosen.push_back(pair.second);
        }
        return forceAll(chosen);
    }

    bool forceAll(std::vector<FacetId>& chosen)
    {
        std::sort(chosen.begin(), chosen.end());
        chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
        for (const FacetId facet : chosen) force(facet);
        return !chosen.empty();
    }

    void report(const std::vector<FacetIntersection>& pairs)
    {
        std::vector<FacePair> reported;
        for (const FacetIntersection& pair : pairs) {
            const FacePair faces = facesOf(pair);
            if (std::find(reported.begin(), reported.end(), faces) != reported.end()) continue;
            reported.push_back(faces);
            const bool isOne = faces.first == faces.second;
            result_.errors.push_back(
                {ErrorCode::IntersectingConstraints,
                 std::string(isOne ? "its" : "their") + " facets intersect, however small they are made",
                 isOne ? nameOf(faces.first) : nameOf(faces.first) + " and " + nameOf(faces.second),
                 pair.point, "repair the faces where they touch or cross, or wish for smaller sizes there"});
        }
    }

    SampledSurface& surface_;
    BudgetLimits limits_;
    RunContext& context_;
    SurfaceCertificate result_;
    IndexedMap<FacePair, History> histories_;
};

}  // namespace

SurfaceCertificate certify(SampledSurface& surface, const BudgetLimits& limits, int maxRounds,
                           RunContext& context)
{
    return Certifier(surface, limits, context).run(maxRounds);
}

}  // namespace mesher
