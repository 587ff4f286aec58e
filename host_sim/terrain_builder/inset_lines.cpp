#include "host_sim/terrain_builder/inset_lines.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/terrain_builder/surface_heights.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

constexpr std::uint8_t kAnyLevel = 255;

}  // namespace

InsetLines::InsetLines(const BuildPlan& plan, const InsetCoverage& coverage, const BorderLines& coarse, const InsetPosts& posts,
                       const std::string& path)
    : LineLevels({plan.header.rows, plan.levels() - 1}, {plan.header.columns, plan.levels() - 1}),
      plan_(plan),
      coverage_(coverage),
      coarse_(coarse),
      posts_(posts),
      rows_(path + ".rows"),
      columns_(path + ".columns") {}

void InsetLines::build(const ChunkKey& block) {
    const PostRange range = plan_.lattice.posts_of(block);
    LatticeWindow window;
    window.i0 = range.i0;
    window.j0 = range.j0;
    window.columns = range.i1 - range.i0 + 1;
    window.rows = range.j1 - range.j0 + 1;
    posts_.read(window);
    add_undulation(plan_, window);
    for (std::uint32_t j = range.j0; j <= range.j1; j = j == range.j1 ? j + 1 : std::min(j + kChunkCells, range.j1))
        build_piece(window, {LineDirection::row, j, range.i0, range.i1});
    for (std::uint32_t i = range.i0; i <= range.i1; i = i == range.i1 ? i + 1 : std::min(i + kChunkCells, range.i1))
        build_piece(window, {LineDirection::column, i, range.j0, range.j1});
}

void InsetLines::build_piece(const LatticeWindow& window, const Piece& piece) {
    std::vector<float> surface_m;
    std::vector<PostClass> classes;
    for (std::uint32_t n = piece.first; n <= piece.last; ++n) {
        const std::size_t at = piece.way == LineDirection::row ? window.at(n, piece.line) : window.at(piece.line, n);
        surface_m.push_back(window.surface_m[at]);
        classes.push_back(window.post_class[at]);
    }
    std::vector<std::uint8_t> kept = coarse_levels(piece), most(surface_m.size(), kAnyLevel);
    stand_beside_exact(piece, kept, most);
    LinePiece line = line_of(piece);
    line.surface_m = {surface_m.data(), surface_m.size()};
    line.post_class = {classes.data(), classes.size()};
    line.kept = {kept.data(), kept.size()};
    line.most = {most.data(), most.size()};
    const std::vector<std::uint8_t> levels = keep_levels(line);
    (piece.way == LineDirection::row ? rows_ : columns_)
        .write(place_of(piece.way, piece.line, piece.first), levels.data(), levels.size());
}

/// On lines that the coarse posts have, their levels; 0 elsewhere.
std::vector<std::uint8_t> InsetLines::coarse_levels(const Piece& piece) const {
    std::vector<std::uint8_t> kept(piece.last - piece.first + 1, 0);
    const std::uint32_t shift = coverage_.base_level(), side = 1u << shift;
    if (piece.line % side != 0 || !coarse_.lines(piece.way).is_line(piece.line >> shift)) return kept;
    const std::uint32_t count = (piece.last - piece.first) / side + 1;
    const std::vector<std::uint8_t> coarse = coarse_.along(piece.way, piece.line >> shift, piece.first >> shift, count);
    for (std::uint32_t n = 0; n < count; ++n) kept[n * side] = static_cast<std::uint8_t>(coarse[n] + shift);
    return kept;
}

void InsetLines::stand_beside_exact(const Piece& piece, std::vector<std::uint8_t>& kept, std::vector<std::uint8_t>& most) const {
    const std::uint32_t top = std::min(lines(piece.way).top_level(piece.line), coverage_.base_level() - 1);
    for (std::uint32_t level = 1; level <= top; ++level)
        for (std::uint32_t first = piece.first; first < piece.last; first += kChunkCells << level) {
            if (!is_beside_exact(piece, level, first)) continue;
            for (std::uint32_t n = first; n <= std::min(first + (kChunkCells << level), piece.last); ++n) {
                const bool has = n % (1u << level) == 0;
                std::uint8_t& value = has ? kept[n - piece.first] : most[n - piece.first];
                value = has ? std::max(value, static_cast<std::uint8_t>(level))
                            : std::min(value, static_cast<std::uint8_t>(level - 1));
            }
        }
}

/// Of a level's chunks on both sides of a line.
bool InsetLines::is_beside_exact(const Piece& piece, std::uint32_t level, std::uint32_t first) const {
    const std::uint32_t cells = kChunkCells << level, along = first / cells, across = piece.line / cells;
    for (const std::uint32_t back : {0u, 1u}) {
        if (back > across) continue;
        const ChunkKey key =
            piece.way == LineDirection::row ? ChunkKey{level, along, across - back} : ChunkKey{level, across - back, along};
        if (plan_.lattice.contains(key) && coverage_.is_exact(key)) return true;
    }
    return false;
}

LinePiece InsetLines::line_of(const Piece& piece) const {
    LinePiece line;
    const bool is_row = piece.way == LineDirection::row;
    line.first = piece.first;
    line.top_level = std::min(lines(piece.way).top_level(piece.line), coverage_.base_level() - 1);
    const std::uint32_t row = piece.line;
    line.tolerance_m = [this, is_row, row](std::uint32_t level, std::uint32_t post) {
        const std::uint32_t last = plan_.lattice.grid_rows(level) - 1;
        return plan_.tolerance_m(level, std::min((is_row ? row : post) / (kChunkCells << level), last));
    };
    const double step_deg =
        is_row ? plan_.header.step_lon_deg * std::cos(plan_.lattice.latitude_rad(row)) : plan_.header.step_lat_deg;
    const double cell_m = base::radians(step_deg) * earth::kGreatestCurvatureRadius_m;
    line.sagitta_m = cell_m * cell_m / (8 * earth::kMinCurvatureRadius_m);
    return line;
}

std::uint64_t InsetLines::place_of(LineDirection way, std::uint32_t line, std::uint32_t post) const {
    const PostRange& region = posts_.region();
    const bool is_row = way == LineDirection::row;
    const std::uint32_t first_line = is_row ? region.j0 : region.i0, first = is_row ? region.i0 : region.j0,
                        last = is_row ? region.i1 : region.j1;
    const std::uint64_t n = (line - first_line + kChunkCells - 1) / kChunkCells;
    return n * (last - first + 1) + post - first;
}

std::vector<std::uint8_t> InsetLines::along(LineDirection way, std::uint32_t line, std::uint32_t first,
                                            std::uint32_t count) const {
    std::vector<std::uint8_t> levels(count);
    (way == LineDirection::row ? rows_ : columns_).read(place_of(way, line, first), levels.data(), count);
    return levels;
}

void InsetLines::sync() {
    rows_.sync();
    columns_.sync();
}

}  // namespace tedavis::host_sim
