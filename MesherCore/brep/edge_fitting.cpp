#include "brep/edge_fitting.h"

#include "brep/analytic/parameter_curves.h"
#include "brep/displaced_curve.h"
#include "brep/name_list.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace mesher {

namespace {

constexpr double kConfusion = 1e-7;

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
std::shared_ptr<const Curve> displaced(const BrepEdge& edge, Target&& target, double most, double exactness)
{
    // Curves of files have little kinks, which no number of steps follows.
    constexpr std::size_t kFewest = 16, kMost = 256;
    constexpr double kLastResort = 20.0;
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
        const double allowed = steps == kMost ? kLastResort * exactness : exactness;
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

}  // namespace

double EdgeFitting::gapOf(const BrepEdge& edge, const ParameterCurve& curve, const Surface& surface) const
{
    constexpr int kSamples = 16;
    double gap = 0.0;
    for (int i = 0; i <= kSamples; ++i) {
        const double t = edge.part.at(static_cast<double>(i) / kSamples);
        const Vec3 exact = edge.isDegenerate ? model_.vertices[edge.first].position : edge.curve->position(t);
        gap = std::max(gap, length(surface.position(curve.position(t)) - exact));
    }
    return gap;
}

void EdgeFitting::fit(BrepCoedge& coedge, const BrepFace& face)
{
    const BrepEdge& edge = model_.edges[coedge.edge];
    coedge.gap = gapOf(edge, *coedge.parameterCurve, *face.surface);
    if (!(coedge.gap > kConfusion) || !edge.curve) return;
    auto fitted = std::make_shared<ProjectedParameterCurve>(edge.curve->clone(), face.surface->clone(),
                                                            coedge.parameterCurve->clone());
    const double fittedGap = gapOf(edge, *fitted, *face.surface);
    if (!(fittedGap < 0.5 * coedge.gap)) return;
    coedge.parameterCurve = std::move(fitted);
    coedge.gap = fittedGap;
}

IdVector<BrepEdgeId, std::vector<EdgeFitting::Use>> EdgeFitting::collectUses()
{
    IdVector<BrepEdgeId, std::vector<Use>> uses(model_.edges.size());
    for (std::uint32_t f = 0; f < model_.faces.size(); ++f) {
        for (BrepLoop& loop : model_.faces[BrepFaceId(f)].loops) {
            for (BrepCoedge& coedge : loop.coedges) {
                const auto* projected =
                    dynamic_cast<const ProjectedParameterCurve*>(coedge.parameterCurve.get());
                Use use{BrepFaceId(f), &coedge, coedge.parameterCurve, projected != nullptr};
                if (projected != nullptr) use.stored = projected->rough().clone();
                uses[coedge.edge].push_back(std::move(use));
            }
        }
    }
    return uses;
}

std::shared_ptr<const Curve> EdgeFitting::movedCurve(const BrepEdge& edge, const std::vector<Use>& uses,
                                                     double gap) const
{
    constexpr double kAgreement = 0.1, kExactness = 1e-3;
    // Off both of two faces by the gap, at right angles.
    constexpr double kSlack = 1.5;
    constexpr int kSamples = 32;
    std::vector<EdgeTarget::Side> sides;
    for (const Use& use : uses) sides.push_back({model_.faces[use.face].surface.get(), use.stored.get()});
    const EdgeTarget target(model_, edge, std::move(sides), gap);
    const double most = kSlack * std::max(edge.tolerance, gap), exactness = kExactness * gap;
    double spread = 0.0;
    for (int i = 0; i <= kSamples; ++i)
        spread = std::max(spread, target.spreadAt(edge.part.at(static_cast<double>(i) / kSamples)));
    if (spread <= kAgreement * gap) {
        const auto lift = [&](double t) { return std::optional<Vec3>(target.liftAt(t)); };
        if (auto curve = displaced(edge, lift, most, exactness)) return curve;
    }
    if (!target.hasTwoSides()) return nullptr;
    return displaced(
        edge, [&](double t) { return target.meetingAt(t); }, most, exactness);
}

void EdgeFitting::move(BrepEdgeId id, const std::vector<Use>& uses)
{
    constexpr double kLeastShare = 1e-5, kWorth = 0.1;
    BrepEdge& edge = model_.edges[id];
    double gap = 0.0;
    for (const Use& use : uses) gap = std::max(gap, use.coedge->gap);
    if (edge.isDegenerate || uses.empty() ||
        !(gap > std::max(10.0 * kConfusion, kLeastShare * lengthOf(edge))))
        return;
    const std::shared_ptr<const Curve> moved = movedCurve(edge, uses, gap);
    if (!moved) return;
    const auto original = std::exchange(edge.curve, moved);
    std::vector<BrepCoedge> fitted;
    double left = 0.0;
    for (const Use& use : uses) {
        BrepCoedge& coedge = fitted.emplace_back(*use.coedge);
        coedge.parameterCurve = use.stored;
        fit(coedge, model_.faces[use.face]);
        left = std::max(left, coedge.gap);
    }
    if (!(left <= kWorth * gap)) {
        edge.curve = original;
        return;
    }
    for (std::size_t i = 0; i < uses.size(); ++i) *uses[i].coedge = std::move(fitted[i]);
    note(nameOf(id), "lay up to " + roughNumber(gap) + " off its faces and was moved onto them");
}

void EdgeFitting::noteGap(const Use& use)
{
    const BrepCoedge& coedge = *use.coedge;
    const BrepEdge& edge = model_.edges[coedge.edge];
    const BrepFace& face = model_.faces[use.face];
    double allowed = std::max(edge.tolerance, face.tolerance);
    if (edge.isDegenerate) allowed = std::max(allowed, model_.vertices[edge.first].tolerance);
    if (coedge.parameterCurve != use.stored && use.isProjected) {
        const double storedGap = gapOf(edge, *use.stored, *face.surface);
        if (storedGap > allowed)
            note(nameOf(coedge.edge), "has a parameter curve " + roughNumber(storedGap) + " off on " +
                                          nameOf(use.face) + ", replaced by projection");
    }
    if (coedge.gap > allowed)
        note(nameOf(coedge.edge), "lies up to " + roughNumber(coedge.gap) + " off " + nameOf(use.face));
}

void EdgeFitting::finish()
{
    const IdVector<BrepEdgeId, std::vector<Use>> uses = collectUses();
    for (std::uint32_t e = 0; e < model_.edges.size(); ++e) {
        move(BrepEdgeId(e), uses[BrepEdgeId(e)]);
        for (const Use& use : uses[BrepEdgeId(e)]) noteGap(use);
    }
}

}  // namespace mesher
