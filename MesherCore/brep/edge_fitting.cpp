#include "brep/edge_fitting.h"

#include "brep/analytic/parameter_curves.h"
#include "brep/displaced_curve.h"
#include "brep/name_list.h"

#include <algorithm>
#include <utility>

namespace mesher {

namespace {

constexpr double kConfusion = 1e-7;

/// A parameter curve on its surface.
struct Lift
{
    const Surface* surface = nullptr;
    const ParameterCurve* curve = nullptr;

    [[nodiscard]] Vec3 at(double t) const { return surface->position(curve->position(t)); }
};

Vec3 meanAt(const std::vector<Lift>& lifts, double t)
{
    Vec3 sum;
    for (const Lift& lift : lifts) sum = sum + lift.at(t);
    return (1.0 / static_cast<double>(lifts.size())) * sum;
}

/// Are they one all along the edge?
bool doAgree(const std::vector<Lift>& lifts, Interval part)
{
    constexpr int kSamples = 32;
    for (int i = 0; i <= kSamples; ++i) {
        const double t = part.at(static_cast<double>(i) / kSamples);
        const Vec3 first = lifts.front().at(t);
        for (const Lift& lift : lifts) {
            if (!(length(lift.at(t) - first) <= kConfusion)) return false;
        }
    }
    return true;
}

/// The displaced curve that runs along the lifts, if it follows them and does not move by more than `most`.
std::shared_ptr<const Curve> displaced(const BrepEdge& edge, const std::vector<Lift>& lifts, double most)
{
    constexpr std::size_t kFewest = 16, kMost = 1024;
    constexpr double kExactness = 0.1 * kConfusion;
    for (std::size_t steps = kFewest; steps <= kMost; steps *= 2) {
        const auto parameter = [&](double i) { return edge.part.at(i / static_cast<double>(steps)); };
        std::vector<Vec3> by;
        for (std::size_t i = 0; i <= steps; ++i) {
            const double t = parameter(static_cast<double>(i));
            by.push_back(meanAt(lifts, t) - edge.curve->position(t));
            if (!(length(by.back()) <= most)) return nullptr;
        }
        auto curve = std::make_shared<DisplacedCurve>(edge.curve, edge.part, std::move(by));
        bool follows = true;
        for (std::size_t i = 0; i < steps && follows; ++i) {
            const double t = parameter(static_cast<double>(i) + 0.5);
            follows = length(meanAt(lifts, t) - curve->position(t)) <= kExactness;
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

void EdgeFitting::move(BrepEdgeId id, const std::vector<Use>& uses)
{
    constexpr double kLeastShare = 1e-5, kWorth = 0.1, kSlack = 1.01;
    BrepEdge& edge = model_.edges[id];
    double gap = 0.0;
    std::vector<Lift> lifts;
    for (const Use& use : uses) {
        gap = std::max(gap, use.coedge->gap);
        lifts.push_back({model_.faces[use.face].surface.get(), use.stored.get()});
    }
    const bool isOff = !edge.isDegenerate && gap > std::max(10.0 * kConfusion, kLeastShare * lengthOf(edge));
    if (uses.empty() || !isOff || !doAgree(lifts, edge.part)) return;
    const auto moved = displaced(edge, lifts, kSlack * std::max(edge.tolerance, gap));
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
