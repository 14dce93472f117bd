#pragma once

#include "base/budget.h"
#include "delaunay/constrained_tetrahedralization.h"

#include <cstdint>

namespace mesher {

struct ConstrainedDelaunayCounts
{
    std::uint64_t flips = 0;
    std::uint32_t cavities = 0;
};

/// Makes each unconstrained face locally Delaunay: by flips from a queue of faces, and where these are stuck by filling the
/// tetrahedra around anew. What is stuck after that stays: there need not be a
/// constrained Delaunay tetrahedralization.
/// Guarantees   constraints stay
/// Terminates   always: each change lowers the lifted surface of the tetrahedra
/// Reference    [lawson1977] [joe1991], [gosselin] §3.3.3 "Obtaining a CDT"
ConstrainedDelaunayCounts makeConstrainedDelaunay(ConstrainedTetrahedralization& tets, Budget& budget,
                                                  RunContext& context);

}  // namespace mesher
