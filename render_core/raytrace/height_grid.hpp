/// A regular grid of heights, as the tracer reads it. The memory is borrowed.
///
/// Grid space: x counts columns from the first post, y rows from the first row, z height steps; a height step is one unit of a
/// stored height. A cell (column, row) lies between four posts; there are (columns - 1) x (rows - 1) cells. Where a post has no
/// height, the cells round it have no surface, and rays pass through.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace tedavis::raytrace {

/// `Height` is std::int16_t or float.
template <class Height>
struct HeightGrid {
    /// The value of a post without a height. NaN is not allowed: convert it to this.
    static constexpr Height kVoid = std::numeric_limits<Height>::lowest();
    static constexpr std::uint32_t kMaxPosts = 65537;          ///< each way
    static constexpr std::uint64_t kMaxInAll = 1'600'000'000;  ///< posts in all; 4/3 of it fits 31 bits

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

/// A region of posts, [first, end) in both directions.
struct PostRegion {
    std::uint32_t first_column = 0, first_row = 0, end_column = 0, end_row = 0;
};

}  // namespace tedavis::raytrace
