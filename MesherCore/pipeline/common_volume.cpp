#include "pipeline/common_volume.h"

#include "pipeline/tet_clipping.h"

#include <algorithm>
#include <cmath>

namespace mesher {

namespace {

constexpr std::size_t kMostSamples = 20'000;

Box3 common(const Box3& a, const Box3& b)
{
    return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y), std::max(a.low.z, b.low.z)},
            {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y), std::min(a.high.z, b.high.z)}};
}

bool isEmpty(const Box3& box)
{
    return !(box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z);
}

/// Finds the boxes that meet another one: in cells along the three axes, about one for each box.
class BoxGrid
{
public:
    BoxGrid(const Box3& whole, std::size_t count) : whole_(whole)
    {
        sides_ = std::clamp(static_cast<int>(std::cbrt(static_cast<double>(count))), 1, 64);
        cells_.resize(static_cast<std::size_t>(sides_) * static_cast<std::size_t>(sides_) *
                      static_cast<std::size_t>(sides_));
    }

    void add(std::uint32_t item, const Box3& box)
    {
        forCells(box, [&](std::vector<std::uint32_t>& cell) { cell.push_back(item); });
    }

    /// Each item once, in ascending order.
    [[nodiscard]] std::vector<std::uint32_t> meeting(const Box3& box)
    {
        std::vector<std::uint32_t> items;
        forCells(box, [&](const std::vector<std::uint32_t>& cell) {
            items.insert(items.end(), cell.begin(), cell.end());
        });
        std::sort(items.begin(), items.end());
        items.erase(std::unique(items.begin(), items.end()), items.end());
        return items;
    }

private:
    [[nodiscard]] int cellAt(double place, double low, double high) const
    {
        if (!(high > low)) return 0;
        return std::clamp(static_cast<int>(sides_ * (place - low) / (high - low)), 0, sides_ - 1);
    }

    template <class Visit>
    void forCells(const Box3& box, Visit visit)
    {
        const Vec3 &low = whole_.low, &high = whole_.high;
        const int lastX = cellAt(box.high.x, low.x, high.x);
        const int lastY = cellAt(box.high.y, low.y, high.y);
        const int lastZ = cellAt(box.high.z, low.z, high.z);
        for (int x = cellAt(box.low.x, low.x, high.x); x <= lastX; ++x) {
            for (int y = cellAt(box.low.y, low.y, high.y); y <= lastY; ++y) {
                for (int z = cellAt(box.low.z, low.z, high.z); z <= lastZ; ++z)
                    visit(cells_[static_cast<std::size_t>((x * sides_ + y) * sides_ + z)]);
            }
        }
    }

    Box3 whole_;
    int sides_ = 1;
    std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace

CommonVolumes::CommonVolumes(const ClassifiedMesh& mesh) : mesh_(mesh)
{
    for (std::uint32_t i = 0; i < mesh.tets.size(); ++i) {
        const std::uint32_t solid = mesh.tets[i].entity.index;
        if (solid == EntityRef::kNone) continue;
        if (solid >= tetsOf_.size()) {
            tetsOf_.resize(solid + 1);
            boxOf_.resize(solid + 1);
        }
        tetsOf_[solid].push_back(i);
        for (const NodeId node : mesh.tets[i].node) boxOf_[solid].include(mesh.nodes[node].position);
    }
}

double CommonVolumes::between(std::uint32_t first, std::uint32_t second) const
{
    if (std::max(first, second) >= tetsOf_.size()) return 0.0;
    const Box3 box = common(boxOf_[first], boxOf_[second]);
    if (isEmpty(box)) return 0.0;
    std::vector<Tet> fine = tetsIn(first, box);
    std::vector<Tet> coarse = tetsIn(second, box);
    if (fine.size() < coarse.size()) std::swap(fine, coarse);
    BoxGrid grid(box, coarse.size());
    for (std::uint32_t i = 0; i < coarse.size(); ++i) grid.add(i, coarse[i].box);
    const std::size_t stride = fine.size() / kMostSamples + 1;
    const auto cornersAt = [this](std::uint32_t tet) {
        TetPoints points;
        for (std::size_t k = 0; k < 4; ++k) points[k] = mesh_.nodes[mesh_.tets[tet].node[k]].position;
        return points;
    };
    double volume = 0.0;
    for (std::size_t i = 0; i < fine.size(); i += stride) {
        const TetPoints own = cornersAt(fine[i].index);
        for (const std::uint32_t k : grid.meeting(fine[i].box)) {
            if (isEmpty(common(fine[i].box, coarse[k].box))) continue;
            volume += commonVolume(own, cornersAt(coarse[k].index));
        }
    }
    return static_cast<double>(stride) * volume;
}

std::vector<CommonVolumes::Tet> CommonVolumes::tetsIn(std::uint32_t solid, const Box3& box) const
{
    std::vector<Tet> found;
    for (const std::uint32_t index : tetsOf_[solid]) {
        Tet tet{index, {}};
        for (const NodeId node : mesh_.tets[index].node) tet.box.include(mesh_.nodes[node].position);
        if (!isEmpty(common(tet.box, box))) found.push_back(tet);
    }
    return found;
}

}  // namespace mesher
