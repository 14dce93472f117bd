#pragma once

#include "base/id_vector.h"
#include "delaunay/constrained_tetrahedralization.h"
#include "sizing/size_bounds.h"
#include "sizing/sizing_field.h"

#include <span>
#include <vector>

namespace mesher {

/// How large tetrahedra are to be.
struct VolumeSizing
{
    /// Tetrahedra grow with the local feature size. If false, the user's field and the facets ask for sizes.
    bool usesLocalFeatureSize = true;
    /// Tetrahedra at the boundary are about as large as the facets that they are on, and grow from there. Without the local
    /// feature size, a field, and this, only quality refines.
    bool usesFacetSides = false;
    double refinement = 1.0;  ///< R > 0: the length scale at the boundary is lfs / R
    double grading = 1.0;     ///< G > 0: length scales grow by at most distance / G
    /// Edge length wanted by the user, model units, or none; must outlive the run.
    const SizingField* field = nullptr;

    [[nodiscard]] bool isActive() const { return usesLocalFeatureSize || usesFacetSides || field != nullptr; }
};

/// The length scales LS of the vertices: what edges at a vertex are to be long. They stand in the vertex records, in units
/// of the tetrahedralization. Beside them stands a guard scale: no entity is refined for quality far below it. It counts the
/// local feature size in any case, and inside of a solid it follows its neighbours instead of growing with the distance
/// from the boundary, which the tetrahedra need not do as fast as they may.
/// Guarantees   size(v) >= guard(v) > 0; the initial ones do not depend on the numbering
/// Reference    [gosselin] section 4.4, equations 4.2 and 4.3; graded at once instead of in the order of insertion
class LengthScale3d
{
public:
    LengthScale3d(ConstrainedTetrahedralization& tetrahedralization, const VolumeSizing& sizing);

    /// At all vertices of the initial tetrahedralization. Cost: one Dijkstra search, or two if the scales differ.
    void setInitial();

    /// The user's wish, in units of the tetrahedralization; kNoSize without a field.
    [[nodiscard]] double wantedAt(const Vec3& position) const;
    [[nodiscard]] double wantedNear(const Vec3& position, double radius) const;
    [[nodiscard]] bool hasField() const { return sizing_.field != nullptr; }
    [[nodiscard]] bool isActive() const { return sizing_.isActive(); }
    /// What entities of such scales may be.
    [[nodiscard]] const SizeBounds& bounds() const
    {
        const bool isOfShape = sizing_.usesLocalFeatureSize || sizing_.field == nullptr;
        return isOfShape ? kFeatureSizeBounds : kEdgeSizeBounds;
    }

    [[nodiscard]] double size(VertexId v) const { return mesh_.lengthScale(v); }
    [[nodiscard]] double guard(VertexId v) const { return guard_[v]; }

    /// Equation 4.2 for a new vertex over its neighbours, the user's wish, and the ceiling; the guard as the neighbours' mean.
    /// True if neighbours are too high for it now: gradeAgainFrom.
    bool assign(VertexId v, std::span<const VertexId> neighbours, double sizeCeiling = kNoSize);
    /// A vertex outside of the solids has none.
    void leaveOut(VertexId v);
    /// Lowers the scales around a vertex as far as its own is too low for them; `lowered` receives those that changed.
    void gradeAgainFrom(VertexId v, std::vector<VertexId>& lowered);

private:
    void setGuard(VertexId v, double value);

    ConstrainedTetrahedralization& tetrahedralization_;
    Triangulation3d& mesh_;
    VolumeSizing sizing_;
    IdVector<VertexId, double> guard_;
    std::vector<double> growths_;
    std::vector<TetId> star_;
    std::vector<VertexId> front_;
};

}  // namespace mesher
