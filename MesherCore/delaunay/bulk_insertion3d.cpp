#include "delaunay/delaunay3d.h"
#include "delaunay/scaffold.h"
#include "delaunay/spatial_order.h"
#include "predicates/coordinate_range.h"

#include <string>

namespace mesher {

namespace {

/// Ten tetrahedra a point, more than usual sets have, still have 30-bit numbers.
constexpr std::size_t kMaxPoints = Triangulation3d::kMaxTets / 10;

constexpr std::size_t kLookAhead = 8;

/// Once this part of the points is in, the memory for all is known well enough to be claimed at once.
constexpr std::size_t kSampleShare = 8;

Result<void> checkPoints(std::span<const Vec3> points)
{
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (isFinite(points[i]) && isInExactRange(points[i])) [[likely]]
            continue;
        return checkPoint3d(points[i], "point " + std::to_string(i)).error();
    }
    return {};
}

}  // namespace

Result<BulkInsertion3d> Delaunay3d::insertPoints(std::span<const Vec3> points,
                                                 const BulkInsertionOptions3d& options, RunContext& context)
{
    if (points.size() + mesh_.vertexLimit() > kMaxPoints) {
        return Error{ErrorCode::OutOfRange,
                     "too many points for 30-bit tetrahedron numbers",
                     {},
                     {},
                     "split the point set"};
    }
    if (mesh_.wasConstrained()) {
        return Error{ErrorCode::InvalidArgument,
                     "bulk insertion into a constrained triangulation",
                     {},
                     {},
                     "insert the points one by one"};
    }
    const Result<void> valid = checkPoints(points);
    if (!valid) return valid.error();
    std::vector<Vec3> scaffold;
    const bool wantsScaffold = options.scaffold == ScaffoldPolicy::Always ||
                               (options.scaffold == ScaffoldPolicy::Automatic && isSurfaceLike(points));
    if (wantsScaffold) scaffold = scaffoldPoints(points);
    expectPointsIn(Box3::of(points));
    expectPointsIn(Box3::of(scaffold));

    BulkInsertion3d result;
    result.scaffoldPoints = static_cast<std::uint32_t>(scaffold.size());
    result.stopReason = insertInOrder(points, scaffold, options, context, result);
    mesh_.rebuildIncidentTets();
    return result;
}

/// The last rounds of the order refine the whole set evenly, so the tetrahedra per vertex stay about what they are.
void Delaunay3d::reserveAfterSample(std::size_t remaining, std::size_t inserted)
{
    if (inserted == 0) return;
    const double tetsPerVertex = 1.02 * mesh_.tetCount() / (mesh_.vertexCount() + 1.0);
    const auto further = static_cast<std::size_t>(tetsPerVertex * static_cast<double>(remaining));
    mesh_.reserve(mesh_.vertexLimit() + remaining, mesh_.tetLimit() + further);
}

StopReason Delaunay3d::insertInOrder(std::span<const Vec3> points, std::span<const Vec3> scaffold,
                                     const BulkInsertionOptions3d& options, RunContext& context,
                                     BulkInsertion3d& result)
{
    std::vector<Vec3> all;
    if (!scaffold.empty()) {
        all.assign(points.begin(), points.end());
        all.insert(all.end(), scaffold.begin(), scaffold.end());
        points = all;
    }
    const std::size_t ownCount = points.size() - scaffold.size();
    result.vertex.assign(ownCount, VertexId());
    VertexClass scaffoldClass;
    scaffoldClass.scaffold = 1;
    StageProgress progress(context, "Delaunay tetrahedralization", points.size());
    const std::vector<std::uint32_t> order = brioOrder(points, context.seed());
    for (std::size_t i = 0; i < order.size(); ++i) {
        // The points lie in memory in the caller's order, so the processor cannot guess which one is next.
        if (i == order.size() / kSampleShare) reserveAfterSample(order.size() - i, i);
        if (i + kLookAhead < order.size()) __builtin_prefetch(&points[order[i + kLookAhead]]);
        const std::uint32_t index = order[i];
        const Vec3 point{points[index].x + 0.0, points[index].y + 0.0, points[index].z + 0.0};
        const std::uint32_t before = mesh_.vertexCount();
        const bool isOwn = index < ownCount;
        const VertexId vertex = insertTrusted(point, isOwn ? options.classification : scaffoldClass);
        if (isOwn) {
            result.vertex[index] = vertex;
            if (mesh_.classification(vertex).scaffold != 0)
                mesh_.setClassification(vertex, options.classification);
            result.duplicates += mesh_.vertexCount() == before ? 1 : 0;
        }
        if (!progress.advance()) return context.stopReason().value_or(StopReason::Cancelled);
    }
    progress.finish();
    return StopReason::Done;
}

}  // namespace mesher
