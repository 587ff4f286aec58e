#include "host_sim/terrain_builder/border_lines.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/terrain_builder/nested_polyline.hpp"
#include "host_sim/terrain_builder/surface_heights.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

constexpr std::uint32_t kPiece = kChunkCells << (kMaxLevels - 2);  // posts of a line that are treated alone
constexpr std::uint32_t kLinesOfTask = 32;
constexpr std::uint32_t kRowsAtOnce = 256;

std::uint32_t parts(std::uint32_t whole, std::uint32_t part) { return (whole + part - 1) / part; }

}  // namespace

BorderLines::BorderLines(const BuildPlan& plan, const std::string& folder)
    : LineLevels({plan.header.rows, plan.levels() - 1}, {plan.header.columns, plan.levels() - 1}),
      plan_(plan),
      rows_(folder + "/rows"),
      columns_(folder + "/columns") {
    rows_.resize(std::uint64_t{row_lines_.count()} * plan.header.columns);
    columns_.resize(std::uint64_t{column_lines_.count()} * plan.header.rows);
}

std::uint32_t BorderLines::row_pieces() const {
    return parts(plan_.header.columns - 1, kPiece) * parts(row_lines_.count(), kLinesOfTask);
}
std::uint32_t BorderLines::column_pieces() const {
    return parts(plan_.header.rows - 1, kPiece) * parts(column_lines_.count(), kLinesOfTask);
}

void BorderLines::build_piece(const PostsFile& posts, std::uint32_t piece) {
    const std::uint32_t rows = row_pieces();
    piece < rows ? build_rows(posts, piece) : build_columns(posts, piece - rows);
}

void BorderLines::build_rows(const PostsFile& posts, std::uint32_t piece) {
    const std::uint32_t across = parts(plan_.header.columns - 1, kPiece);
    const std::uint32_t first = piece / across * kLinesOfTask, end = std::min(first + kLinesOfTask, row_lines_.count());
    for (std::uint32_t line = first; line < end; ++line) {
        LatticeWindow window;
        window.i0 = piece % across * kPiece;
        window.j0 = row_lines_.post_of(line);
        window.columns = std::min<std::uint32_t>(kPiece + 1, plan_.header.columns - static_cast<std::uint32_t>(window.i0));
        window.rows = 1;
        posts.read(window);
        add_undulation(plan_, window);
        keep_row(window, line);
    }
}

/// The smaller one of the chunks on both sides.
double BorderLines::row_tolerance_m(std::uint32_t level, std::uint32_t j) const {
    const std::uint32_t last = plan_.lattice.grid_rows(level) - 1, below = j / (kChunkCells << level);
    const std::uint32_t above = below == 0 || j % (kChunkCells << level) != 0 ? below : below - 1;
    return std::min(plan_.tolerance_m(level, std::min(above, last)), plan_.tolerance_m(level, std::min(below, last)));
}

void BorderLines::keep_row(const LatticeWindow& window, std::uint32_t line) {
    const auto j = static_cast<std::uint32_t>(window.j0);
    LinePiece piece;
    piece.first = static_cast<std::uint32_t>(window.i0);
    piece.surface_m = {window.surface_m.data(), window.surface_m.size()};
    piece.post_class = {window.post_class.data(), window.post_class.size()};
    piece.top_level = row_lines_.top_level(j);
    piece.tolerance_m = [this, j](std::uint32_t level, std::uint32_t) { return row_tolerance_m(level, j); };
    const double cell_m =
        base::radians(plan_.header.step_lon_deg) * earth::kGreatestCurvatureRadius_m * std::cos(plan_.lattice.latitude_rad(j));
    piece.sagitta_m = cell_m * cell_m / (8 * earth::kMinCurvatureRadius_m);
    const std::vector<std::uint8_t> levels = keep_levels(piece);
    rows_.write(std::uint64_t{line} * plan_.header.columns + piece.first, levels.data(), levels.size());
}

void BorderLines::build_columns(const PostsFile& posts, std::uint32_t piece) {
    const std::uint32_t across = parts(column_lines_.count(), kLinesOfTask);
    const std::uint32_t first_line = piece % across * kLinesOfTask,
                        lines = std::min(kLinesOfTask, column_lines_.count() - first_line);
    const std::uint32_t first = piece / across * kPiece, rows = std::min(kPiece + 1, plan_.header.rows - first);
    std::vector<std::vector<float>> surfaces(lines);
    std::vector<std::vector<PostClass>> classes(lines);
    for (std::uint32_t row = 0; row < rows; row += kRowsAtOnce) {
        LatticeWindow window;
        window.i0 = column_lines_.post_of(first_line);
        window.j0 = first + row;
        window.columns = column_lines_.post_of(first_line + lines - 1) - static_cast<std::uint32_t>(window.i0) + 1;
        window.rows = std::min(kRowsAtOnce, rows - row);
        posts.read(window);
        add_undulation(plan_, window);
        for (std::uint32_t line = 0; line < lines; ++line)
            for (std::uint32_t j = 0; j < window.rows; ++j) {
                const std::size_t n = window.at(column_lines_.post_of(first_line + line), window.j0 + j);
                surfaces[line].push_back(window.surface_m[n]);
                classes[line].push_back(window.post_class[n]);
            }
    }
    for (std::uint32_t line = 0; line < lines; ++line) keep_column(surfaces[line], classes[line], first_line + line, first);
}

void BorderLines::keep_column(const std::vector<float>& surface_m, const std::vector<PostClass>& classes, std::uint32_t line,
                              std::uint32_t first) {
    LinePiece piece;
    piece.first = first;
    piece.surface_m = {surface_m.data(), surface_m.size()};
    piece.post_class = {classes.data(), classes.size()};
    piece.top_level = column_lines_.top_level(column_lines_.post_of(line));
    piece.tolerance_m = [this](std::uint32_t level, std::uint32_t post) {
        return plan_.tolerance_m(level, post / (kChunkCells << level));
    };
    const double cell_m = base::radians(plan_.header.step_lat_deg) * earth::kGreatestCurvatureRadius_m;
    piece.sagitta_m = cell_m * cell_m / (8 * earth::kMinCurvatureRadius_m);
    const std::vector<std::uint8_t> levels = keep_levels(piece);
    columns_.write(std::uint64_t{line} * plan_.header.rows + first, levels.data(), levels.size());
}

std::vector<std::uint8_t> BorderLines::along(LineDirection way, std::uint32_t line, std::uint32_t first,
                                             std::uint32_t count) const {
    std::vector<std::uint8_t> levels(count);
    const bool is_row = way == LineDirection::row;
    const std::uint64_t posts = is_row ? plan_.header.columns : plan_.header.rows;
    (is_row ? rows_ : columns_).read(lines(way).line_at(line) * posts + first, levels.data(), count);
    return levels;
}

void BorderLines::sync() {
    rows_.sync();
    columns_.sync();
}

}  // namespace tedavis::host_sim
