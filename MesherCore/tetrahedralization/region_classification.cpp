#include "tetrahedralization/region_classification.h"

#include <algorithm>
#include <string>

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
        for (std::uint32_t i = 0; i < mesh_.tetLimit(); ++i) {
            const TetId tet(i);
            if (!mesh_.isAlive(tet) || (mesh_.flags(tet) & tet_flag::kFaces) == 0) continue;
            for (int face = 0; face < 4; ++face) {
                if (!mesh_.isFaceConstrained({tet, face})) continue;
                if (Result<void> result = visit({tet, face}); !result) return result;
            }
        }
        return {};
    }

private:
    Result<void> visit(TetFace side)
    {
        const std::array<VertexId, 3> corner = mesh_.faceVertices(side);
        std::array<VertexId, 3> key = corner;
        std::sort(key.begin(), key.end());
        const FacetId* id = tets_.facetOf.find(key);
        MESHER_INVARIANT(id != nullptr);
        const SurfaceFacet& facet = surface_.facets[*id];
        // The tetrahedron is in front of its face, so in front of the facet if both turn in the same sense.
        unsigned first = 0;
        while (tets_.vertexOf[facet.node[first]] != corner[0]) ++first;
        const bool isInFront = tets_.vertexOf[facet.node[(first + 1) % 3]] == corner[1];
        const RegionId wanted = sides_[facet.face][isInFront ? 0 : 1];
        if (isKnown_[side.tet().value] == 0) {
            give(side.tet(), wanted);
            spread();
        } else if (mesh_.region(side.tet()) != wanted) {
            return contradiction(facet, mesh_.region(side.tet()), wanted);
        }
        return {};
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
