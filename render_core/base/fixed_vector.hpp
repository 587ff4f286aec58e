/// A vector whose capacity is part of its type and whose elements lie inside it.
///
/// Elements are added by try_push_back() only, which refuses when full and counts the refusal. T must be trivially copyable.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "render_core/base/check.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::base {

template <class T, std::size_t N>
class FixedVector {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    [[nodiscard]] bool try_push_back(const T& value) {
        if (size_ == N) {
            ++refused_;
            return false;
        }
        items_[size_++] = value;
        return true;
    }
    void pop_back() {
        TEDAVIS_CHECK(size_ > 0);
        --size_;
    }
    /// Keeps the first `count` elements.
    void truncate(std::size_t count) {
        TEDAVIS_CHECK(count <= size_);
        size_ = count;
    }
    void clear() { size_ = 0; }

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] bool full() const { return size_ == N; }
    [[nodiscard]] std::uint64_t refused() const { return refused_; }
    [[nodiscard]] static constexpr std::size_t capacity() { return N; }

    [[nodiscard]] T* data() { return items_; }
    [[nodiscard]] const T* data() const { return items_; }
    [[nodiscard]] T* begin() { return items_; }
    [[nodiscard]] T* end() { return items_ + size_; }
    [[nodiscard]] const T* begin() const { return items_; }
    [[nodiscard]] const T* end() const { return items_ + size_; }
    T& operator[](std::size_t index) {
        TEDAVIS_CHECK(index < size_);
        return items_[index];
    }
    const T& operator[](std::size_t index) const {
        TEDAVIS_CHECK(index < size_);
        return items_[index];
    }
    T& back() { return (*this)[size_ - 1]; }
    const T& back() const { return (*this)[size_ - 1]; }

private:
    T items_[N]{};
    std::size_t size_ = 0;
    std::uint64_t refused_ = 0;
};

}  // namespace tedavis::base
