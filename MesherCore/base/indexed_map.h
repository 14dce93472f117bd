#pragma once

#include "base/assert.h"
#include "base/ids.h"

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace mesher {

/// How a key of an IndexedMap becomes 64 bits; the map scrambles them itself. Specialise it for further keys;
/// equal keys must give equal bits.
template <class Key>
struct MapKey;

template <std::integral Key>
struct MapKey<Key>
{
    static constexpr std::uint64_t bits(Key key) { return static_cast<std::uint64_t>(key); }
};

template <class Tag>
struct MapKey<Id<Tag>>
{
    static constexpr std::uint64_t bits(Id<Tag> id) { return id.value; }
};

template <class First, class Second>
struct MapKey<std::pair<First, Second>>
{
    static constexpr std::uint64_t bits(const std::pair<First, Second>& key)
    {
        return MapKey<First>::bits(key.first) * 0x9E3779B97F4A7C15u + MapKey<Second>::bits(key.second);
    }
};

template <class Part, std::size_t Count>
struct MapKey<std::array<Part, Count>>
{
    static constexpr std::uint64_t bits(const std::array<Part, Count>& key)
    {
        std::uint64_t sum = 0;
        for (const Part& part : key) sum = sum * 0x9E3779B97F4A7C15u + MapKey<Part>::bits(part);
        return sum;
    }
};

/// The key of something that has two ends and no direction.
template <class T>
[[nodiscard]] constexpr std::pair<T, T> unorderedPair(T a, T b)
{
    return b < a ? std::pair<T, T>(b, a) : std::pair<T, T>(a, b);
}

/// A hash map that is walked in the order of insertion, on every platform the same. Erasing keeps the order of
/// the others; a key that is erased and inserted again goes to the end.
/// Cost   constant per operation, expected; open addressing with linear probing over 32-bit positions.
/// Limit  fewer than 2^31 entries. Pointers and iterators hold until the next insertion or `clear`.
template <class Key, class Value>
class IndexedMap
{
    struct Slot
    {
        Key key;
        Value value;
        bool isLive;
    };

    template <class SlotPointer, class ValueReference>
    class Walk
    {
    public:
        struct Item
        {
            const Key& key;
            ValueReference value;
        };

        Walk(SlotPointer at, SlotPointer end) : at_(at), end_(end) { skipErased(); }
        Item operator*() const { return {at_->key, at_->value}; }
        Walk& operator++()
        {
            ++at_;
            skipErased();
            return *this;
        }
        bool operator==(const Walk& other) const { return at_ == other.at_; }

    private:
        void skipErased()
        {
            while (at_ != end_ && !at_->isLive) ++at_;
        }

        SlotPointer at_;
        SlotPointer end_;
    };

public:
    [[nodiscard]] std::size_t size() const { return liveCount_; }
    [[nodiscard]] bool empty() const { return liveCount_ == 0; }
    [[nodiscard]] bool contains(const Key& key) const { return find(key) != nullptr; }

    /// The value of the key, or null.
    [[nodiscard]] Value* find(const Key& key) { return const_cast<Value*>(std::as_const(*this).find(key)); }
    [[nodiscard]] const Value* find(const Key& key) const
    {
        if (table_.empty()) return nullptr;
        const std::uint32_t position = table_[findCell(key)];
        return position == kEmpty ? nullptr : &slots_[position].value;
    }

    /// Adds the key with this value unless it is there; the value that is there now, and whether it was added.
    std::pair<Value*, bool> insert(Key key, Value value)
    {
        if (4 * (slots_.size() + 1) > 3 * table_.size()) rebuild();
        const std::size_t cell = findCell(key);
        if (table_[cell] != kEmpty) return {&slots_[table_[cell]].value, false};
        table_[cell] = static_cast<std::uint32_t>(slots_.size());
        slots_.push_back({std::move(key), std::move(value), true});
        ++liveCount_;
        return {&slots_.back().value, true};
    }
    void insertOrAssign(const Key& key, Value value)
    {
        if (Value* present = find(key)) {
            *present = std::move(value);
        } else {
            insert(key, std::move(value));
        }
    }
    /// The value of the key, made first if need be.
    Value& operator[](const Key& key) { return *insert(key, Value{}).first; }

    /// Whether there was such a key.
    bool erase(const Key& key)
    {
        if (table_.empty()) return false;
        const std::size_t cell = findCell(key);
        if (table_[cell] == kEmpty) return false;
        Slot& slot = slots_[table_[cell]];
        slot.isLive = false;
        slot.value = Value{};
        --liveCount_;
        closeGap(cell);
        return true;
    }

    void clear()
    {
        slots_.clear();
        table_.clear();
        liveCount_ = 0;
    }
    void reserve(std::size_t count)
    {
        slots_.reserve(count);
        if (4 * count > 3 * table_.size()) rebuildFor(count);
    }

    auto begin() { return Walk<Slot*, Value&>(slots_.data(), slots_.data() + slots_.size()); }
    auto end() { return Walk<Slot*, Value&>(slots_.data() + slots_.size(), slots_.data() + slots_.size()); }
    auto begin() const
    {
        return Walk<const Slot*, const Value&>(slots_.data(), slots_.data() + slots_.size());
    }
    auto end() const
    {
        return Walk<const Slot*, const Value&>(slots_.data() + slots_.size(), slots_.data() + slots_.size());
    }

private:
    static constexpr std::uint32_t kEmpty = 0xFFFFFFFFu;

    [[nodiscard]] std::size_t homeCell(const Key& key) const
    {
        std::uint64_t bits = MapKey<Key>::bits(key) * 0x9E3779B97F4A7C15u;
        bits = (bits ^ (bits >> 32)) * 0xD6E8FEB86659FD93u;
        return static_cast<std::size_t>(bits ^ (bits >> 32)) & (table_.size() - 1);
    }

    /// The cell that holds the key, else the empty cell where it belongs.
    [[nodiscard]] std::size_t findCell(const Key& key) const
    {
        std::size_t cell = homeCell(key);
        while (table_[cell] != kEmpty && !(slots_[table_[cell]].key == key)) {
            cell = (cell + 1) & (table_.size() - 1);
        }
        return cell;
    }

    /// Moves later entries of the same probe run back, so that no cell needs a mark "was used once".
    void closeGap(std::size_t gap)
    {
        const std::size_t mask = table_.size() - 1;
        for (std::size_t cell = (gap + 1) & mask; table_[cell] != kEmpty; cell = (cell + 1) & mask) {
            const std::size_t home = homeCell(slots_[table_[cell]].key);
            if (((cell - home) & mask) >= ((cell - gap) & mask)) {
                table_[gap] = table_[cell];
                gap = cell;
            }
        }
        table_[gap] = kEmpty;
    }

    void rebuild() { rebuildFor(2 * (liveCount_ + 4)); }

    /// Drops erased slots, keeping the order, and makes the table large enough for `count` entries.
    void rebuildFor(std::size_t count)
    {
        std::erase_if(slots_, [](const Slot& slot) { return !slot.isLive; });
        std::size_t cellCount = 16;
        while (3 * cellCount < 4 * count) cellCount *= 2;
        MESHER_PRECONDITION(cellCount <= (std::size_t{1} << 32));
        table_.assign(cellCount, kEmpty);
        for (std::size_t position = 0; position < slots_.size(); ++position) {
            table_[findCell(slots_[position].key)] = static_cast<std::uint32_t>(position);
        }
    }

    std::vector<Slot> slots_;           // in order of insertion; erased ones stay until the next rebuild
    std::vector<std::uint32_t> table_;  // power of two in size; position in slots_, or kEmpty
    std::size_t liveCount_ = 0;
};

}  // namespace mesher
