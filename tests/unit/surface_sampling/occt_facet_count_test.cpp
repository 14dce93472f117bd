#include "brep/occt/read_model.h"
#include "surface_sampling/sample_surface.h"

#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <gp_GTrsf.hxx>
#include <gp_Mat.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace mesher {
namespace {

/// What the sizes wanted at the vertices of a sample ask for, and what there is.
struct FacetCount
{
    double asked = 0.0;
    double made = 0.0;
    double smallestSize = std::numeric_limits<double>::infinity();
    double shortestEdge = std::numeric_limits<double>::infinity();
};

void addFace(const FaceMesh& mesh, FacetCount& count)
{
    constexpr double kEquilateral = 0.433;
    for (std::uint32_t i = 0; i < mesh.triangleSlots(); ++i) {
        const FaceTriangle& record = mesh.triangle(TriangleId(i));
        if (!record.isAlive) continue;
        std::array<Vec3, 3> corner;
        double density = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const FaceVertex& vertex = mesh.vertex(record.v[k]);
            corner[k] = vertex.position;
            density += 1.0 / (3.0 * vertex.size * vertex.size);
            count.smallestSize = std::min(count.smallestSize, vertex.size);
        }
        const double area = 0.5 * length(cross(corner[1] - corner[0], corner[2] - corner[0]));
        count.asked += area * density / kEquilateral;
        count.made += 1.0;
        for (std::size_t k = 0; k < 3; ++k)
            count.shortestEdge = std::min(count.shortestEdge, length(corner[(k + 1) % 3] - corner[k]));
    }
}

FacetCount countOf(const SampledSurface& surface)
{
    FacetCount count;
    for (std::uint32_t f = 0; f < surface.faces().model().faces.size(); ++f)
        addFace(surface.faces().face(BrepFaceId(f))->mesh, count);
    return count;
}

TopoDS_Shape ellipsoid(double a, double b, double c)
{
    gp_GTrsf stretch;
    stretch.SetVectorialPart(gp_Mat(a, 0.0, 0.0, 0.0, b, 0.0, 0.0, 0.0, c));
    return BRepBuilderAPI_GTransform(BRepPrimAPI_MakeSphere(1.0).Shape(), stretch, true).Shape();
}

/// On the flanks beside a sharp rim facets are flat at first, and the middle of their longest side is next to the corner opposite.
TEST(OcctFacetCount, FollowsTheSizesOnFlatEllipsoids)
{
    for (const std::array<double, 3> axes :
         {std::array{20.0, 8.0, 1.0}, std::array{10.0, 10.0, 1.0}, std::array{15.0, 5.0, 0.7}}) {
        SCOPED_TRACE(std::to_string(axes[0]));
        const auto model = readModelFromShape(ellipsoid(axes[0], axes[1], axes[2]));
        ASSERT_TRUE(model);
        SurfaceSamplingOptions options;
        options.curves.segmentsPerTurn = 10.0;
        options.facets.elementsPerTurn = 10.0;
        options.facets.maxSize = 6.0;
        RunContext context;
        const auto sample = sampleSurface(model->model, options, context);
        ASSERT_TRUE(sample);
        const FacetCount count = countOf(*sample->surface);
        EXPECT_LT(count.made, 2.5 * count.asked);
        EXPECT_GT(count.shortestEdge, 0.2 * count.smallestSize);
    }
}

}  // namespace
}  // namespace mesher
