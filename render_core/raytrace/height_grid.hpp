/// Heights on a regular grid of posts, as the tracer reads them. Borrowed, never owned.
///
/// Grid space: x counts columns from the first post, y rows from the first row, z height steps; a height step is whatever one
/// unit of a stored height means. A cell (column, row) lies between four posts; there are (columns - 1) x (rows - 1). Where a
/// post has no height, the cells round it have no surface, and rays pass.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace tedavis::raytrace {

/// `Height` is std::int16_t or float.
template <class Height>
struct HeightGrid {
    /// The height of a post without one. NaN is none: it must be turned into this before.
    static constexpr Height kVoid = std::numeric_limits<Height>::lowest();
    static constexpr std::uint32_t kMaxPosts = 65537;          ///< each way
    static constexpr std::uint64_t kMaxInAll = 1'600'000'000;  ///< their number and a third more is one of 31 bits

    const Height* posts = nullptr;  ///< row by row
    std::uint32_t columns = 0;      ///< 2..kMaxPosts
    std::uint32_t rows = 0;         ///< 2..kMaxPosts
    std::uint32_t stride = 0;       ///< posts from one row to the next, `columns` or more

    [[nodiscard]] const Height* row(std::uint32_t n) const { return posts + std::size_t{n} * stride; }
    [[nodiscard]] Height at(std::uint32_t column, std::uint32_t line) const { return row(line)[column]; }
    [[nodiscard]] bool is_valid() const {
        return posts != nullptr && columns >= 2 && rows >= 2 && columns <= kMaxPosts && rows <= kMaxPosts && stride >= columns &&
               std::uint64_t{stride} * rows <= kMaxInAll;
    }
};

/// Posts [first, end) each way.
struct PostRegion {
    std::uint32_t first_column = 0, first_row = 0, end_column = 0, end_row = 0;
};

}  // namespace tedavis::raytrace
