#pragma once

#include "brep/brep_model.h"
#include "pipeline/mesh_outcome.h"

#include <TopoDS_Shape.hxx>

#include <string>

namespace mesher::test {

/// What is to be said of one run of the mesher.
struct SolidVerdict
{
    enum class Kind
    {
        Valid,
        Refused,  ///< by name: entity, reason and remedy
        Failed    ///< anything else; `text` says what
    };
    Kind kind = Kind::Failed;
    std::string text;
};

/// An error is clear if it names an entity that the model has, and says what is wrong and what to do.
[[nodiscard]] SolidVerdict judgeError(const Error& error);

/// Judges a run by the mesh alone, by the exact geometry of the model, and by the kernel's own measures of the shape:
/// mesh_check, model_check, each facet's distance from its face, areas and lengths of every face and edge, volumes of every
/// solid, the figures of the report.
/// Requires     `model` was made of `shape`
[[nodiscard]] SolidVerdict judge(const BrepModel& model, const TopoDS_Shape& shape,
                                 const MeshOutcome& outcome);

}  // namespace mesher::test
