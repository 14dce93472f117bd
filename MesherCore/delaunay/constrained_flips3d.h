#pragma once

#include "base/budget.h"
#include "delaunay/constrained_check.h"
#include "delaunay/delaunay3d.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace mesher {

struct ConstrainedFlipCounts
{
    std::uint64_t flips = 0;
    std::uint64_t cavities = 0;  ///< filled anew where flips were stuck
};

/// Makes unconstrained faces locally Delaunay: by flips from a queue of faces, and where these are stuck by filling the
/// tetrahedra around anew. What is stuck after that stays: there need not be a constrained Delaunay tetrahedralization.
/// Guarantees   constraints stay; each change is made only for a face with the vertex behind strictly inside of the sphere
///              of the tetrahedron before, so that cospherical points stand as they are
/// Terminates   always: each change lowers the lifted surface of the tetrahedra
/// Reference    [lawson1977] [joe1991], [gosselin] §3.3.3 "Obtaining a CDT"
class ConstrainedFlips3d
{
public:
    ConstrainedFlips3d(Delaunay3d& delaunay, DelaunayPart part);
    ~ConstrainedFlips3d();

    /// Queues the faces that are not Delaunay: all of the part, or those of live tetrahedra among some.
    void pushAll(Budget& budget);
    void push(std::span<const TetId> tets);

    /// Flips until nothing waits or all that waits is stuck.
    void flip(Budget& budget);
    /// Flips and fills until nothing waits or neither helps.
    void flipAndFill(Budget& budget);

    /// The tetrahedra that were made since the last call of clearCreated; some may be gone again.
    [[nodiscard]] const std::vector<TetId>& created() const;
    void clearCreated();
    /// The faces that the last flip or flipAndFill could not make Delaunay; some may be gone or Delaunay by now.
    [[nodiscard]] const std::vector<TetFace>& stuck() const;
    [[nodiscard]] bool isNotDelaunay(TetFace face) const;
    [[nodiscard]] const ConstrainedFlipCounts& counts() const;

private:
    class Work;
    std::unique_ptr<Work> work_;
};

}  // namespace mesher
