#include "brep/edge_moving.h"

#include "brep/analytic/parameter_curves.h"
#include "brep/displaced_curve.h"
#include "brep/edge_fitting.h"
#include "brep/name_list.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace mesher {

namespace {

/// Where an edge should be at a parameter.
class EdgeTarget
{
public:
    struct Side
    {
        const Surface* surface = nullptr;
        const ParameterCurve* curve = nullptr;
    };

    EdgeTarget(const BrepModel& model, const BrepEdge& edge, std::vector<Side> sides, double gap)
        : edge_(edge),
          sides_(std::move(sides)),
          first_(model.vertices[edge.first].position),
          last_(model.vertices[edge.last].position),
          isShort_(!edge.isClosed() && length(last_ - first_) < kShortest * gap)
    {
    }

    /// Of the lifts of the parameter curves from one another.
    [[nodiscard]] double spreadAt(double t) const
    {
        double spread = 0.0;
        for (const Side& side : sides_)
            spread = std::max(spread, length(liftAt(side, t) - liftAt(sides_.front(), t)));
        return spread;
    }

    /// The mean of the lifts.
    [[nodiscard]] Vec3 liftAt(double t) const
    {
        Vec3 sum;
        for (const Side& side : sides_) sum = sum + liftAt(side, t);
        return (1.0 / static_cast<double>(sides_.size())) * sum;
    }

    /// The point of both surfaces that is nearest to the curve drawn to its vertices, nothing where they hardly cross.
    [[nodiscard]] std::optional<Vec3> meetingAt(double t) const
    {
        constexpr int kMostSteps = 30;
        constexpr double kLeastSine = 0.1, kAtRest = 1e-10;
        std::array<Vec2, 2> uv = {sides_[0].curve->position(t), sides_[1].curve->position(t)};
        Vec3 place = roughPlaceAt(t);
        for (int step = 0; step < kMostSteps; ++step) {
            std::array<Vec3, 2> normal;
            std::array<double, 2> ahead{};
            for (std::size_t i = 0; i < 2; ++i) {
                const SurfaceProjection foot = sides_[i].surface->project(place, uv[i]);
                uv[i] = foot.parameters;
                const Vec3 raw = sides_[i].surface->evaluate(uv[i]).normal();
                if (!(squaredLength(raw) > 0.0)) return std::nullopt;
                normal[i] = (1.0 / length(raw)) * raw;
                ahead[i] = dot(normal[i], foot.position - place);
            }
            const double cosine = dot(normal[0], normal[1]), square = 1.0 - cosine * cosine;
            if (square < kLeastSine * kLeastSine) return std::nullopt;
            const Vec3 by = ((ahead[0] - cosine * ahead[1]) / square) * normal[0] +
                            ((ahead[1] - cosine * ahead[0]) / square) * normal[1];
            place = place + by;
            if (length(by) <= kAtRest) return place;
        }
        return std::nullopt;
    }

    [[nodiscard]] bool hasTwoSides() const
    {
        return sides_.size() == 2 && sides_[0].surface != sides_[1].surface;
    }

private:
    static Vec3 liftAt(const Side& side, double t) { return side.surface->position(side.curve->position(t)); }

    // An edge that is shorter, in gaps, is known by its ends alone.
    static constexpr double kShortest = 5.0;

    /// On the curve drawn to its vertices.
    [[nodiscard]] Vec3 roughPlaceAt(double t) const
    {
        const double share = (t - edge_.part.first) / edge_.part.length();
        if (isShort_) return (1.0 - share) * first_ + share * last_;
        const Curve& curve = *edge_.curve;
        return curve.position(t) + (1.0 - share) * (first_ - curve.position(edge_.part.first)) +
               share * (last_ - curve.position(edge_.part.last));
    }

    const BrepEdge& edge_;
    std::vector<Side> sides_;
    Vec3 first_;  ///< the vertices
    Vec3 last_;
    bool isShort_;
};

/// The displaced curve that runs where the target says, if it follows it and does not move by more than `most`.
template <class Target>
std::shared_ptr<const Curve> displaced(const BrepEdge& edge, Target&& target, double most, double gap)
{
    // Curves of files have little kinks, which no number of steps follows.
    constexpr std::size_t kFewest = 16, kMost = 1024;
    constexpr double kExactness = 0.1 * kConfusion, kLastResort = 0.02;
    for (std::size_t steps = kFewest; steps <= kMost; steps *= 2) {
        const auto parameter = [&](double i) { return edge.part.at(i / static_cast<double>(steps)); };
        std::vector<Vec3> by;
        for (std::size_t i = 0; i <= steps; ++i) {
            const double t = parameter(static_cast<double>(i));
            const std::optional<Vec3> place = target(t);
            if (!place) return nullptr;
            by.push_back(*place - edge.curve->position(t));
            if (!(length(by.back()) <= most)) return nullptr;
        }
        auto curve = std::make_shared<DisplacedCurve>(edge.curve, edge.part, std::move(by));
        const double allowed = steps == kMost ? kLastResort * gap : kExactness;
        bool follows = true;
        for (std::size_t i = 0; i < steps && follows; ++i) {
            const double t = parameter(static_cast<double>(i) + 0.5);
            const std::optional<Vec3> place = target(t);
            follows = place && length(*place - curve->position(t)) <= allowed;
        }
        if (follows) return curve;
    }
    return nullptr;
}

double lengthOf(const BrepEdge& edge)
{
    constexpr int kChords = 8;
    double sum = 0.0;
    for (int i = 0; i < kChords; ++i)
        sum += length(edge.curve->position(edge.part.at((i + 1.0) / kChords)) -
                      edge.curve->position(edge.part.at((i + 0.0) / kChords)));
    return sum;
}

class EdgeMover
{
public:
    explicit EdgeMover(BrepModel& model) : model_(model), uses_(model.edges.size())
    {
        for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
            for (BrepLoop& loop : model.faces[BrepFaceId(f)].loops) {
                for (BrepCoedge& coedge : loop.coedges)
                    uses_[coedge.edge].push_back({BrepFaceId(f), &coedge, storedOf(coedge)});
            }
        }
    }

    /// The gap that the edge had, if it was moved.
    std::optional<double> move(BrepEdgeId id)
    {
        constexpr double kLeastShare = 1e-5, kWorth = 0.1;
        BrepEdge& edge = model_.edges[id];
        double gap = 0.0;
        for (const Use& use : uses_[id]) gap = std::max(gap, use.coedge->gap);
        if (edge.isDegenerate || !(gap > std::max(10.0 * kConfusion, kLeastShare * lengthOf(edge))))
            return std::nullopt;
        const std::shared_ptr<const Curve> moved = movedCurve(id, gap);
        if (!moved) return std::nullopt;
        const auto original = std::exchange(edge.curve, moved);
        std::vector<BrepCoedge> fitted;
        double left = 0.0;
        for (const Use& use : uses_[id]) {
            BrepCoedge& coedge = fitted.emplace_back(*use.coedge);
            coedge.parameterCurve = use.stored;
            EdgeFitting(model_).fit(coedge, model_.faces[use.face]);
            left = std::max(left, coedge.gap);
        }
        if (!(left <= kWorth * gap)) {
            edge.curve = original;
            return std::nullopt;
        }
        for (std::size_t i = 0; i < fitted.size(); ++i) *uses_[id][i].coedge = std::move(fitted[i]);
        return gap;
    }

private:
    struct Use
    {
        BrepFaceId face;
        BrepCoedge* coedge = nullptr;
        std::shared_ptr<const ParameterCurve> stored;  ///< of the file
    };

    static std::shared_ptr<const ParameterCurve> storedOf(const BrepCoedge& coedge)
    {
        const auto* projected = dynamic_cast<const ProjectedParameterCurve*>(coedge.parameterCurve.get());
        if (projected == nullptr) return coedge.parameterCurve;
        return projected->rough().clone();
    }

    [[nodiscard]] std::shared_ptr<const Curve> movedCurve(BrepEdgeId id, double gap) const
    {
        constexpr double kAgreement = 0.1;
        // Off both of two faces by the gap, at right angles.
        constexpr double kSlack = 1.5;
        constexpr int kSamples = 32;
        const BrepEdge& edge = model_.edges[id];
        std::vector<EdgeTarget::Side> sides;
        for (const Use& use : uses_[id])
            sides.push_back({model_.faces[use.face].surface.get(), use.stored.get()});
        const EdgeTarget target(model_, edge, std::move(sides), gap);
        const double most = kSlack * std::max(edge.tolerance, gap);
        double spread = 0.0;
        for (int i = 0; i <= kSamples; ++i)
            spread = std::max(spread, target.spreadAt(edge.part.at(static_cast<double>(i) / kSamples)));
        if (spread <= kAgreement * gap) {
            const auto lift = [&](double t) { return std::optional<Vec3>(target.liftAt(t)); };
            if (auto curve = displaced(edge, lift, most, gap)) return curve;
        }
        if (!target.hasTwoSides()) return nullptr;
        return displaced(
            edge, [&](double t) { return target.meetingAt(t); }, most, gap);
    }

    BrepModel& model_;
    IdVector<BrepEdgeId, std::vector<Use>> uses_;
};

}  // namespace

std::vector<std::string> moveEdgesOntoFaces(BrepModel& model, const std::vector<BrepFaceId>& faces)
{
    std::vector<BrepEdgeId> edges;
    for (const BrepFaceId face : faces) {
        for (const BrepLoop& loop : model.faces[face].loops) {
            for (const BrepCoedge& coedge : loop.coedges) edges.push_back(coedge.edge);
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    EdgeMover mover(model);
    std::vector<std::string> moved;
    for (const BrepEdgeId edge : edges) {
        if (const std::optional<double> gap = mover.move(edge))
            moved.push_back(nameOf(edge) + " lies up to " + roughNumber(*gap) +
                            " off its faces and was moved onto them, since their meshes failed else");
    }
    return moved;
}

}  // namespace mesher
