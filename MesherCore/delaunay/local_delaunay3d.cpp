#include "delaunay/local_delaunay3d.h"

#include "delaunay/delaunay3d.h"

#include <cstddef>
#include <cstdint>

namespace mesher {

LocalDelaunay3d::LocalDelaunay3d() = default;

LocalDelaunay3d::~LocalDelaunay3d() = default;

void LocalDelaunay3d::triangulate(const Triangulation3d& mesh, std::span<const VertexId> corners)
{
    if (!delaunay_) {
        delaunay_ = std::make_unique<Delaunay3d>();
    } else {
        delaunay_->clear();
    }
    corners_.assign(corners.begin(), corners.end());
    Box3 box;
    for (const VertexId corner : corners_) box.include(mesh.position(corner));
    delaunay_->expectPointsIn(box);
    for (const VertexId corner : corners_) delaunay_->insertTrusted(mesh.position(corner));
    isInside_.assign(tets().tetLimit(), 0);
    isBounded_.assign(std::size_t{tets().tetLimit()} * 4, 0);
    queue_.clear();
}

bool LocalDelaunay3d::isInSpace() const { return delaunay_->dimension() == 3; }

const Triangulation3d& LocalDelaunay3d::tets() const { return delaunay_->triangulation(); }

void LocalDelaunay3d::bound(TetFace face, bool isInside)
{
    const std::uint32_t tet = face.tet().value;
    isBounded_[tet * 4 + static_cast<std::uint32_t>(face.face())] = 1;
    if (!isInside) return;
    if (isInside_[tet] == 0) queue_.push_back(face.tet());
    isInside_[tet] = 1;
}

bool LocalDelaunay3d::flood(bool areGhostsAllowed, std::vector<TetCorners>& filling)
{
    for (std::size_t next = 0; next < queue_.size(); ++next) {
        const TetRecord& record = tets().tet(queue_[next]);
        if (!areGhostsAllowed && isGhost(record.vertex[3])) return false;
        filling.push_back({original(record.vertex[0]), original(record.vertex[1]), original(record.vertex[2]),
                           original(record.vertex[3])});
        for (unsigned face = 0; face < 4; ++face) {
            const TetId other = record.neighbour[face].tet();
            if (isBounded_[queue_[next].value * 4 + face] != 0 || isInside_[other.value] != 0) continue;
            isInside_[other.value] = 1;
            queue_.push_back(other);
        }
    }
    return true;
}

}  // namespace mesher
