/// The exact surface over the common raster, in double: two triangles a cell, by either diagonal, over a plane; and the first
/// point where a ray meets it.
///
/// A source for renderers that divide cells in other ways: `Diagonal::either` is the range between both divisions, in which
/// every bilinear cell lies, too.
#pragma once

#include <algorithm>

#include "tests/bench/peers/peer_frame.hpp"

namespace tedavis::peers {

enum class Diagonal { north_east, either };  ///< from the cell's south-west corner to the north-east one, or any

class FlatGround {
public:
    explicit FlatGround(std::vector<std::int16_t> posts)
        : posts_(std::move(posts)), highest_m_(*std::max_element(posts_.begin(), posts_.end())) {}

    /// How far a height lies above the surface in grid coordinates (column, row from the north); negative below it. 0 within
    /// the range of `either`.
    [[nodiscard]] double above_m(double column, double row, double height_m, Diagonal diagonal) const {
        const Cell cell = cell_at(column, row);
        const double one = height_m - cell.north_east();
        if (diagonal == Diagonal::north_east) return one;
        const double other = height_m - cell.north_west();
        if (one * other <= 0) return 0;
        return std::fabs(one) < std::fabs(other) ? one : other;
    }
    /// Not within two cells of the border, where some renderers hang skirts.
    [[nodiscard]] static bool is_inside(double column, double row) {
        return column > 2 && row > 2 && column < kSide - 3 && row < kSide - 3;
    }
    /// The depth in metres of the first point below the surface (diagonal north-east) on eye + depth * direction; infinite
    /// without one. The eye lies above the ground.
    [[nodiscard]] double first_hit_m(const glm::dvec3& eye, const glm::dvec3& direction) const {
        const glm::dvec3 origin(eye.x / kSpacing_m, (kExtent_m - eye.y) / kSpacing_m, eye.z);
        const glm::dvec3 step(direction.x / kSpacing_m, -direction.y / kSpacing_m, direction.z);
        double from = 0, to = kFar_m;
        clip(origin.x, step.x, from, to);
        clip(origin.y, step.y, from, to);
        if (step.z < 0) from = std::max(from, (highest_m_ - origin.z) / step.z);
        if (step.z > 0) to = std::min(to, (highest_m_ - origin.z) / step.z);
        return march(origin, step, from, to);
    }

private:
    struct Cell {
        double north_west_m, north_east_m, south_west_m, south_east_m, x, y;  ///< x east, y south, 0..1

        /// Divided from north-east to south-west, as raytrace::CellSurface::two_triangles is.
        [[nodiscard]] double north_east() const {
            return x + y <= 1 ? north_west_m + x * (north_east_m - north_west_m) + y * (south_west_m - north_west_m)
                              : south_east_m + (1 - x) * (south_west_m - south_east_m) + (1 - y) * (north_east_m - south_east_m);
        }
        [[nodiscard]] double north_west() const {
            return x >= y ? north_west_m + x * (north_east_m - north_west_m) + y * (south_east_m - north_east_m)
                          : north_west_m + y * (south_west_m - north_west_m) + x * (south_east_m - south_west_m);
        }
    };
    [[nodiscard]] double post(std::uint32_t column, std::uint32_t row) const { return posts_[std::size_t{row} * kSide + column]; }
    [[nodiscard]] Cell cell_at(double column, double row) const {
        const auto whole = [](double at) { return static_cast<std::uint32_t>(std::clamp(at, 0.0, kSide - 2.0)); };
        return cell(whole(column), whole(row), column, row);
    }
    [[nodiscard]] Cell cell(std::uint32_t c, std::uint32_t r, double column, double row) const {
        return {post(c, r), post(c + 1, r), post(c, r + 1), post(c + 1, r + 1), column - c, row - r};
    }
    static void clip(double origin, double step, double& from, double& to) {
        if (step == 0) {
            if (origin < 0 || origin > kSide - 1) to = -1;
            return;
        }
        const double a = -origin / step, b = (kSide - 1 - origin) / step;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    static double next_crossing(double origin, double step, std::int64_t whole) {
        if (step == 0) return std::numeric_limits<double>::infinity();
        return ((step > 0 ? static_cast<double>(whole) + 1 : static_cast<double>(whole)) - origin) / step;
    }
    /// Cell by cell (Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing", 1987).
    [[nodiscard]] double march(const glm::dvec3& origin, const glm::dvec3& step, double from, double to) const {
        if (!(from < to)) return std::numeric_limits<double>::infinity();
        const auto whole = [&](double at) { return std::clamp<std::int64_t>(static_cast<std::int64_t>(at), 0, kSide - 2); };
        std::int64_t column = whole(origin.x + from * step.x), row = whole(origin.y + from * step.y);
        for (double t = from; t < to;) {
            const double across = next_crossing(origin.x, step.x, column), down = next_crossing(origin.y, step.y, row);
            const double end = std::min({across, down, to});
            const double hit = hit_in(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row), origin, step, t, end);
            if (hit >= 0) return hit;
            (across < down ? column : row) += (across < down ? step.x : step.y) > 0 ? 1 : -1;
            if (column < 0 || row < 0 || column > kSide - 2 || row > kSide - 2) break;
            t = std::max(t, end);
        }
        return std::numeric_limits<double>::infinity();
    }
    /// -1 without a hit.
    [[nodiscard]] double hit_in(std::uint32_t c, std::uint32_t r, const glm::dvec3& origin, const glm::dvec3& step, double from,
                                double to) const {
        const double low = origin.z + (step.z < 0 ? to : from) * step.z;
        if (low > std::max({post(c, r), post(c + 1, r), post(c, r + 1), post(c + 1, r + 1)})) return -1;
        const auto above = [&](double t) {
            const glm::dvec3 at = origin + t * step;
            return at.z - cell(c, r, at.x, at.y).north_east();
        };
        const double turn = (c + r + 1 - origin.x - origin.y) / (step.x + step.y);  // on the diagonal
        double begin = from, height = above(from);
        if (height <= 0) return from;
        for (const double end : {turn, to}) {
            if (!(end > begin && end <= to)) continue;
            const double next = above(end);
            if (next <= 0) return begin + (end - begin) * height / (height - next);
            begin = end;
            height = next;
        }
        return -1;
    }

    std::vector<std::int16_t> posts_;
    double highest_m_;
};

}  // namespace tedavis::peers
