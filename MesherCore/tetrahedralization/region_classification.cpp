#include "tetrahedralization/region_classification.h"

#include "predicates/orient3d.h"

namespace mesher {

namespace {

class RegionFlood
{
public:
    RegionFlood(ConstrainedTetrahedralization& tets, const SurfaceMesh& surface, const RegionSides& sides)
        : tets_(tets), mesh_(tets.mesh()), surface_(surface), sides_(sides), isKnown_(mesh_.tetLimit(), 0)
    {
    }

    Result<void> run()
    {
        for (std::uint32_t i = 0; i < mesh_.tetLimit(); ++i) {
            if (mesh_.isAlive(TetId(i)) && mesh_.isGhostTet(TetId(i))) give(TetId(i), kExteriorRegion);
        }
        spread();
        for (std::uint32_t i = 0; i < surface_.facets.size(); ++i) {
            if (!surface_.facets[FacetId(i)].isAlive()) continue;
            if (Result<void> result = visit(FacetId(i)); !result) return result;
        }
        return {};
    }

private:
    Result<void> visit(FacetId id)
    {
        const SurfaceFacet& facet = surface_.facets[id];
        std::array<VertexId, 3> corner;
        for (unsigned k = 0; k < 3; ++k) corner[k] = tets_.vertexOf[facet.node[k]];
        const TetFace face = findFace(corner);
        for (const TetFace side : {face, mesh_.neighbour(face)}) {
            const VertexId apex = mesh_.vertex(side.tet(), side.face());
            const Sign sign = orient3d(mesh_.position(corner[0]), mesh_.position(corner[1]),
                                       mesh_.position(corner[2]), mesh_.position(apex));
            const RegionId wanted = sides_[facet.face][sign == Sign::Positive ? 0 : 1];
            if (isKnown_[side.tet().value] == 0) {
                give(side.tet(), wanted);
                spread();
            } else if (mesh_.region(side.tet()) != wanted) {
                return contradiction(facet, mesh_.region(side.tet()), wanted);
            }
        }
        return {};
    }

    /// The first facet of a star asks for the whole of it; the flood makes most others free.
    [[nodiscard]] TetFace findFace(const std::array<VertexId, 3>& corner) const
    {
        const TetFace face = mesh_.findFace(corner[0], corner[1], corner[2]);
        MESHER_INVARIANT(face.isValid());
        return face;
    }

    [[nodiscard]] Error contradiction(const SurfaceFacet& facet, RegionId found, RegionId wanted) const
    {
        const auto name = [](RegionId region) {
            return region == kExteriorRegion ? std::string("the outside")
                                             : nameOf(BrepSolidId(region.value - 1));
        };
        Vec3 middle;
        for (const NodeId node : facet.node) middle = middle + (1.0 / 3.0) * surface_.nodes[node].position;
        return {ErrorCode::InvalidArgument,
                "beside the face is " + name(found) + " where " + name(wanted) + " is expected",
                nameOf(facet.face), middle, "close the shells, and turn faces that look the wrong way"};
    }

    void give(TetId tet, RegionId region)
    {
        isKnown_[tet.value] = 1;
        mesh_.setRegion(tet, region);
        queue_.push_back(tet);
    }

    void spread()
    {
        for (std::size_t next = 0; next < queue_.size(); ++next) {
            const TetId tet = queue_[next];
            for (int face = 0; face < 4; ++face) {
                const TetId other = mesh_.neighbour(tet, face).tet();
                if (isKnown_[other.value] != 0 || mesh_.isFaceConstrained({tet, face})) continue;
                give(other, mesh_.region(tet));
            }
        }
        queue_.clear();
    }

    ConstrainedTetrahedralization& tets_;
    Triangulation3d& mesh_;
    const SurfaceMesh& surface_;
    const RegionSides& sides_;
    std::vector<char> isKnown_;
    std::vector<TetId> queue_;
};

}  // namespace

Result<void> classifyRegions(ConstrainedTetrahedralization& tets, const SurfaceMesh& surface,
                             const RegionSides& sides)
{
    return RegionFlood(tets, surface, sides).run();
}

}  // namespace mesher
