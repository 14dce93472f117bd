#include "surface_sampling/triangle_intersection.h"

#include "base/random.h"

#include <gtest/gtest.h>

namespace mesher::test {
namespace {

TEST(TriangleIntersection, TellsCrossingTouchingAndApart)
{
    const TrianglePoints flat{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}};
    EXPECT_TRUE(doTrianglesMeet(flat, {Vec3{1, 1, -1}, Vec3{1, 1, 1}, Vec3{9, 9, 1}})) << "an edge pierces";
    EXPECT_TRUE(doTrianglesMeet(flat, {Vec3{1, 1, 0}, Vec3{1, 1, 1}, Vec3{2, 1, 1}})) << "a corner touches";
    EXPECT_TRUE(doTrianglesMeet(flat, {Vec3{2, 2, -1}, Vec3{2, 2, 1}, Vec3{5, 5, 0}})) << "touches an edge";
    EXPECT_FALSE(doTrianglesMeet(flat, {Vec3{2.5, 2, -1}, Vec3{2.5, 2, 1}, Vec3{5, 5, 0}}))
        << "passes by the edge";
    EXPECT_FALSE(doTrianglesMeet(flat, {Vec3{1, 1, 1}, Vec3{2, 1, 1}, Vec3{1, 2, 1}})) << "parallel";
    EXPECT_TRUE(doTrianglesMeet(flat, {Vec3{1, 1, 0}, Vec3{2, 1, 0}, Vec3{1, 2, 0}}))
        << "inside, in the plane";
    EXPECT_TRUE(doTrianglesMeet(flat, {Vec3{-1, 1, 0}, Vec3{5, 1, 0}, Vec3{5, 1.5, 0}}))
        << "across, in the plane";
    EXPECT_FALSE(doTrianglesMeet(flat, {Vec3{3, 3, 0}, Vec3{5, 3, 0}, Vec3{3, 5, 0}}))
        << "beside, in the plane";
}

TEST(TriangleIntersection, LeavesOutWhatIsShared)
{
    const TrianglePoints flat{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}};
    EXPECT_FALSE(doTrianglesMeetBeyondCorner(flat, {Vec3{0, 0, 0}, Vec3{-1, 0, 1}, Vec3{-1, -1, -1}}));
    EXPECT_TRUE(doTrianglesMeetBeyondCorner(flat, {Vec3{0, 0, 0}, Vec3{1, 1, 1}, Vec3{1, 1, -1}}));
    EXPECT_TRUE(doTrianglesMeetBeyondCorner(flat, {Vec3{0, 0, 0}, Vec3{9, 9, 0}, Vec3{9, 9, 1}}))
        << "an edge within";
    EXPECT_FALSE(doTrianglesMeetBeyondCorner(flat, {Vec3{0, 0, 0}, Vec3{9, 9, 0.001}, Vec3{9, 9, 1}}));
    EXPECT_TRUE(doTrianglesOverlapAtEdge(flat, {Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{1, 1, 0}}));
    EXPECT_FALSE(doTrianglesOverlapAtEdge(flat, {Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{1, -1, 0}}));
    EXPECT_FALSE(doTrianglesOverlapAtEdge(flat, {Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{1, 1, 1e-300}}));
}

/// In general position two triangles meet iff a side of one pierces the other.
bool doPierce(const TrianglePoints& a, const TrianglePoints& b)
{
    const auto pierces = [](const TrianglePoints& s, const TrianglePoints& t) {
        const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 p = s[i], q = s[(i + 1) % 3];
            const double hp = dot(p - t[0], n), hq = dot(q - t[0], n);
            if (hp * hq > 0.0 || hp == hq) continue;
            const Vec3 x = p + (hp / (hp - hq)) * (q - p);
            bool isInside = true;
            for (std::size_t k = 0; k < 3; ++k) {
                isInside = isInside && dot(cross(t[(k + 1) % 3] - t[k], x - t[k]), n) >= 0.0;
            }
            if (isInside) return true;
        }
        return false;
    };
    return pierces(a, b) || pierces(b, a);
}

TEST(TriangleIntersection, AgreesWithPiercingInFloatingPointOnRandomTriangles)
{
    Random random(7);
    const auto point = [&] { return Vec3{random.unit(), random.unit(), random.unit()}; };
    std::size_t meeting = 0;
    for (int i = 0; i < 20000; ++i) {
        const TrianglePoints a{point(), point(), point()}, b{point(), point(), point()};
        const bool isMeeting = doTrianglesMeet(a, b);
        meeting += isMeeting ? 1 : 0;
        ASSERT_EQ(isMeeting, doPierce(a, b));
        ASSERT_EQ(isMeeting, doTrianglesMeet(b, a));
        ASSERT_EQ(isMeeting, doTrianglesMeet({a[2], a[0], a[1]}, {b[1], b[0], b[2]}));
    }
    EXPECT_GT(meeting, 1000u);
}

}  // namespace
}  // namespace mesher::test
