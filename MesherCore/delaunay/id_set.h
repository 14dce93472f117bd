#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mesher {

/// A set of indices that is only ever asked for membership: linear for the few dozen of an ordinary star, hashed
/// beyond, since a hub vertex can have as many tetrahedra as the mesh.
class IdSet
{
public:
    /// Whether the index was new.
    bool insert(std::uint32_t index)
    {
        if (table_.empty()) {
            if (std::find(few_.begin(), few_.end(), index) != few_.end()) return false;
            few_.push_back(index);
            if (few_.size() > kFew) rehash(8 * kFew);
            return true;
        }
        if (!insertHashed(index)) return false;
        if (++count_ * 2 > table_.size()) rehash(table_.size() * 2);
        return true;
    }

    [[nodiscard]] bool contains(std::uint32_t index) const
    {
        if (table_.empty()) return std::find(few_.begin(), few_.end(), index) != few_.end();
        return table_[slotFor(index)] == index;
    }

private:
    static constexpr std::size_t kFew = 32;
    static constexpr std::uint32_t kEmpty = 0xFFFFFFFFu;

    [[nodiscard]] std::size_t slotFor(std::uint32_t index) const
    {
        const std::size_t mask = table_.size() - 1;
        std::size_t slot = (index * 0x9E3779B97F4A7C15u >> 20) & mask;
        while (table_[slot] != kEmpty && table_[slot] != index) slot = (slot + 1) & mask;
        return slot;
    }
    bool insertHashed(std::uint32_t index)
    {
        const std::size_t slot = slotFor(index);
        if (table_[slot] == index) return false;
        table_[slot] = index;
        return true;
    }
    void rehash(std::size_t size)
    {
        std::vector<std::uint32_t> items = table_.empty() ? few_ : table_;
        table_.assign(size, kEmpty);
        count_ = 0;
        for (const std::uint32_t item : items) count_ += item != kEmpty && insertHashed(item) ? 1u : 0u;
    }

    std::vector<std::uint32_t> few_;
    std::vector<std::uint32_t> table_;
    std::size_t count_ = 0;
};

}  // namespace mesher
