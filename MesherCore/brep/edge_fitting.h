#pragma once

#include "brep/brep_model.h"

#include <memory>
#include <string>
#include <vector>

namespace mesher {

/// Makes the curves of edges and their parameter curves on faces agree, which files do only within tolerances.
///
/// Where a parameter curve runs beside the edge or ahead of it, points of the edge projected on the surface take its place if they
/// are nearer. Where the edge itself lies off its faces by more than a little of its length, as its tolerance allows, and the stored
/// parameter curves of all its faces agree where it is, it is moved there: faces keep their loops as the file has them then, however
/// narrow they are. Where these do not agree it stays, since what lies beside both the edge and the trim of a face is on neither for
/// those who measure.
/// Guarantees   an edge moves by no more than its tolerance or the gap that it had, and lies within 1e-7 of the borders of its faces then;
///              vertices stay where they are
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
