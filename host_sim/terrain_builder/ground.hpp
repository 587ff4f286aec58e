/// What chunks are made from, as faces: a whole terrain has them from its raster, an inset from its own and the terrain's.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/terrain_builder/lattice_window.hpp"
#include "render_core/terrain/lattice.hpp"

namespace tedavis::host_sim {

class PostWindows {
public:
    virtual ~PostWindows() = default;
    /// Heights and classes of the rectangle that the window names; its surface is left as it is. Outside: height 0.
    /// Any thread. Throws UserError.
    virtual void read(LatticeWindow& window) const = 0;
};

/// Lines one way: line n lies at post 32 n, the last one at the last post.
struct LineGrid {
    std::uint32_t posts = 0;  ///< across the lines
    std::uint32_t top = 0;    ///< the highest level of the database

    [[nodiscard]] std::uint32_t count() const { return (posts - 1 + terrain::kChunkCells - 1) / terrain::kChunkCells + 1; }
    [[nodiscard]] std::uint32_t post_of(std::uint32_t line) const;
    [[nodiscard]] bool is_line(std::uint32_t post) const { return post % terrain::kChunkCells == 0 || post == posts - 1; }
    [[nodiscard]] std::uint32_t line_at(std::uint32_t post) const {
        return (post + terrain::kChunkCells - 1) / terrain::kChunkCells;
    }
    /// The highest level whose chunks have a border there.
    [[nodiscard]] std::uint32_t top_level(std::uint32_t post) const;
};

enum class LineDirection : std::uint8_t { row, column };

/// At which levels the posts of border lines stay.
class LineLevels {
public:
    LineLevels(const LineGrid& row_lines, const LineGrid& column_lines) : row_lines_(row_lines), column_lines_(column_lines) {}
    virtual ~LineLevels() = default;

    /// Levels of `count` posts of the row or column `line`, from its post `first` on. Any thread.
    [[nodiscard]] virtual std::vector<std::uint8_t> along(LineDirection way, std::uint32_t line, std::uint32_t first,
                                                          std::uint32_t count) const = 0;
    [[nodiscard]] const LineGrid& lines(LineDirection way) const {
        return way == LineDirection::row ? row_lines_ : column_lines_;
    }

protected:
    LineGrid row_lines_, column_lines_;
};

class Steepness {
public:
    virtual ~Steepness() = default;
    /// Metres a metre, over a rectangle of posts and `margin_posts` round it: no less than any slope of the true surface.
    [[nodiscard]] virtual double steepest(const terrain::PostRange& posts, std::uint32_t margin_posts) const = 0;
};

}  // namespace tedavis::host_sim
