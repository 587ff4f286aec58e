/// A view of contiguous elements (C++17 has no std::span). Owns nothing; the elements must outlive it.
/// Indexing outside the view is a broken invariant and stops the program.
#pragma once

#include <cstddef>
#include <type_traits>

#include "render_core/base/check.hpp"

namespace tedavis::base {

template <class T>
class Span {
public:
    constexpr Span() = default;
    constexpr Span(T* data, std::size_t size) : data_(data), size_(size) {}
    template <std::size_t N>
    constexpr Span(T (&array)[N]) : data_(array), size_(N) {}
    template <class Container, class = std::enable_if_t<std::is_convertible_v<decltype(std::declval<Container&>().data()), T*>>>
    constexpr Span(Container& container) : data_(container.data()), size_(container.size()) {}

    /// Converts a view of mutable elements to one of constant elements.
    template <class U, class = std::enable_if_t<std::is_same_v<const U, T>>>
    constexpr Span(const Span<U>& other) : data_(other.data()), size_(other.size()) {}

    [[nodiscard]] constexpr T* data() const { return data_; }
    [[nodiscard]] constexpr std::size_t size() const { return size_; }
    [[nodiscard]] constexpr bool empty() const { return size_ == 0; }
    [[nodiscard]] constexpr T* begin() const { return data_; }
    [[nodiscard]] constexpr T* end() const { return data_ + size_; }
    constexpr T& operator[](std::size_t index) const {
        TEDAVIS_CHECK(index < size_);
        return data_[index];
    }
    [[nodiscard]] constexpr Span subspan(std::size_t offset, std::size_t count) const {
        TEDAVIS_CHECK(offset <= size_ && count <= size_ - offset);
        return Span(data_ + offset, count);
    }

private:
    T* data_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace tedavis::base
