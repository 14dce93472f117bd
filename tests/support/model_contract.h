#pragma once

#include "brep/brep_model.h"

#include <cstddef>
#include <string>
#include <vector>

namespace mesher::test {

struct ContractOptions
{
    int surfaceTrials = 8;  ///< points per face
    bool checksCurves = true;
};

/// What was tried and which promises of a model are broken, one line each that begins with the entity's name.
struct ContractReport
{
    std::vector<std::string> broken;
    std::size_t faces = 0;
    std::size_t edges = 0;
    double largestGap = 0.0;  ///< between an edge's curve and its lift from a face
};

/// The curve and surface contracts on all edges and faces, and what ties them: ends at vertices, loops head to tail, lifted
/// parameter curves on their edges, the trim's classification beside the parity of the loops.
[[nodiscard]] ContractReport checkModelContract(const BrepModel& model, const ContractOptions& options = {});

}  // namespace mesher::test
