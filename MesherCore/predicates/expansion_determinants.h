#pragma once

#include "base/vec.h"
#include "predicates/expansion.h"

/// The determinants of the predicates as expansions of the raw coordinates, exact in the whole exact range.
namespace mesher::detail {

inline Expansion<4> minorXY(double px, double py, double qx, double qy)
{
    return product(px, qy) - product(py, qx);
}
inline Expansion<4> minorXY(const Vec2& p, const Vec2& q) { return minorXY(p.x, p.y, q.x, q.y); }
inline Expansion<4> minorXY(const Vec3& p, const Vec3& q) { return minorXY(p.x, p.y, q.x, q.y); }

inline Expansion<12> expansionOrient2d(const Vec2& a, const Vec2& b, const Vec2& c)
{
    return (minorXY(a, b) + minorXY(b, c)) + minorXY(c, a);
}

/// det(p, q, r), given the minors of the pairs.
inline Expansion<24> expansionTriple(const Vec3& p, const Vec3& q, const Vec3& r, const Expansion<4>& pq,
                                     const Expansion<4>& pr, const Expansion<4>& qr)
{
    return (pq * r.z - pr * q.z) + qr * p.z;
}

inline Expansion<96> expansionOrient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const Expansion<4> ab = minorXY(a, b);
    const Expansion<4> ac = minorXY(a, c);
    const Expansion<4> ad = minorXY(a, d);
    const Expansion<4> bc = minorXY(b, c);
    const Expansion<4> bd = minorXY(b, d);
    const Expansion<4> cd = minorXY(c, d);
    return (expansionTriple(b, c, d, bc, bd, cd) - expansionTriple(a, c, d, ac, ad, cd)) +
           (expansionTriple(a, b, d, ab, ad, bd) - expansionTriple(a, b, c, ab, ac, bc));
}

template <std::size_t N>
Expansion<8 * N> liftedTerm(const Expansion<N>& minor, const Vec2& p)
{
    return (minor * p.x) * p.x + (minor * p.y) * p.y;
}
template <std::size_t N>
Expansion<12 * N> liftedTerm(const Expansion<N>& minor, const Vec3& p)
{
    return ((minor * p.x) * p.x + (minor * p.y) * p.y) + (minor * p.z) * p.z;
}

/// Expanded along the column of lifts, as in the perturbation: the minor of a point is an orientation.
inline Expansion<384> expansionIncircle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    return (liftedTerm(expansionOrient2d(d, b, c), a) + liftedTerm(expansionOrient2d(a, d, c), b)) +
           (liftedTerm(expansionOrient2d(a, b, d), c) - liftedTerm(expansionOrient2d(a, b, c), d));
}

inline Expansion<5760> expansionInsphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                                         const Vec3& e)
{
    return ((liftedTerm(expansionOrient3d(e, b, c, d), a) + liftedTerm(expansionOrient3d(a, e, c, d), b)) +
            (liftedTerm(expansionOrient3d(a, b, e, d), c) + liftedTerm(expansionOrient3d(a, b, c, e), d))) -
           liftedTerm(expansionOrient3d(a, b, c, d), e);
}

}  // namespace mesher::detail
