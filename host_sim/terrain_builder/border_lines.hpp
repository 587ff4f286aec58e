/// The borders of chunks as lines of the lattice (every 32nd row and column and the last ones), with the levels up to which each
/// of their posts is a vertex. Chunks of all levels on both sides of a line take their border vertices from here.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/build_plan.hpp"
#include "host_sim/terrain_builder/posts_file.hpp"

namespace tedavis::host_sim {

class BorderLines final : public LineLevels {
public:
    /// Opens or makes the files `<folder>/rows` and `<folder>/columns`.
    BorderLines(const BuildPlan& plan, const std::string& folder);

    /// Number of pieces of lines, one per task. Different pieces may be built at once, on any thread.
    [[nodiscard]] std::uint32_t piece_count() const { return row_pieces() + column_pieces(); }
    void build_piece(const PostsFile& posts, std::uint32_t piece);

    [[nodiscard]] std::vector<std::uint8_t> along(LineDirection way, std::uint32_t line, std::uint32_t first,
                                                  std::uint32_t count) const override;
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
    WorkFile rows_, columns_;
};

}  // namespace tedavis::host_sim
