/// The borders of chunks in a region of insets: every 32nd row and column of its posts.
///
/// At the base level and above, borders are those of the coarse posts, also inside the region. At finer levels they approximate
/// the fine surface; beside an exact chunk of level m they have exactly every 2^m-th post, as the chunk has.
#pragma once

#include <string>

#include "host_sim/terrain_builder/border_lines.hpp"
#include "host_sim/terrain_builder/inset_coverage.hpp"
#include "host_sim/terrain_builder/inset_posts.hpp"
#include "host_sim/terrain_builder/nested_polyline.hpp"

namespace tedavis::host_sim {

class InsetLines final : public LineLevels {
public:
    /// `plan` is of the fine posts. Opens or makes the files `<path>.rows` and `<path>.columns`.
    InsetLines(const BuildPlan& plan, const InsetCoverage& coverage, const BorderLines& coarse, const InsetPosts& posts,
               const std::string& path);

    /// Makes all lines within a block, a chunk of the base level, its sides included. Different blocks may be built at once, on
    /// any thread.
    void build(const terrain::ChunkKey& block);
    void sync();

    /// For lines within the region.
    [[nodiscard]] std::vector<std::uint8_t> along(LineDirection way, std::uint32_t line, std::uint32_t first,
                                                  std::uint32_t count) const override;

private:
    /// A line's posts within a block.
    struct Piece {
        LineDirection way;
        std::uint32_t line, first, last;  ///< post of the line across, and its first and last post along
    };
    void build_piece(const LatticeWindow& window, const Piece& piece);
    [[nodiscard]] std::vector<std::uint8_t> coarse_levels(const Piece& piece) const;
    void stand_beside_exact(const Piece& piece, std::vector<std::uint8_t>& kept, std::vector<std::uint8_t>& most) const;
    [[nodiscard]] bool is_beside_exact(const Piece& piece, std::uint32_t level, std::uint32_t first) const;
    [[nodiscard]] LinePiece line_of(const Piece& piece) const;
    /// The offset of a line's post in its file.
    [[nodiscard]] std::uint64_t place_of(LineDirection way, std::uint32_t line, std::uint32_t post) const;

    const BuildPlan& plan_;
    const InsetCoverage& coverage_;
    const BorderLines& coarse_;
    const InsetPosts& posts_;
    WorkFile rows_, columns_;
};

}  // namespace tedavis::host_sim
