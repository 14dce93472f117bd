#pragma once

#include "base/random.h"

#include <TopoDS_Shape.hxx>
#include <gp_Ax2.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>

#include <string>

namespace mesher::test {

/// Draws measures and places, of whole and half numbers if it snaps.
class Draws
{
public:
    Draws(std::uint64_t seed, bool snaps) : random_(seed), snaps_(snaps) {}

    [[nodiscard]] double extent(double low, double high);
    [[nodiscard]] double angle(double low, double high);  ///< radians; multiples of 30 degrees if it snaps
    [[nodiscard]] gp_Pnt point(const gp_Pnt& low, const gp_Pnt& high);
    [[nodiscard]] gp_Dir direction();
    [[nodiscard]] std::uint32_t below(std::uint32_t bound) { return random_.below(bound); }
    [[nodiscard]] double between(double low, double high) { return random_.between(low, high); }
    [[nodiscard]] bool snaps() const { return snaps_; }

private:
    Random random_;
    bool snaps_;
};

struct NamedShape
{
    TopoDS_Shape shape;
    std::string name;
};

/// A solid about `size` across with its origin or axis at `place`. May throw what the kernel throws.
[[nodiscard]] NamedShape randomPrimitive(Draws& draws, const gp_Pnt& place, double size);

}  // namespace mesher::test
