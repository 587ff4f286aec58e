#include "host_sim/terrain_builder/chunk_border.hpp"

#include <algorithm>

namespace tedavis::host_sim {
namespace {

using namespace terrain;

/// The levels of a chunk's posts on its four sides.
struct SideLevels {
    std::vector<std::uint8_t> north, east, south, west;

    SideLevels(const LineLevels& lines, const PostRange& posts)
        : north(lines.along(LineDirection::row, posts.j0, posts.i0, posts.i1 - posts.i0 + 1)),
          east(lines.along(LineDirection::column, posts.i1, posts.j0, posts.j1 - posts.j0 + 1)),
          south(lines.along(LineDirection::row, posts.j1, posts.i0, posts.i1 - posts.i0 + 1)),
          west(lines.along(LineDirection::column, posts.i0, posts.j0, posts.j1 - posts.j0 + 1)) {}
};

class BorderMaker {
public:
    BorderMaker(const BuildPlan& plan, const LineLevels& lines, const ChunkKey& key)
        : plan_(plan), lines_(lines), level_(key.level), posts_(plan.lattice.posts_of(key)), levels_(lines, posts_) {}

    std::vector<BorderPost> run() {
        const std::uint32_t w = posts_.i1 - posts_.i0, h = posts_.j1 - posts_.j0;
        corner(posts_.i0, posts_.j0, levels_.north[0], levels_.west[0]);
        for (std::uint32_t n = 1; n < w; ++n) on_row(posts_.i0 + n, posts_.j0, levels_.north[n]);
        corner(posts_.i1, posts_.j0, levels_.north[w], levels_.east[0]);
        for (std::uint32_t n = 1; n < h; ++n) on_column(posts_.i1, posts_.j0 + n, levels_.east[n]);
        corner(posts_.i1, posts_.j1, levels_.south[w], levels_.east[h]);
        for (std::uint32_t n = w - 1; n > 0; --n) on_row(posts_.i0 + n, posts_.j1, levels_.south[n]);
        corner(posts_.i0, posts_.j1, levels_.south[0], levels_.west[h]);
        for (std::uint32_t n = h - 1; n > 0; --n) on_column(posts_.i0, posts_.j0 + n, levels_.west[n]);
        return std::move(border_);
    }

private:
    /// Where two lines cross, the post is on borders as high as the higher one's.
    void corner(std::uint32_t i, std::uint32_t j, std::uint8_t row_level, std::uint8_t column_level) {
        border_.push_back({i, j, top_of(j, std::max(row_level, column_level)), true});
    }
    void on_row(std::uint32_t i, std::uint32_t j, std::uint8_t level) {
        if (level >= level_)
            border_.push_back({i, j, top_of(j, level), stays(level, lines_.lines(LineDirection::row).top_level(j))});
    }
    void on_column(std::uint32_t i, std::uint32_t j, std::uint8_t level) {
        if (level >= level_) border_.push_back({i, j, level, stays(level, lines_.lines(LineDirection::column).top_level(i))});
    }
    /// On a line that is no border of the next level no coarser neighbour can be.
    [[nodiscard]] bool stays(std::uint8_t level, std::uint32_t line_top) const { return line_top <= level_ || level > level_; }
    /// All posts of a pole row are one point.
    [[nodiscard]] std::uint8_t top_of(std::uint32_t j, std::uint8_t level) const {
        return plan_.is_pole_row(j) ? static_cast<std::uint8_t>(plan_.levels() - 1) : level;
    }

    const BuildPlan& plan_;
    const LineLevels& lines_;
    const std::uint32_t level_;
    const PostRange posts_;
    const SideLevels levels_;
    std::vector<BorderPost> border_;
};

}  // namespace

std::vector<BorderPost> chunk_border(const BuildPlan& plan, const LineLevels& lines, const ChunkKey& key) {
    return BorderMaker(plan, lines, key).run();
}

std::uint8_t sides_of_parent(const BuildPlan& plan, const ChunkKey& key) {
    if (key.level + 1 >= plan.levels()) return 0;
    const PostRange own = plan.lattice.posts_of(key), parent = plan.lattice.posts_of(key.parent());
    const auto side = [&](EdgeBit bit, bool shared) {
        return shared && plan.lattice.neighbour(key, bit) != kNoChunk ? std::uint32_t{bit} : 0u;
    };
    return static_cast<std::uint8_t>(side(kEdgeNorth, own.j0 == parent.j0) | side(kEdgeSouth, own.j1 == parent.j1) |
                                     side(kEdgeWest, own.i0 == parent.i0) | side(kEdgeEast, own.i1 == parent.i1));
}

}  // namespace tedavis::host_sim
