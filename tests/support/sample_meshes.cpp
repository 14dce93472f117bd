#include "support/sample_meshes.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace mesher::test {

namespace {

using GridPoint = std::array<std::uint32_t, 3>;
/// For each axis 2 k on level k, 2 k + 1 between the levels k and k + 1.
using GridClass = std::array<std::uint32_t, 3>;

class GridMesher
{
public:
    explicit GridMesher(const GridLayout& layout)
        : levels_{layout.xLevels, layout.yLevels, layout.zLevels}, step_(layout.step)
    {
        for (std::size_t axis = 0; axis < 3; ++axis) lines_[axis] = levels_[axis].back() + 1;
        enumerateEntities();
    }

    ClassifiedMesh make()
    {
        makeNodes();
        const bool isPlane = lines_[2] == 1;
        for (std::uint32_t z = 0; z + 1 < lines_[2] || (isPlane && z == 0); ++z) {
            for (std::uint32_t y = 0; y + 1 < lines_[1]; ++y) {
                for (std::uint32_t x = 0; x + 1 < lines_[0]; ++x) {
                    if (isPlane) {
                        cutSquare({x, y, z});
                    } else {
                        cutCube({x, y, z});
                    }
                }
            }
        }
        return std::move(mesh_);
    }

private:
    [[nodiscard]] std::uint32_t classAlong(std::size_t axis, std::uint32_t low, std::uint32_t high) const
    {
        const auto& levels = levels_[axis];
        const auto at = std::lower_bound(levels.begin(), levels.end(), low);
        const auto k = static_cast<std::uint32_t>(at - levels.begin());
        if (low == high && at != levels.end() && *at == low) return 2 * k;
        return at != levels.end() && *at == low ? 2 * k + 1 : 2 * k - 1;
    }

    void enumerateEntities()
    {
        std::array<std::uint32_t, 4> next{};
        GridClass c{};
        for (c[2] = 0; c[2] + 1 < 2 * levels_[2].size(); ++c[2]) {
            for (c[1] = 0; c[1] + 1 < 2 * levels_[1].size(); ++c[1]) {
                for (c[0] = 0; c[0] + 1 < 2 * levels_[0].size(); ++c[0]) {
                    const auto dimension = static_cast<std::uint8_t>(c[0] % 2 + c[1] % 2 + c[2] % 2);
                    entities_[c] = {dimension, next[dimension]++};
                }
            }
        }
    }

    template <std::size_t N>
    [[nodiscard]] EntityRef entityOf(const std::array<GridPoint, N>& points) const
    {
        GridClass result{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::uint32_t low = points[0][axis];
            std::uint32_t high = low;
            for (const GridPoint& p : points) {
                low = std::min(low, p[axis]);
                high = std::max(high, p[axis]);
            }
            result[axis] = classAlong(axis, low, high);
        }
        return entities_.at(result);
    }

    void makeNodes()
    {
        GridPoint p{};
        for (p[2] = 0; p[2] < lines_[2]; ++p[2]) {
            for (p[1] = 0; p[1] < lines_[1]; ++p[1]) {
                for (p[0] = 0; p[0] < lines_[0]; ++p[0]) {
                    const Vec3 position = {step_ * p[0], step_ * p[1], step_ * p[2]};
                    const NodeId id =
                        mesh_.nodes.push_back({position, entityOf<1>({p}), {position.x, position.y}});
                    if (mesh_.nodes[id].entity.dimension == 0)
                        mesh_.points.push_back({{id}, mesh_.nodes[id].entity});
                }
            }
        }
    }

    [[nodiscard]] NodeId nodeAt(const GridPoint& p) const
    {
        return NodeId((p[2] * lines_[1] + p[1]) * lines_[0] + p[0]);
    }

    template <std::size_t N>
    void add(const std::array<GridPoint, N>& points, std::vector<MeshElement<N>>& elements)
    {
        const EntityRef entity = entityOf(points);
        if (entity.dimension != N - 1) return;
        MeshElement<N> element;
        element.entity = entity;
        for (std::size_t k = 0; k < N; ++k) element.node[k] = nodeAt(points[k]);
        std::vector<NodeId> key(element.node.begin(), element.node.end());
        std::sort(key.begin(), key.end());
        if (seen_.insert(key).second) elements.push_back(element);
    }

    void addLine(const GridPoint& a, const GridPoint& b)
    {
        add<2>({std::min(a, b), std::max(a, b)}, mesh_.lines);
    }

    void addTriangle(const GridPoint& a, const GridPoint& b, const GridPoint& c)
    {
        add<3>({a, b, c}, mesh_.triangles);
        addLine(a, b);
        addLine(b, c);
        addLine(c, a);
    }

    void cutSquare(const GridPoint& p)
    {
        const GridPoint b = {p[0] + 1, p[1], p[2]};
        const GridPoint c = {p[0] + 1, p[1] + 1, p[2]};
        const GridPoint d = {p[0], p[1] + 1, p[2]};
        addTriangle(p, b, c);
        addTriangle(p, c, d);
    }

    /// Kuhn's six tetrahedra around the diagonal of the cube.
    void cutCube(const GridPoint& origin)
    {
        std::array<std::size_t, 3> axes = {0, 1, 2};
        do {
            std::array<GridPoint, 4> p = {origin, origin, origin, origin};
            for (std::size_t k = 0; k < 3; ++k) {
                for (std::size_t later = k + 1; later < 4; ++later) ++p[later][axes[k]];
            }
            const bool isEven = (axes[1] + 3 - axes[0]) % 3 == 1;
            if (!isEven) std::swap(p[1], p[2]);
            addTet(p);
        } while (std::next_permutation(axes.begin(), axes.end()));
    }

    void addTet(const std::array<GridPoint, 4>& p)
    {
        add<4>(p, mesh_.tets);
        addTriangle(p[1], p[2], p[3]);
        addTriangle(p[0], p[3], p[2]);
        addTriangle(p[0], p[1], p[3]);
        addTriangle(p[0], p[2], p[1]);
    }

    std::array<std::vector<std::uint32_t>, 3> levels_;
    double step_;
    std::array<std::uint32_t, 3> lines_{};
    std::map<GridClass, EntityRef> entities_;
    std::set<std::vector<NodeId>> seen_;
    ClassifiedMesh mesh_;
};

}  // namespace

ClassifiedMesh gridMesh(const GridLayout& layout) { return GridMesher(layout).make(); }

ClassifiedMesh twoFaceMesh(std::uint32_t cells)
{
    return gridMesh({{0, cells, 2 * cells}, {0, cells}, {0}, 0.1});
}

ClassifiedMesh twoSolidMesh(std::uint32_t cells)
{
    return gridMesh({{0, cells, 2 * cells}, {0, cells}, {0, cells}, 0.1});
}

}  // namespace mesher::test
