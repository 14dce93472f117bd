#include "delaunay/locate2d.h"

#include "predicates/orient2d.h"

#include <bit>

namespace mesher {
namespace {

/// One random bit a step is all a walk needs.
class CoinFlips
{
public:
    unsigned next()
    {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 17;
        state_ ^= state_ << 5;
        return state_ & 1u;
    }

private:
    std::uint32_t state_ = 0x9E3779B9u;
};

Location2d classify(TriangleId t, unsigned edgesThroughPoint)
{
    switch (std::popcount(edgesThroughPoint)) {
        case 0: return {Location2d::Kind::InTriangle, EdgeLink(t, 0)};
        case 1:
            return {Location2d::Kind::OnEdge,
                    EdgeLink(t, static_cast<unsigned>(std::countr_zero(edgesThroughPoint)))};
        // Two edges meet in the corner opposite the third.
        default:
            return {Location2d::Kind::OnVertex,
                    EdgeLink(t, static_cast<unsigned>(std::countr_one(edgesThroughPoint)) % 3)};
    }
}

}  // namespace

Location2d locate(const Triangulation2d& mesh, const StaticFilter2d& filter, Vec2 point, TriangleId start)
{
    constexpr unsigned kNowhere = 3;
    static constexpr std::uint8_t kOrder[4][2][3] = {
        {{1, 2, 3}, {2, 1, 3}}, {{2, 0, 3}, {0, 2, 3}}, {{0, 1, 3}, {1, 0, 3}}, {{0, 1, 2}, {2, 1, 0}}};
    CoinFlips coin;
    TriangleId t = mesh.triangle(start).isGhost() ? mesh.triangle(start).n[2].triangle() : start;
    unsigned entered = kNowhere;
    for (;;) {
        const Triangle2d& record = mesh.triangle(t);
        if (record.isGhost()) return {Location2d::Kind::OutsideHull, EdgeLink(t, 2)};
        const Vec2 corners[3] = {mesh.position(record.v[0]), mesh.position(record.v[1]),
                                 mesh.position(record.v[2])};
        unsigned edgesThroughPoint = 0;
        EdgeLink exit;
        for (const unsigned edge : kOrder[entered][coin.next()]) {
            if (edge == kNowhere) break;
            const Sign side =
                orient2d(filter, corners[nextCorner(edge)], corners[previousCorner(edge)], point);
            if (side == Sign::Negative) {
                exit = record.n[edge];
                break;
            }
            if (side == Sign::Zero) edgesThroughPoint |= 1u << edge;
        }
        if (!exit.isValid()) return classify(t, edgesThroughPoint);
        t = exit.triangle();
        entered = exit.edge();
    }
}

}  // namespace mesher
