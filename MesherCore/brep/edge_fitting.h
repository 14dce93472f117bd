#pragma once

#include "brep/brep_model.h"

#include <memory>
#include <string>
#include <vector>

namespace mesher {

/// Makes the curves of edges and their parameter curves on faces agree, which files do only within tolerances.
///
/// Where a parameter curve runs beside the edge or ahead of it, points of the edge projected on the surface take its place if they
/// are nearer. Where the edge itself lies off its faces by more than a little of its length, as its tolerance allows, it is moved:
/// to where the stored parameter curves agree that it is, else to where the two faces meet. Faces keep their loops as the file has
/// them then, however narrow they are, and meshes of neighbours have one line in common that lies on both.
/// Guarantees   an edge moves by no more than one and a half times its tolerance or the gap that it had, and lies off its faces by less
///              than a tenth of that gap then; vertices stay where they are
class EdgeFitting
{
public:
    explicit EdgeFitting(BrepModel& model) : model_(model) {}

    /// Measures the coedge's gap and projects the edge where that is nearer than the parameter curve.
    void fit(BrepCoedge& coedge, const BrepFace& face);

    /// Once all faces are there: moves edges, and notes what was changed and which gaps are left.
    void finish();

private:
    struct Use
    {
        BrepFaceId face;
        BrepCoedge* coedge = nullptr;
        std::shared_ptr<const ParameterCurve>
            stored;  ///< of the file, in whose place a projection may have come
        bool isProjected = false;
    };

    [[nodiscard]] double gapOf(const BrepEdge& edge, const ParameterCurve& curve,
                               const Surface& surface) const;
    [[nodiscard]] std::shared_ptr<const Curve> movedCurve(const BrepEdge& edge, const std::vector<Use>& uses,
                                                          double gap) const;
    [[nodiscard]] IdVector<BrepEdgeId, std::vector<Use>> collectUses();
    void move(BrepEdgeId id, const std::vector<Use>& uses);
    void noteGap(const Use& use);
    void note(const std::string& entity, const std::string& text)
    {
        model_.notes.push_back(entity + " " + text);
    }

    BrepModel& model_;
};

}  // namespace mesher
