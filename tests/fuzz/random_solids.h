#pragma once

#include <TopoDS_Shape.hxx>

#include <cstdint>
#include <string>

namespace mesher::test {

/// A solid, or solids that share faces, made of a primitive by random steps.
struct RandomSolid
{
    TopoDS_Shape shape;  ///< null if the kernel could not make the first primitive
    std::string recipe;  ///< one word for each step, in brackets what the kernel could not do or made invalid
    std::uint32_t steps = 0;  ///< how many steps there are, for masks
};

/// Draws a primitive, up to five booleans, drillings, fillets, chamfers, hollows and splits, a placement, and a scale of
/// 1e-3 … 1e4. Half of all solids have whole and half numbers as measures and lie along the axes, so that faces are coplanar,
/// tangent and coincident as people draw them.
/// A wide draw makes a third of the steps chamfers of two distances, fillets of varying radius, or boxes that touch the body or
/// stand beside it, and puts a fifth of the solids 1e5 times their size away.
/// Guarantees   same arguments, same solid; step i draws the same numbers whatever the other steps do
/// Requires     `mask`: bit i leaves step i in; the primitive and the placement are always there
[[nodiscard]] RandomSolid randomSolid(std::uint64_t seed, std::uint32_t mask = ~0u, bool isWide = false);

}  // namespace mesher::test
