#pragma once

#include "base/indexed_map.h"
#include "delaunay/constrained_tetrahedralization.h"
#include "mesh/classified_mesh.h"

#include <cstdint>
#include <vector>

namespace mesher {

/// What a refinement may spend before it has to show vertices for it. Work is counted in tetrahedra looked at to find and
/// repair cavities (Delaunay3d::cavityWork), never in seconds, so that the same input ends at the same mesh everywhere.
struct WorkAllowance
{
    double free = 5e6;
    double perTet = 100.0;  ///< of the tetrahedralization at the start
    /// Ordinary refinement takes 25 to 40 for each vertex, everything that is tried in vain included.
    double perVertex = 1000.0;
};

/// Where the work of a refinement went, and whether it still makes headway.
/// Guarantees   depends on the operations alone, not on time
/// Cost         a few adds for each operation
class WorkLedger3d
{
public:
    /// The work that was done in vain beside one entity of the model.
    struct Entry
    {
        EntityRef entity;
        std::uint64_t work = 0;
        double share = 0.0;  ///< of all that was done in vain
    };

    WorkLedger3d(const ConstrainedTetrahedralization& tetrahedralization, const WorkAllowance& allowance);

    /// What was done since the last call has made a vertex.
    void settle() { last_ = work(); }
    /// What was done since the last call was in vain, because of an entity of the model.
    void charge(EntityRef entity);

    /// More work than the vertices made so far are worth.
    [[nodiscard]] bool isSpent() const;
    /// The entities where most of the work was done in vain, the worst first.
    [[nodiscard]] std::vector<Entry> costliest(std::size_t most) const;

private:
    [[nodiscard]] std::uint64_t work() const { return t_.delaunay->cavityWork(); }

    const ConstrainedTetrahedralization& t_;
    double free_;
    double perVertex_;
    std::uint64_t first_;
    std::uint64_t last_;
    std::uint64_t verticesAtStart_;
    IndexedMap<std::uint64_t, Entry> entries_;
};

}  // namespace mesher
