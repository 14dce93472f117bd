#pragma once

#include "brep/brep_model.h"

#include <optional>

namespace mesher {

/// What a mesh of a face must be, told by the face's loops alone.
struct FaceTopology
{
    int components = 0;
    /// Of the closed face, seams and poles glued; nothing where its loops touch each other, so that they do not tell it.
    std::optional<int> eulerCharacteristic;
};

/// A loop that runs counter-clockwise in the parameters bounds a component from outside, any other one a hole.
/// Requires     loops that are closed in the parameters
[[nodiscard]] FaceTopology topologyOf(const BrepModel& model, const BrepFace& face);

/// Does every edge of the shell, other than poles, run as often along its faces as against them?
[[nodiscard]] bool isClosedShell(const BrepModel& model, const BrepShell& shell);

}  // namespace mesher
