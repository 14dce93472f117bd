#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace mesher {

/// Shrinks a sequence that makes something fail: pieces of it are left out, halves first, then ever smaller ones, as
/// long as `fails(sequence)` still holds of the rest.
/// Guarantees   `fails` holds of the result, and leaving out any single item of it makes `fails` false (if `fails` is a
///              function of its argument)
/// Requires     `fails(sequence)`; if it does not hold, the sequence is returned unchanged
/// Terminates   always; `fails` is asked at most quadratically often, n log n for a single culprit
/// Reference    [zeller2002] ddmin, without its first half (tests of the pieces alone)
template <class T, class Fails>
std::vector<T> reduceSequence(std::vector<T> sequence, Fails&& fails)
{
    if (!fails(std::as_const(sequence))) return sequence;
    std::size_t pieceSize = std::max<std::size_t>(1, sequence.size() / 2);
    while (!sequence.empty()) {
        bool hasShrunk = false;
        for (std::size_t begin = 0; begin < sequence.size();) {
            const std::size_t end = std::min(sequence.size(), begin + pieceSize);
            std::vector<T> rest(sequence.begin(), sequence.begin() + static_cast<std::ptrdiff_t>(begin));
            rest.insert(rest.end(), sequence.begin() + static_cast<std::ptrdiff_t>(end), sequence.end());
            if (fails(std::as_const(rest))) {
                sequence = std::move(rest);
                hasShrunk = true;
            } else {
                begin = end;
            }
        }
        if (pieceSize == 1 && !hasShrunk) break;
        if (pieceSize > 1) pieceSize /= 2;
    }
    return sequence;
}

}  // namespace mesher
