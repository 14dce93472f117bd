#include "brep/edge_fitting.h"

#include "brep/analytic/parameter_curves.h"
#include "brep/name_list.h"

#include <algorithm>
#include <utility>

namespace mesher {

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

void EdgeFitting::fit(BrepCoedge& coedge, const BrepFace& face) const
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

void EdgeFitting::noteGaps(const BrepCoedge& coedge, BrepFaceId id)
{
    const BrepEdge& edge = model_.edges[coedge.edge];
    const BrepFace& face = model_.faces[id];
    double allowed = std::max(edge.tolerance, face.tolerance);
    if (edge.isDegenerate) allowed = std::max(allowed, model_.vertices[edge.first].tolerance);
    const auto* projected = dynamic_cast<const ProjectedParameterCurve*>(coedge.parameterCurve.get());
    const double storedGap = projected == nullptr ? 0.0 : gapOf(edge, projected->rough(), *face.surface);
    const auto note = [&](const std::string& text) {
        model_.notes.push_back(nameOf(coedge.edge) + " " + text);
    };
    if (storedGap > allowed)
        note("has a parameter curve " + roughNumber(storedGap) + " off on " + nameOf(id) +
             ", replaced by projection");
    if (coedge.gap > allowed) note("lies up to " + roughNumber(coedge.gap) + " off " + nameOf(id));
}

}  // namespace mesher
