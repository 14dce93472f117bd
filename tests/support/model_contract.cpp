#include "support/model_contract.h"

#include "base/random.h"
#include "support/curve_contract.h"
#include "support/surface_contract.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace mesher::test {

namespace {

constexpr int kLiftSamples = 16;
constexpr int kPolygonSamples = 200;

class ModelTrial
{
public:
    ModelTrial(const BrepModel& model, const ContractOptions& options)
        : model_(model), options_(options), size_(std::max(length(model.box.extent()), 1e-300))
    {
        size_ += std::max(length(model.box.low), length(model.box.high));
    }

    ContractReport run()
    {
        for (std::uint32_t i = 0; i < model_.edges.size(); ++i) tryEdge(BrepEdgeId(i));
        for (std::uint32_t i = 0; i < model_.faces.size(); ++i) tryFace(BrepFaceId(i));
        for (const BrepSolid& solid : model_.solids) {
            if (solid.shells.empty()) report_.broken.push_back("a solid has no shell");
        }
        report_.edges = model_.edges.size();
        report_.faces = model_.faces.size();
        return std::move(report_);
    }

private:
    template <class IdType, class... Words>
    void complain(IdType id, const Words&... words)
    {
        std::ostringstream text;
        text.precision(6);
        text << nameOf(id) << ": ";
        (text << ... << words);
        report_.broken.push_back(text.str());
    }

    bool isNoted(const std::string& name) const
    {
        const auto names = [&](const std::string& note) {
            return note.find(name + " ") != std::string::npos;
        };
        return std::any_of(model_.notes.begin(), model_.notes.end(), names);
    }

    void tryEdge(BrepEdgeId id)
    {
        const BrepEdge& edge = model_.edges[id];
        if (!edge.first.isValid() || !edge.last.isValid()) return complain(id, "has no vertex");
        if (edge.isDegenerate) {
            if (edge.first != edge.last) complain(id, "is degenerate between two vertices");
            return;
        }
        if (!(edge.part.first < edge.part.last)) return complain(id, "has no range");
        tryEnd(id, edge.part.first, edge.first);
        tryEnd(id, edge.part.last, edge.last);
        if (!options_.checksCurves) return;
        for (const std::string& line : findBrokenPromises(*edge.curve, edge.part, size_)) complain(id, line);
    }

    void tryEnd(BrepEdgeId id, double t, BrepVertexId end)
    {
        const BrepEdge& edge = model_.edges[id];
        const BrepVertex& vertex = model_.vertices[end];
        const double gap = length(edge.curve->position(t) - vertex.position);
        const double allowed = std::max(edge.tolerance, vertex.tolerance) + 1e-12 * size_;
        if (gap > allowed && !isNoted(nameOf(id))) complain(id, "ends ", gap, " from ", nameOf(end));
    }

    void tryFace(BrepFaceId id)
    {
        const BrepFace& face = model_.faces[id];
        if (!face.surface || !face.trim) return complain(id, "has no surface or no trim");
        if (!(face.boundsU.length() > 0.0 && face.boundsV.length() > 0.0))
            return complain(id, "has no bounds");
        if (face.loops.empty()) complain(id, "has no loop");
        for (const BrepLoop& loop : face.loops) tryLoop(id, loop);
        for (const std::string& line :
             findBrokenPromises(*face.surface, face.boundsU, face.boundsV, size_, options_.surfaceTrials)) {
            complain(id, line);
        }
        tryTrim(id);
    }

    Vec2 endOf(const BrepCoedge& coedge, bool isHead) const
    {
        const Interval part = model_.edges[coedge.edge].part;
        return coedge.parameterCurve->position(isHead != coedge.isReversed ? part.last : part.first);
    }

    BrepVertexId vertexOf(const BrepCoedge& coedge, bool isHead) const
    {
        const BrepEdge& edge = model_.edges[coedge.edge];
        return isHead != coedge.isReversed ? edge.last : edge.first;
    }

    void tryLoop(BrepFaceId id, const BrepLoop& loop)
    {
        const BrepFace& face = model_.faces[id];
        if (loop.coedges.empty()) return complain(id, "has an empty loop");
        for (std::size_t i = 0; i < loop.coedges.size(); ++i) {
            const BrepCoedge& coedge = loop.coedges[i];
            const BrepCoedge& next = loop.coedges[(i + 1) % loop.coedges.size()];
            if (!coedge.parameterCurve || !next.parameterCurve)
                return complain(id, "has no parameter curve of ", nameOf(coedge.edge));
            if (!isNoted(nameOf(id)) && vertexOf(coedge, true) != vertexOf(next, false)) {
                complain(id, nameOf(coedge.edge), " does not lead to ", nameOf(next.edge));
            }
            const Vec3 head = face.surface->position(endOf(coedge, true)),
                       tail = face.surface->position(endOf(next, false));
            const double allowed =
                2.0 * model_.vertices[vertexOf(coedge, true)].tolerance + face.tolerance + 1e-11 * size_;
            if (length(head - tail) > allowed && !isNoted(nameOf(id)) && !isNoted(nameOf(coedge.edge)) &&
                !isNoted(nameOf(next.edge))) {
                complain(id, "its loop has a gap of ", length(head - tail), " after ", nameOf(coedge.edge));
            }
            tryLift(id, coedge);
        }
    }

    void tryLift(BrepFaceId id, const BrepCoedge& coedge)
    {
        const BrepFace& face = model_.faces[id];
        const BrepEdge& edge = model_.edges[coedge.edge];
        double gap = 0.0;
        for (int i = 0; i <= kLiftSamples; ++i) {
            const double t = edge.part.at(static_cast<double>(i) / kLiftSamples);
            const Vec3 lifted = face.surface->position(coedge.parameterCurve->position(t));
            const Vec3 exact =
                edge.isDegenerate ? model_.vertices[edge.first].position : edge.curve->position(t);
            gap = std::max(gap, length(lifted - exact));
        }
        report_.largestGap = std::max(report_.largestGap, gap);
        double allowed = std::max(edge.tolerance, face.tolerance);
        if (edge.isDegenerate) allowed = std::max(allowed, model_.vertices[edge.first].tolerance);
        if (gap > 1.01 * allowed + 1e-12 * size_ && !isNoted(nameOf(coedge.edge))) {
            complain(id, nameOf(coedge.edge), " lies ", gap, " off the face, its tolerance is ", allowed);
        }
    }

    /// All loops as polygons in the face's parameters, scaled to a unit square.
    std::vector<std::pair<Vec2, Vec2>> polygonOf(const BrepFace& face) const
    {
        const auto scaled = [&](Vec2 uv) {
            return Vec2{(uv.x - face.boundsU.first) / face.boundsU.length(),
                        (uv.y - face.boundsV.first) / face.boundsV.length()};
        };
        std::vector<std::pair<Vec2, Vec2>> sides;
        for (const BrepLoop& loop : face.loops) {
            for (std::size_t i = 0; i < loop.coedges.size(); ++i) {
                const BrepCoedge& coedge = loop.coedges[i];
                const Interval part = model_.edges[coedge.edge].part;
                Vec2 before = scaled(coedge.parameterCurve->position(part.first));
                for (int k = 1; k <= kPolygonSamples; ++k) {
                    const Vec2 at = scaled(
                        coedge.parameterCurve->position(part.at(static_cast<double>(k) / kPolygonSamples)));
                    sides.push_back({before, at});
                    before = at;
                }
                sides.push_back({scaled(endOf(coedge, true)),
                                 scaled(endOf(loop.coedges[(i + 1) % loop.coedges.size()], false))});
            }
        }
        return sides;
    }

    static Vec2 closestOn(const std::pair<Vec2, Vec2>& side, Vec2 p)
    {
        const Vec2 d = side.second - side.first;
        const double size2 = squaredLength(d);
        const double t = size2 > 0.0 ? std::clamp(dot(p - side.first, d) / size2, 0.0, 1.0) : 0.0;
        return side.first + t * d;
    }

    void tryTrim(BrepFaceId id)
    {
        const BrepFace& face = model_.faces[id];
        for (const BrepLoop& loop : face.loops) {
            // A noted edge lies elsewhere than the parameter curve that the trim was made from.
            const auto hasNone = [this](const BrepCoedge& coedge) {
                return !coedge.parameterCurve || isNoted(nameOf(coedge.edge));
            };
            if (std::any_of(loop.coedges.begin(), loop.coedges.end(), hasNone)) return;
        }
        const auto sides = polygonOf(face);
        double tolerance = 10.0 * face.tolerance + 1e-9 * size_;
        for (const BrepLoop& loop : face.loops) {
            for (const BrepCoedge& coedge : loop.coedges) {
                // The trim may know a parameter curve on the other side of the edge than the one that replaced it.
                tolerance =
                    std::max({tolerance, 4.0 * model_.edges[coedge.edge].tolerance, 4.0 * coedge.gap});
            }
        }
        Random random(40);
        const std::unique_ptr<TrimClassifier> copy = face.trim->clone();
        for (int i = 0; i < 40; ++i) {
            const Vec2 uv{face.boundsU.at(random.unit()), face.boundsV.at(random.unit())};
            const TrimSide side = face.trim->classify(uv);
            if (copy->classify(uv) != side) complain(id, "a copy of the trim disagrees at ", uv.x, " ", uv.y);
            const std::optional<bool> isInside = parity(face, sides, uv, tolerance);
            if (isInside && side != (*isInside ? TrimSide::Inside : TrimSide::Outside)) {
                complain(id, "the trim calls ", uv.x, " ", uv.y, *isInside ? " outside" : " inside",
                         " against its loops");
            }
        }
    }

    /// Is the point inside of the loops, itself or an image of it by a period? Nothing if it is too near to one to tell.
    std::optional<bool> parity(const BrepFace& face, const std::vector<std::pair<Vec2, Vec2>>& sides, Vec2 uv,
                               double tolerance) const
    {
        const double periodU = face.surface->periodU(), periodV = face.surface->periodV();
        const int turnsU = periodU > 0.0 ? 1 + static_cast<int>(face.boundsU.length() / periodU) : 0;
        const int turnsV = periodV > 0.0 ? 1 + static_cast<int>(face.boundsV.length() / periodV) : 0;
        bool isInside = false;
        for (int i = -turnsU; i <= turnsU; ++i) {
            for (int j = -turnsV; j <= turnsV; ++j) {
                const Vec2 image{uv.x + i * periodU, uv.y + j * periodV};
                const std::optional<bool> here = parityOfImage(face, sides, image, tolerance);
                if (!here) return {};
                isInside = isInside || *here;
            }
        }
        return isInside;
    }

    static std::optional<bool> parityOfImage(const BrepFace& face,
                                             const std::vector<std::pair<Vec2, Vec2>>& sides, Vec2 uv,
                                             double tolerance)
    {
        const Vec2 p{(uv.x - face.boundsU.first) / face.boundsU.length(),
                     (uv.y - face.boundsV.first) / face.boundsV.length()};
        const Vec3 position = face.surface->position(uv);
        bool isInside = false;
        for (const auto& side : sides) {
            const Vec2 q = closestOn(side, p);
            if (length(q - p) < 5e-3) return {};
            const Vec3 onSide = face.surface->position({face.boundsU.at(q.x), face.boundsV.at(q.y)});
            if (length(onSide - position) < tolerance) return {};
            const bool spans = (side.first.y > p.y) != (side.second.y > p.y);
            if (!spans) continue;
            const double share = (p.y - side.first.y) / (side.second.y - side.first.y);
            const double crossing = side.first.x + share * (side.second.x - side.first.x);
            const Vec3 beside = face.surface->position({face.boundsU.at(crossing), uv.y});
            if (length(beside - position) < tolerance) return {};
            if (crossing > p.x) isInside = !isInside;
        }
        return isInside;
    }

    const BrepModel& model_;
    ContractOptions options_;
    double size_;
    ContractReport report_;
};

}  // namespace

ContractReport checkModelContract(const BrepModel& model, const ContractOptions& options)
{
    return ModelTrial(model, options).run();
}

}  // namespace mesher::test
