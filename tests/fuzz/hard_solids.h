#pragma once

#include <TopoDS_Shape.hxx>

#include <cstdint>
#include <string>

namespace mesher::test {

/// A solid, or solids, as careless modelling leaves them.
struct HardSolid
{
    TopoDS_Shape shape;  ///< null if the kernel could not make the body
    std::string recipe;  ///< one word for each step, in brackets what the kernel could not do or made invalid
};

/// Draws a body of `hardBody` or a plain one, up to four steps (varying fillets, walls, threads, tiny holes, fuses with what nearly
/// coincides or with the mirror image, edges that lie off their faces within a tolerance that the file tells), and at the end a
/// scale of 1e-6 … 1e6 or a place up to 1e5 sizes away from the origin.
/// Guarantees   same arguments, same solid
[[nodiscard]] HardSolid hardSolid(std::uint64_t seed);

}  // namespace mesher::test
