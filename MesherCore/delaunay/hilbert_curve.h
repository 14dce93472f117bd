#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace mesher {

/// The Hilbert curve of the plane (Dimension 2) or of space (3) as a state machine that reads the coordinates
/// several levels at a time.
/// Cells whose keys are consecutive share a side; the keys of coarser levels are prefixes of the finer ones.
/// Reference  [hamilton2008] section 2: a state is the entry corner and the direction of a sub-cube
template <unsigned Dimension>
class HilbertCurve
{
public:
    /// Levels read by one look-up: the table stays within a few kilobytes.
    static constexpr unsigned kStepLevels = Dimension == 2 ? 4 : 2;
    static constexpr unsigned kStepBits = kStepLevels * Dimension;

    using Cell = std::array<std::uint32_t, Dimension>;

    /// Key of the cell, the curve being `levels` deep (a multiple of kStepLevels, Dimension * levels <= 64).
    [[nodiscard]] static std::uint64_t key(const Cell& cell, unsigned levels)
    {
        std::uint64_t result = 0;
        unsigned state = 0;
        for (unsigned shift = levels; shift != 0;) {
            shift -= kStepLevels;
            const Entry entry = kTable[state << kStepBits | packStep(cell, shift)];
            result = result << kStepBits | entry.digits;
            state = entry.next;
        }
        return result;
    }

private:
    static constexpr unsigned kCorners = 1u << Dimension;
    static constexpr unsigned kStates = kCorners * Dimension;

    struct Entry
    {
        std::uint8_t digits = 0;
        std::uint8_t next = 0;
    };
    using Table = std::array<Entry, std::size_t{kStates} << kStepBits>;

    static constexpr unsigned packStep(const Cell& cell, unsigned shift)
    {
        unsigned packed = 0;
        for (unsigned axis = 0; axis < Dimension; ++axis) {
            packed = packed << kStepLevels | (cell[axis] >> shift & ((1u << kStepLevels) - 1u));
        }
        return packed;
    }

    static constexpr unsigned rotateLeft(unsigned bits, unsigned by)
    {
        by %= Dimension;
        return (bits << by | bits >> (Dimension - by)) & (kCorners - 1u);
    }
    static constexpr unsigned grayCode(unsigned i) { return i ^ i >> 1; }
    static constexpr unsigned grayCodeInverse(unsigned code)
    {
        unsigned i = code;
        for (unsigned shift = 1; shift < Dimension; ++shift) i ^= code >> shift;
        return i;
    }
    static constexpr unsigned entryCorner(unsigned digit)
    {
        return digit == 0 ? 0 : grayCode((digit - 1) / 2 * 2);
    }
    static constexpr unsigned direction(unsigned digit)
    {
        if (digit == 0) return 0;
        const unsigned odd = digit % 2 == 0 ? digit - 1 : digit;
        return static_cast<unsigned>(std::countr_one(odd)) % Dimension;
    }

    /// One level: the corner (one bit per axis) in a state gives a digit of the key and the next state.
    static constexpr Entry stepOneLevel(unsigned state, unsigned corner)
    {
        const unsigned entry = state / Dimension;
        const unsigned axis = state % Dimension;
        const unsigned turned = rotateLeft(corner ^ entry, Dimension - (axis + 1) % Dimension);
        const unsigned digit = grayCodeInverse(turned);
        const unsigned nextEntry = entry ^ rotateLeft(entryCorner(digit), axis + 1);
        const unsigned nextAxis = (axis + direction(digit) + 1) % Dimension;
        return {static_cast<std::uint8_t>(digit),
                static_cast<std::uint8_t>(nextEntry * Dimension + nextAxis)};
    }

    static constexpr Table makeTable()
    {
        Table table{};
        for (unsigned state = 0; state < kStates; ++state) {
            for (unsigned packed = 0; packed < 1u << kStepBits; ++packed) {
                table[state << kStepBits | packed] = stepAllLevels(state, packed);
            }
        }
        return table;
    }
    static constexpr Entry stepAllLevels(unsigned state, unsigned packed)
    {
        unsigned digits = 0;
        for (unsigned level = kStepLevels; level-- > 0;) {
            unsigned corner = 0;
            for (unsigned axis = 0; axis < Dimension; ++axis) {
                corner |= (packed >> ((Dimension - 1 - axis) * kStepLevels + level) & 1u) << axis;
            }
            const Entry entry = stepOneLevel(state, corner);
            digits = digits << Dimension | entry.digits;
            state = entry.next;
        }
        return {static_cast<std::uint8_t>(digits), static_cast<std::uint8_t>(state)};
    }

    static const Table kTable;
};

template <unsigned Dimension>
inline constexpr typename HilbertCurve<Dimension>::Table
    HilbertCurve<Dimension>::kTable = HilbertCurve<Dimension>::makeTable();

}  // namespace mesher
