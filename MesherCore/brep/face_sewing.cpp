#include "brep/face_sewing.h"

#include "brep/model_welding.h"
#include "brep/name_list.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mesher {

namespace {

constexpr double kRelativeDistance = 1e-6;  // of the model's diagonal
constexpr double kAbsoluteDistance = 1e-7;  // model units
constexpr double kShareOfEdge = 0.1;
constexpr int kSamples = 8;

/// Edges that bound one face, once, and faces of which no closed shell is made: those with a hole beside them.
class FaceSewing
{
public:
    explicit FaceSewing(BrepModel& model) : model_(model) {}

    void run()
    {
        findFreeEdges();
        if (free_.empty() || !(areOfSeveralFaces() || mayHaveSeam())) return;
        findDistances();
        const std::size_t splits = splitEdges();
        findFreeEdges();
        const WeldedEntities welded = weldEdges(model_, {isFree_, distance_, most_});
        tell(welded, splits);
    }

private:
    void findFreeEdges()
    {
        IdVector<BrepEdgeId, std::uint8_t> uses(model_.edges.size());
        faceOf_ = IdVector<BrepEdgeId, BrepFaceId>(model_.edges.size());
        for (std::uint32_t f = 0; f < model_.faces.size(); ++f) {
            for (const BrepLoop& loop : model_.faces[BrepFaceId(f)].loops) {
                for (const BrepCoedge& coedge : loop.coedges) {
                    uses[coedge.edge] = static_cast<std::uint8_t>(std::min(2, uses[coedge.edge] + 1));
                    faceOf_[coedge.edge] = BrepFaceId(f);
                }
            }
        }
        free_.clear();
        isFree_ = IdVector<BrepEdgeId, std::uint8_t>(model_.edges.size());
        for (std::uint32_t e = 0; e < model_.edges.size(); ++e) {
            const BrepEdgeId id(e);
            if (uses[id] != 1 || model_.edges[id].isDegenerate) continue;
            isFree_[id] = 1;
            free_.push_back(id);
        }
    }

    [[nodiscard]] bool areOfSeveralFaces() const
    {
        return std::any_of(free_.begin(), free_.end(),
                           [&](BrepEdgeId e) { return faceOf_[e] != faceOf_[free_.front()]; });
    }

    /// Of one face; a plane has none.
    [[nodiscard]] bool mayHaveSeam() const
    {
        return free_.size() > 1 && model_.faces[faceOf_[free_.front()]].surface->kind() != SurfaceKind::Plane;
    }

    [[nodiscard]] double lengthOf(const BrepEdge& edge) const
    {
        double sum = 0.0;
        for (int i = 0; i < kSamples; ++i) {
            const double a = static_cast<double>(i) / kSamples, b = static_cast<double>(i + 1) / kSamples;
            sum += length(edge.curve->position(edge.part.at(b)) - edge.curve->position(edge.part.at(a)));
        }
        return sum;
    }

    void findDistances()
    {
        double shortest = std::numeric_limits<double>::infinity();
        for (const BrepEdgeId e : free_) shortest = std::min(shortest, lengthOf(model_.edges[e]));
        most_ = kShareOfEdge * shortest;
        distance_ =
            std::min(most_, std::max(kAbsoluteDistance, kRelativeDistance * length(model_.box.extent())));
    }

    /// Vertices of free edges, in the order of x.
    [[nodiscard]] std::vector<BrepVertexId> sortedEnds()
    {
        std::vector<BrepVertexId> ends;
        facesAt_ = IdVector<BrepVertexId, std::vector<BrepFaceId>>(model_.vertices.size());
        for (const BrepEdgeId e : free_) {
            for (const BrepVertexId v : {model_.edges[e].first, model_.edges[e].last}) {
                ends.push_back(v);
                facesAt_[v].push_back(faceOf_[e]);
            }
        }
        const auto xOf = [&](BrepVertexId v) { return model_.vertices[v].position.x; };
        std::sort(ends.begin(), ends.end(), [&](BrepVertexId a, BrepVertexId b) {
            return std::pair(xOf(a), a) < std::pair(xOf(b), b);
        });
        ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
        return ends;
    }

    /// At vertices of other free edges that lie between their ends. Returns how many splits.
    std::size_t splitEdges()
    {
        const std::vector<BrepVertexId> ends = sortedEnds();
        std::size_t count = 0;
        for (const BrepEdgeId e : free_) {
            std::vector<std::pair<double, BrepVertexId>> places = placesOn(e, ends);
            for (; !places.empty(); places.pop_back(), ++count)
                split(e, places.back().first, places.back().second);
        }
        return count;
    }

    [[nodiscard]] std::vector<std::pair<double, BrepVertexId>>
    placesOn(BrepEdgeId e, const std::vector<BrepVertexId>& ends) const
    {
        const BrepEdge& edge = model_.edges[e];
        Box3 box;
        for (int i = 0; i <= kSamples; ++i)
            box.include(edge.curve->position(edge.part.at(static_cast<double>(i) / kSamples)));
        const double margin = most_ + 0.5 * length(box.extent());
        const auto first =
            std::lower_bound(ends.begin(), ends.end(), box.low.x - margin,
                             [&](BrepVertexId v, double x) { return model_.vertices[v].position.x < x; });
        std::vector<std::pair<double, BrepVertexId>> places;
        for (auto v = first; v != ends.end(); ++v) {
            const BrepVertex& vertex = model_.vertices[*v];
            if (vertex.position.x > box.high.x + margin) break;
            const auto& faces = facesAt_[*v];
            if (std::find(faces.begin(), faces.end(), faceOf_[e]) != faces.end()) continue;
            const auto t = placeBetweenEnds(edge, vertex, box, margin);
            const bool isNew =
                t && std::none_of(places.begin(), places.end(), [&](const auto& place) {
                    return length(edge.curve->position(place.first) - vertex.position) <= most_;
                });
            if (isNew) places.emplace_back(*t, *v);
        }
        std::sort(places.begin(), places.end());
        return places;
    }

    [[nodiscard]] std::optional<double> placeBetweenEnds(const BrepEdge& edge, const BrepVertex& vertex,
                                                         const Box3& box, double margin) const
    {
        const Vec3& p = vertex.position;
        const bool isNear = p.y >= box.low.y - margin && p.y <= box.high.y + margin &&
                            p.z >= box.low.z - margin && p.z <= box.high.z + margin;
        if (!isNear) return std::nullopt;
        for (const BrepVertexId end : {edge.first, edge.last}) {
            if (length(model_.vertices[end].position - p) <= most_) return std::nullopt;
        }
        const CurveProjection on = edge.curve->project(p, edge.part);
        const double limit = std::max(distance_, std::min(edge.tolerance + vertex.tolerance, most_));
        if (on.distance > limit || on.parameter <= edge.part.first || on.parameter >= edge.part.last)
            return std::nullopt;
        return on.parameter;
    }

    /// The part behind the parameter becomes an edge of its own, the last.
    void split(BrepEdgeId e, double t, BrepVertexId v)
    {
        BrepEdge rest = model_.edges[e];
        rest.part.first = t;
        rest.first = v;
        model_.edges[e].part.last = t;
        model_.edges[e].last = v;
        const BrepEdgeId added(static_cast<std::uint32_t>(model_.edges.size()));
        model_.edges.push_back(std::move(rest));
        for (BrepFace& face : model_.faces) {
            for (BrepLoop& loop : face.loops) {
                const auto use = std::find_if(loop.coedges.begin(), loop.coedges.end(),
                                              [&](const BrepCoedge& coedge) { return coedge.edge == e; });
                if (use == loop.coedges.end()) continue;
                BrepCoedge other = *use;
                other.edge = added;
                loop.coedges.insert(use->isReversed ? use : use + 1, std::move(other));
                return;
            }
        }
    }

    void tell(const WeldedEntities& welded, std::size_t splits)
    {
        if (splits > 0)
            model_.notes.push_back(std::to_string(splits) +
                                   " edges were split where edges of faces beside them end");
        if (welded.edges == 0) return;
        std::vector<std::string> pairs;
        for (std::uint32_t e = 0; e < model_.edges.size(); ++e) {
            const BrepEdgeId kept = welded.edge[BrepEdgeId(e)];
            if (kept != BrepEdgeId(e)) pairs.push_back(nameOf(BrepEdgeId(e)) + " to " + nameOf(kept));
        }
        model_.notes.push_back("faces without edges in common were sewn: " + listOf(pairs));
    }

    BrepModel& model_;
    std::vector<BrepEdgeId> free_;
    IdVector<BrepEdgeId, std::uint8_t> isFree_;
    IdVector<BrepEdgeId, BrepFaceId> faceOf_;                  ///< of free edges
    IdVector<BrepVertexId, std::vector<BrepFaceId>> facesAt_;  ///< whose free edges end there
    double distance_ = 0.0;
    double most_ = 0.0;
};

}  // namespace

void sewFaces(BrepModel& model) { FaceSewing(model).run(); }

}  // namespace mesher
