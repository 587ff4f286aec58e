/// The borders of chunks as lines of the lattice: every 32nd row and column and the last ones, and at which levels their
/// posts stay. Both chunks at a line, of whatever level, take their border vertices from here.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/build_plan.hpp"
#include "host_sim/terrain_builder/posts_file.hpp"

namespace tedavis::host_sim {

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

class BorderLines {
public:
    /// Opens or makes the files `<folder>/rows` and `<folder>/columns`.
    BorderLines(const BuildPlan& plan, const std::string& folder);

    /// Pieces of lines: what one task makes. Any thread, different pieces at once.
    [[nodiscard]] std::uint32_t piece_count() const { return row_pieces() + column_pieces(); }
    void build_piece(const PostsFile& posts, std::uint32_t piece);

    /// Levels of `count` posts of a row line from column i on, and of a column line from row j on.
    [[nodiscard]] std::vector<std::uint8_t> along_row(std::uint32_t j, std::uint32_t i, std::uint32_t count) const;
    [[nodiscard]] std::vector<std::uint8_t> along_column(std::uint32_t i, std::uint32_t j, std::uint32_t count) const;
    [[nodiscard]] const LineGrid& row_lines() const { return row_lines_; }
    [[nodiscard]] const LineGrid& column_lines() const { return column_lines_; }
    void sync();

private:
    void build_rows(const PostsFile& posts, std::uint32_t piece);
    void build_columns(const PostsFile& posts, std::uint32_t piece);
    void keep_row(const LatticeWindow& window, std::uint32_t line);
    void keep_column(const std::vector<float>& surface_m, const std::vector<terrain::PostClass>& classes, std::uint32_t line,
                     std::uint32_t first);
    [[nodiscard]] double row_tolerance_m(std::uint32_t level, std::uint32_t j) const;
    [[nodiscard]] std::uint32_t row_pieces() const;
    [[nodiscard]] std::uint32_t column_pieces() const;

    const BuildPlan& plan_;
    LineGrid row_lines_, column_lines_;
    WorkFile rows_, columns_;
};

}  // namespace tedavis::host_sim
