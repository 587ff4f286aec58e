/// Interfaces through which the terrain builder reads the ground: heights of posts, levels of the posts on chunk borders, and
/// slopes. A whole terrain implements them by its source raster; an inset (a finer area within a built terrain) by its own raster
/// and by those of the terrain round it.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/terrain_builder/lattice_window.hpp"
#include "render_core/terrain/lattice.hpp"

namespace tedavis::host_sim {

class PostWindows {
public:
    virtual ~PostWindows() = default;
    /// Fills in the heights and classes of the posts of the window's rectangle, with height 0 for posts outside of the lattice.
    /// Heights above the ellipsoid (surface_m) are left as they are. Any thread. Throws UserError.
    virtual void read(LatticeWindow& window) const = 0;
};

/// The lines of posts on which chunks have their borders, in one direction: line n lies at post 32 n, and the last line at the
/// last post.
struct LineGrid {
    std::uint32_t posts = 0;  ///< across the lines
    std::uint32_t top = 0;    ///< the highest level of the database

    [[nodiscard]] std::uint32_t count() const { return (posts - 1 + terrain::kChunkCells - 1) / terrain::kChunkCells + 1; }
    [[nodiscard]] std::uint32_t post_of(std::uint32_t line) const;
    [[nodiscard]] bool is_line(std::uint32_t post) const { return post % terrain::kChunkCells == 0 || post == posts - 1; }
    [[nodiscard]] std::uint32_t line_at(std::uint32_t post) const {
        return (post + terrain::kChunkCells - 1) / terrain::kChunkCells;
    }
    /// Returns the highest level whose chunks have a border at the post.
    [[nodiscard]] std::uint32_t top_level(std::uint32_t post) const;
};

enum class LineDirection : std::uint8_t { row, column };

/// The levels of detail at which meshes keep a post of a border line: both chunks at a border have the same posts there.
class LineLevels {
public:
    LineLevels(const LineGrid& row_lines, const LineGrid& column_lines) : row_lines_(row_lines), column_lines_(column_lines) {}
    virtual ~LineLevels() = default;

    /// Returns, for `count` posts of the row or column `line` from its post `first` on, the highest level that keeps the post.
    /// Any thread.
    [[nodiscard]] virtual std::vector<std::uint8_t> along(LineDirection way, std::uint32_t line, std::uint32_t first,
                                                          std::uint32_t count) const = 0;
    [[nodiscard]] const LineGrid& lines(LineDirection way) const {
        return way == LineDirection::row ? row_lines_ : column_lines_;
    }

protected:
    LineGrid row_lines_, column_lines_;
};

/// An upper bound of the ground's slope.
class Steepness {
public:
    virtual ~Steepness() = default;
    /// Returns a slope, metres of height per metre, that the true surface exceeds nowhere in a rectangle of posts and in
    /// `margin_posts` round it.
    [[nodiscard]] virtual double steepest(const terrain::PostRange& posts, std::uint32_t margin_posts) const = 0;
};

}  // namespace tedavis::host_sim
