#pragma once

#include "base/assert.h"
#include "base/large_page_allocator.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace mesher {

/// A vector indexed by one kind of id only.
template <class IdType, class T>
class IdVector
{
public:
    IdVector() = default;
    explicit IdVector(std::size_t size, const T& value = T{}) : items_(size, value) {}

    [[nodiscard]] T& operator[](IdType id)
    {
        MESHER_PRECONDITION(id.value < items_.size());
        return items_[id.value];
    }
    [[nodiscard]] const T& operator[](IdType id) const
    {
        MESHER_PRECONDITION(id.value < items_.size());
        return items_[id.value];
    }

    IdType push_back(const T& item)
    {
        items_.push_back(item);
        return lastId();
    }
    IdType push_back(T&& item)
    {
        items_.push_back(std::move(item));
        return lastId();
    }

    [[nodiscard]] std::size_t size() const { return items_.size(); }
    [[nodiscard]] bool empty() const { return items_.empty(); }
    [[nodiscard]] std::size_t capacity() const { return items_.capacity(); }
    void resize(std::size_t size, const T& value = T{}) { items_.resize(size, value); }
    void reserve(std::size_t size) { items_.reserve(size); }
    void clear() { items_.clear(); }

    [[nodiscard]] T* data() { return items_.data(); }
    [[nodiscard]] const T* data() const { return items_.data(); }
    auto begin() { return items_.begin(); }
    auto end() { return items_.end(); }
    auto begin() const { return items_.begin(); }
    auto end() const { return items_.end(); }

private:
    [[nodiscard]] IdType lastId() const { return IdType(static_cast<std::uint32_t>(items_.size() - 1)); }

    std::vector<T, LargePageAllocator<T>> items_;
};

}  // namespace mesher
