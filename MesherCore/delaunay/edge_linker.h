#pragma once

#include "base/large_page_allocator.h"
#include "delaunay/ghost_vertex.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mesher {

/// Finds for each directed edge of a closed oriented triangulated surface the facet on its other side, by a table of
/// locally numbered vertices: the surface of a cavity has a dozen vertices, so the table stays in the nearest cache.
/// `Value` is whatever stands for a facet; one linker may be used for any number of surfaces, one after the other.
///
/// Requires     each directed edge occurs once, and its reverse once (a closed 2-manifold)
/// Cost         linear in the facets; memory 4 bytes a vertex of the triangulation
template <class Value>
class EdgeLinker
{
public:
    /// Starts a new surface; `vertexLimit` is one past the largest vertex id.
    void begin(std::uint32_t vertexLimit)
    {
        if (localOf_.size() <= vertexLimit) {
            localOf_.reserve(vertexLimit + vertexLimit / 4 + 16);
            localOf_.resize(localOf_.capacity());
        }
        vertices_.clear();
    }

    /// Local number of a vertex of the surface, the ghost included.
    std::uint32_t number(VertexId vertex)
    {
        // A sparse set: what an earlier surface left in localOf_ is told by the check of the back reference.
        std::uint32_t& local = localOf_[vertex.value + 1u];
        if (local < vertices_.size() && vertices_[local] == vertex) return local;
        local = static_cast<std::uint32_t>(vertices_.size());
        vertices_.push_back(vertex);
        return local;
    }

    /// Call once when all vertices are numbered, before the first `put`.
    void prepare()
    {
        const std::size_t count = vertices_.size();
        isHashed_ = count > kTableLimit;
        if (isHashed_) {
            // A closed surface of n vertices has 6n - 12 directed edges or fewer.
            hashed_.assign(std::bit_ceil(count * 12), Entry{kNoKey, Value{}});
            return;
        }
        stride_ = count <= 64 ? 64 : std::bit_ceil(count);
        if (table_.size() < stride_ * stride_) table_.resize(stride_ * stride_);
    }
    void put(std::uint32_t from, std::uint32_t to, Value value)
    {
        if (isHashed_) [[unlikely]] {
            hashed_[slotFor(from, to)] = {key(from, to), value};
        } else {
            table_[from * stride_ + to] = value;
        }
    }
    /// What was put for the directed edge.
    [[nodiscard]] Value get(std::uint32_t from, std::uint32_t to) const
    {
        if (isHashed_) [[unlikely]]
            return hashed_[slotFor(from, to)].value;
        return table_[from * stride_ + to];
    }

    /// The numbered vertices of the surface, in the order of their numbers.
    [[nodiscard]] std::span<const VertexId> vertices() const { return vertices_; }

    [[nodiscard]] std::size_t bytes() const
    {
        return localOf_.capacity() * sizeof(std::uint32_t) + vertices_.capacity() * sizeof(VertexId) +
               table_.capacity() * sizeof(Value) + hashed_.capacity() * sizeof(Entry);
    }

private:
    struct Entry
    {
        std::uint64_t key;
        Value value;
    };

    static constexpr std::size_t kTableLimit = 1024;
    static constexpr std::uint64_t kNoKey = ~std::uint64_t{0};

    static std::uint64_t key(std::uint32_t from, std::uint32_t to)
    {
        return (std::uint64_t{from} << 32) | to;
    }
    [[nodiscard]] std::size_t slotFor(std::uint32_t from, std::uint32_t to) const
    {
        const std::size_t mask = hashed_.size() - 1;
        const std::uint64_t wanted = key(from, to);
        std::size_t slot = static_cast<std::size_t>((wanted * 0x9E3779B97F4A7C15u) >> 20) & mask;
        while (hashed_[slot].key != kNoKey && hashed_[slot].key != wanted) slot = (slot + 1) & mask;
        return slot;
    }

    std::vector<std::uint32_t, LargePageAllocator<std::uint32_t>>
        localOf_;  ///< by vertex id + 1, so that the ghost (all bits set) is entry 0
    std::vector<VertexId> vertices_;
    std::vector<Value> table_;
    std::vector<Entry> hashed_;
    std::size_t stride_ = 64;
    bool isHashed_ = false;
};

}  // namespace mesher
