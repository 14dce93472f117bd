#pragma once

#include "predicates/sign.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace mesher::detail {

__extension__ typedef unsigned __int128 UnsignedInt128;
__extension__ typedef __int128 SignedInt128;

/// A signed integer of a fixed number of 64-bit limbs in two's complement, least significant limb first.
/// Nothing checks for overflow: the callers choose the widths from proven magnitudes.
template <std::size_t Limbs>
class FixedInteger
{
public:
    FixedInteger() = default;
    explicit FixedInteger(const std::array<std::uint64_t, Limbs>& limbs) : limb_(limbs) {}

    /// `high` * 2^62 + `low`; exact for at least two limbs.
    static FixedInteger fromParts(std::int64_t high, std::int64_t low)
    {
        static_assert(Limbs == 2);
        return ofBits(
            static_cast<UnsignedInt128>(static_cast<SignedInt128>(high) * (SignedInt128{1} << 62) + low));
    }
    static FixedInteger fromInt64(std::int64_t value)
    {
        static_assert(Limbs == 1);
        return FixedInteger({static_cast<std::uint64_t>(value)});
    }

    /// Two limbs are what the compiler can compute with itself.
    static FixedInteger ofBits(UnsignedInt128 bits)
    {
        static_assert(Limbs == 2);
        return FixedInteger({static_cast<std::uint64_t>(bits), static_cast<std::uint64_t>(bits >> 64)});
    }
    [[nodiscard]] UnsignedInt128 bits() const
    {
        static_assert(Limbs == 2);
        return (static_cast<UnsignedInt128>(limb_[1]) << 64) | limb_[0];
    }

    [[nodiscard]] std::uint64_t limb(std::size_t i) const { return limb_[i]; }
    [[nodiscard]] bool isNegative() const { return (limb_[Limbs - 1] >> 63) != 0; }
    [[nodiscard]] Sign sign() const
    {
        std::uint64_t any = 0;
        for (const std::uint64_t limb : limb_) any |= limb;
        // Without branches: near a degeneracy nothing predicts the sign.
        return static_cast<Sign>((any != 0 ? 1 : 0) - 2 * (isNegative() ? 1 : 0));
    }

    friend FixedInteger operator+(const FixedInteger& a, const FixedInteger& b)
    {
        if constexpr (Limbs == 2) return ofBits(a.bits() + b.bits());
        FixedInteger sum;
        UnsignedInt128 carry = 0;
        for (std::size_t i = 0; i < Limbs; ++i) {
            carry += static_cast<UnsignedInt128>(a.limb_[i]) + b.limb_[i];
            sum.limb_[i] = static_cast<std::uint64_t>(carry);
            carry >>= 64;
        }
        return sum;
    }
    friend FixedInteger operator-(const FixedInteger& a, const FixedInteger& b)
    {
        if constexpr (Limbs == 2) return ofBits(a.bits() - b.bits());
        FixedInteger difference;
        UnsignedInt128 carry = 1;
        for (std::size_t i = 0; i < Limbs; ++i) {
            carry += static_cast<UnsignedInt128>(a.limb_[i]) + ~b.limb_[i];
            difference.limb_[i] = static_cast<std::uint64_t>(carry);
            carry >>= 64;
        }
        return difference;
    }

    /// The full product; as wide as both factors together, so it cannot overflow.
    template <std::size_t OtherLimbs>
    friend FixedInteger<Limbs + OtherLimbs> operator*(const FixedInteger& a,
                                                      const FixedInteger<OtherLimbs>& b)
    {
        if constexpr (Limbs == 1 && OtherLimbs == 1) {
            const auto signedProduct = static_cast<SignedInt128>(static_cast<std::int64_t>(a.limb(0))) *
                                       static_cast<std::int64_t>(b.limb(0));
            return FixedInteger<2>::ofBits(static_cast<UnsignedInt128>(signedProduct));
        }
        std::array<std::uint64_t, Limbs + OtherLimbs> product{};
        for (std::size_t i = 0; i < Limbs; ++i) {
            std::uint64_t carry = 0;
            for (std::size_t j = 0; j < OtherLimbs; ++j) {
                const UnsignedInt128 term =
                    static_cast<UnsignedInt128>(a.limb(i)) * b.limb(j) + product[i + j] + carry;
                product[i + j] = static_cast<std::uint64_t>(term);
                carry = static_cast<std::uint64_t>(term >> 64);
            }
            product[i + OtherLimbs] = carry;
        }
        // The limbs read as unsigned exceed a negative value by 2^(64 * limbs): take that excess times the
        // other factor out of the upper part.
        subtractMasked<Limbs, OtherLimbs>(product, b, a.isNegative());
        subtractMasked<OtherLimbs, Limbs>(product, a, b.isNegative());
        return FixedInteger<Limbs + OtherLimbs>(product);
    }

private:
    /// product -= factor * 2^(64 * Shift) if `wanted`, modulo the width of the product.
    template <std::size_t Shift, std::size_t FactorLimbs>
    static void subtractMasked(std::array<std::uint64_t, Shift + FactorLimbs>& product,
                               const FixedInteger<FactorLimbs>& factor, bool wanted)
    {
        const std::uint64_t mask = wanted ? ~std::uint64_t{0} : 0;
        UnsignedInt128 carry = 1;
        for (std::size_t i = 0; i < FactorLimbs; ++i) {
            carry += static_cast<UnsignedInt128>(product[Shift + i]) + ~(factor.limb(i) & mask);
            product[Shift + i] = static_cast<std::uint64_t>(carry);
            carry >>= 64;
        }
    }

    std::array<std::uint64_t, Limbs> limb_;
};

}  // namespace mesher::detail
