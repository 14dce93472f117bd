#include "delaunay/deepest_point.h"

#include "base/box.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace mesher {

namespace {

constexpr int kMostSteps = 200;
/// Slack that counts as none, in units of the box.
constexpr double kNoSlack = 1e-15;

using Row = std::array<double, 4>;

/// normal · x - distance is how far x lies in front.
struct Plane
{
    Vec3 normal;
    double distance = 0.0;
};

/// Gaussian elimination with row exchanges; false if there is no one solution.
bool solve(std::array<Row, 4> matrix, Row right, Row& result)
{
    for (unsigned column = 0; column < 4; ++column) {
        unsigned pivot = column;
        for (unsigned row = column + 1; row < 4; ++row) {
            if (std::abs(matrix[row][column]) > std::abs(matrix[pivot][column])) pivot = row;
        }
        if (!(std::abs(matrix[pivot][column]) > 0.0)) return false;
        std::swap(matrix[pivot], matrix[column]);
        std::swap(right[pivot], right[column]);
        for (unsigned row = column + 1; row < 4; ++row) {
            const double factor = matrix[row][column] / matrix[column][column];
            for (unsigned k = column; k < 4; ++k) matrix[row][k] -= factor * matrix[column][k];
            right[row] -= factor * right[column];
        }
    }
    for (unsigned i = 4; i > 0; --i) {
        const unsigned row = i - 1;
        double sum = right[row];
        for (unsigned k = i; k < 4; ++k) sum -= matrix[row][k] * result[k];
        result[row] = sum / matrix[row][row];
    }
    return true;
}

/// The planes in units of the box about its middle, behind the first four: a tetrahedron far around the box.
std::vector<Plane> planesOf(std::span<const std::array<Vec3, 3>> triangles, const Vec3& middle, double unit)
{
    std::vector<Plane> planes;
    const double s = 1.0 / std::sqrt(3.0);
    for (const Vec3& normal : {Vec3{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}})
        planes.push_back({normal, -4.0});
    for (const auto& corner : triangles) {
        const Vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
        const double size = length(normal);
        if (!(size > 0.0)) continue;
        const Vec3 direction = (1.0 / size) * normal;
        planes.push_back({direction, dot(direction, (1.0 / unit) * (corner[0] - middle))});
    }
    return planes;
}

/// Bases of four planes, each with the share it has in holding the point: shares are never negative.
class Simplex
{
public:
    explicit Simplex(const std::vector<Plane>& planes) : planes_(planes) {}

    Vec3 run()
    {
        for (int step = 0; step < kMostSteps; ++step) {
            if (!findPoint()) break;
            const unsigned entering = mostViolated();
            if (entering == planes_.size() || !exchange(entering)) break;
        }
        return point_;
    }

private:
    /// Where all four planes of the basis are at the same distance.
    bool findPoint()
    {
        std::array<Row, 4> matrix;
        Row right{};
        for (unsigned i = 0; i < 4; ++i) {
            const Plane& plane = planes_[basis_[i]];
            matrix[i] = {plane.normal.x, plane.normal.y, plane.normal.z, -1.0};
            right[i] = plane.distance;
        }
        Row solution{};
        if (!solve(matrix, right, solution)) return false;
        point_ = {solution[0], solution[1], solution[2]};
        depth_ = solution[3];
        return true;
    }

    [[nodiscard]] unsigned mostViolated() const
    {
        auto worst = static_cast<unsigned>(planes_.size());
        double least = -kNoSlack;
        for (unsigned i = 0; i < planes_.size(); ++i) {
            const double slack = dot(planes_[i].normal, point_) - planes_[i].distance - depth_;
            if (slack >= least || std::find(basis_.begin(), basis_.end(), i) != basis_.end()) continue;
            least = slack;
            worst = i;
        }
        return worst;
    }

    /// Takes a plane into the basis for the first one whose share falls to nothing.
    bool exchange(unsigned entering)
    {
        std::array<Row, 4> matrix{};
        const auto put = [](const Vec3& normal) { return Row{normal.x, normal.y, normal.z, 1.0}; };
        for (unsigned i = 0; i < 4; ++i) {
            const Row column = put(planes_[basis_[i]].normal);
            for (unsigned k = 0; k < 4; ++k) matrix[k][i] = column[k];
        }
        Row change{};
        if (!solve(matrix, put(planes_[entering].normal), change)) return false;
        unsigned leaving = 4;
        for (unsigned i = 0; i < 4; ++i) {
            if (change[i] <= 0.0) continue;
            if (leaving == 4 || share_[i] * change[leaving] < share_[leaving] * change[i]) leaving = i;
        }
        if (leaving == 4) return false;
        const double moved = share_[leaving] / change[leaving];
        for (unsigned i = 0; i < 4; ++i) share_[i] = std::max(0.0, share_[i] - moved * change[i]);
        share_[leaving] = moved;
        basis_[leaving] = entering;
        return true;
    }

    const std::vector<Plane>& planes_;
    std::array<unsigned, 4> basis_{0, 1, 2, 3};
    Row share_{0.25, 0.25, 0.25, 0.25};
    Vec3 point_;
    double depth_ = 0.0;
};

}  // namespace

Vec3 deepestPoint(std::span<const std::array<Vec3, 3>> triangles)
{
    Box3 box;
    for (const auto& triangle : triangles) {
        for (const Vec3& corner : triangle) box.include(corner);
    }
    const Vec3 middle = 0.5 * (box.low + box.high);
    const double unit = length(box.extent());
    if (!(unit > 0.0)) return middle;
    const std::vector<Plane> planes = planesOf(triangles, middle, unit);
    return middle + unit * Simplex(planes).run();
}

}  // namespace mesher
