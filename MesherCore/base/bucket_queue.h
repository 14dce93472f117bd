#pragma once

#include "base/assert.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace mesher {

/// A queue of things to repair, the worst (largest key) first up to the width of a bucket.
/// Guarantees   an entry leaves before every entry whose key is below 8/9 of its own (for keys in
///              [2^-64, 2^64); all smaller keys share the lowest bucket, all larger ones the highest), and
///              entries of one bucket leave in the order in which they came: the order depends on nothing
///              but the calls.
/// Requires     keys that are not negative and not NaN.
/// Deletion is lazy: an entry carries the generation its element had, and the taker drops those that are stale.
/// A 16-bit generation can wrap, so the taker also compares the key with the element's present one.
/// Cost         constant per entry.
template <class IdType>
class BucketQueue
{
public:
    struct Entry
    {
        IdType id;
        std::uint16_t generation = 0;
        double key = 0.0;
    };

    void push(IdType id, std::uint16_t generation, double key)
    {
        const std::size_t index = bucketOf(key);
        buckets_[index].entries.push_back({id, generation, key});
        occupied_[index / 64] |= std::uint64_t{1} << (index % 64);
        ++size_;
    }

    /// The worst entry, stale or not.
    [[nodiscard]] std::optional<Entry> pop()
    {
        if (size_ == 0) return std::nullopt;
        const std::size_t index = worstBucket();
        Bucket& bucket = buckets_[index];
        const Entry entry = bucket.entries[bucket.head++];
        if (bucket.head == bucket.entries.size()) {
            bucket.entries.clear();
            bucket.head = 0;
            occupied_[index / 64] &= ~(std::uint64_t{1} << (index % 64));
        } else if (bucket.head >= kCompactionThreshold && 2 * bucket.head >= bucket.entries.size()) {
            bucket.dropTaken();
        }
        --size_;
        return entry;
    }

    /// The worst entry for which `isCurrent(entry)` holds; those before it are dropped.
    template <class IsCurrent>
    [[nodiscard]] std::optional<Entry> popCurrent(IsCurrent&& isCurrent)
    {
        while (std::optional<Entry> entry = pop()) {
            if (isCurrent(*entry)) return entry;
        }
        return std::nullopt;
    }

    /// Entries including stale ones.
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }

    void clear()
    {
        for (Bucket& bucket : buckets_) bucket = {};
        occupied_ = {};
        size_ = 0;
    }

private:
    static constexpr int kMantissaBits = 3;      // eight buckets per octave
    static constexpr int kLowestExponent = -64;  // of the keys told apart
    static constexpr int kOctaves = 128;
    static constexpr std::size_t kBucketCount = static_cast<std::size_t>(kOctaves) << kMantissaBits;
    static constexpr std::size_t kCompactionThreshold = 1024;

    struct Bucket
    {
        std::vector<Entry> entries;
        std::size_t head = 0;  // entries before it have been taken

        void dropTaken()
        {
            entries.erase(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(head));
            head = 0;
        }
    };

    /// Exponent and leading mantissa bits of a double grow with its value: a piecewise linear logarithm.
    [[nodiscard]] static std::size_t bucketOf(double key)
    {
        MESHER_PRECONDITION(key >= 0.0);
        constexpr std::int64_t lowest = std::int64_t{1023 + kLowestExponent} << kMantissaBits;
        const auto bits =
            static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(key + 0.0) >> (52 - kMantissaBits));
        return static_cast<std::size_t>(
            std::clamp<std::int64_t>(bits - lowest, 0, static_cast<std::int64_t>(kBucketCount) - 1));
    }

    [[nodiscard]] std::size_t worstBucket() const
    {
        std::size_t word = occupied_.size() - 1;
        while (occupied_[word] == 0) --word;
        return 64 * word + 63 - static_cast<std::size_t>(std::countl_zero(occupied_[word]));
    }

    std::vector<Bucket> buckets_ = std::vector<Bucket>(kBucketCount);
    std::array<std::uint64_t, kBucketCount / 64> occupied_{};  // one bit per bucket
    std::size_t size_ = 0;
};

}  // namespace mesher
