/// What a view should show of the full raster, with all its triangles projected: their upper envelope, exact to rounding, and
/// the pixels whose centres they cover.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::test_support {

class TrueView {
public:
    static constexpr int kSamples = 5;  ///< a pixel; odd, so that one is at its centre

    /// A terrain has columns(), rows() and the ECEF place(i, j) of each post, NaN where it is void.
    template <class Terrain>
    TrueView(const Terrain& terrain, const terrain::View& view)
        : view_(view),
          top_(std::size_t{view.width} * kSamples, std::numeric_limits<double>::infinity()),
          covered_(std::size_t{view.width} * view.height, 0) {
        std::vector<glm::dvec3> row = place_row(terrain, 0);
        for (int j = 1; j < terrain.rows(); ++j) {
            std::vector<glm::dvec3> below = place_row(terrain, j);
            for (std::size_t i = 0; i + 1 < row.size(); ++i) {
                if (std::isnan(row[i].z + row[i + 1].z + below[i].z + below[i + 1].z)) continue;
                include({row[i], below[i], row[i + 1]});
                include({row[i + 1], below[i], below[i + 1]});
            }
            row.swap(below);
        }
        sum_covered();
    }

    /// Pixels from the top edge of the picture at a column's centre; infinite where there is no terrain.
    [[nodiscard]] double at_centre(int column) const { return sample(column * kSamples + kSamples / 2); }
    /// The lowest within a fifth of a pixel of it: where a near summit ends, moving a vertex to the rasteriser's grid tells.
    [[nodiscard]] double lowest_at_centre(int column) const {
        return std::max(
            {at_centre(column), sample(column * kSamples + kSamples / 2 - 1), sample(column * kSamples + kSamples / 2 + 1)});
    }
    /// The highest place that a point can be moved to which lies on or below the skyline and moves by `reach_px` at most, over
    /// the column's centre.
    [[nodiscard]] double highest_within(int column, double reach_px) const {
        double highest = std::numeric_limits<double>::infinity();
        const double centre = column + 0.5;
        const int first = static_cast<int>(std::floor((centre - reach_px) * kSamples)),
                  last = static_cast<int>(std::ceil((centre + reach_px) * kSamples));
        for (int n = first; n <= last; ++n) {
            const double aside = (n + 0.5) / kSamples - centre;
            highest = std::min(highest, sample(n) - std::sqrt(std::max(0.0, reach_px * reach_px - aside * aside)));
        }
        return highest;
    }
    /// The surface fills the pixel and all within `margin` pixels of it; unknown, and no, beside the picture's edges.
    [[nodiscard]] bool covers(int column, int row, int margin) const {
        const int west = column - margin, east = column + margin + 1, north = row - margin, south = row + margin + 1;
        if (west < 0 || north < 0 || east > static_cast<int>(view_.width) || south > static_cast<int>(view_.height)) return false;
        return sum(east, south) - sum(west, south) - sum(east, north) + sum(west, north) == (east - west) * (south - north);
    }

private:
    /// Posts in the view's axes: right, down, forward.
    template <class Terrain>
    [[nodiscard]] std::vector<glm::dvec3> place_row(const Terrain& terrain, int j) const {
        std::vector<glm::dvec3> row;
        for (int i = 0; i < terrain.columns(); ++i) {
            const glm::dvec3 d = terrain.place(i, j) - view_.eye;
            row.emplace_back(glm::dot(d, view_.right), glm::dot(d, view_.down), glm::dot(d, view_.forward));
        }
        return row;
    }
    [[nodiscard]] double sample(int n) const {
        return n < 0 || n >= static_cast<int>(top_.size()) ? std::numeric_limits<double>::infinity()
                                                           : top_[static_cast<std::size_t>(n)];
    }
    struct Pixel {
        double x, y;
    };
    using Polygon = base::FixedVector<Pixel, 4>;

    /// A triangle in the view's axes, counter-clockwise from above, cut at the near plane. Nothing is seen from below.
    void include(const std::array<glm::dvec3, 3>& corner) {
        if (glm::dot(glm::cross(corner[1] - corner[0], corner[2] - corner[0]), corner[0]) >= 0) return;
        const double near_m = view_.near_m;
        Polygon polygon;
        for (std::size_t n = 0; n < 3; ++n) {
            const glm::dvec3 &a = corner[n], &b = corner[(n + 1) % 3];
            if (a.z >= near_m) static_cast<void>(polygon.try_push_back(pixel_of(a)));
            if ((a.z >= near_m) != (b.z >= near_m))
                static_cast<void>(polygon.try_push_back(pixel_of(a + (b - a) * ((near_m - a.z) / (b.z - a.z)))));
        }
        for (std::size_t n = 0; n < polygon.size(); ++n) raise_skyline(polygon[n], polygon[(n + 1) % polygon.size()]);
        if (polygon.size() > 2) cover(polygon);
    }
    [[nodiscard]] Pixel pixel_of(const glm::dvec3& p) const {
        return {0.5 * view_.width + view_.focal_px * p.x / p.z, 0.5 * view_.height + view_.focal_px * p.y / p.z};
    }
    /// Places between `low` and `high` that are a whole number and a half, of `count` ones from 0.5 on.
    struct Centres {
        int first, last;

        Centres(double low, double high, double count)
            : first(static_cast<int>(std::ceil(std::clamp(low - 0.5, 0.0, count)))),
              last(static_cast<int>(std::floor(std::clamp(high - 0.5, -1.0, count - 1)))) {}
    };
    void raise_skyline(Pixel a, Pixel b) {
        if (a.x > b.x) std::swap(a, b);
        const Centres samples(a.x * kSamples, b.x * kSamples, static_cast<double>(top_.size()));
        for (int n = samples.first; n <= samples.last; ++n) {
            const double x = (n + 0.5) / kSamples;
            double& top = top_[static_cast<std::size_t>(n)];
            top = std::min(top, b.x > a.x ? a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x) : std::min(a.y, b.y));
        }
    }
    /// A convex polygon, row by row.
    void cover(const Polygon& polygon) {
        double north = polygon[0].y, south = north;
        for (const Pixel& p : polygon) north = std::min(north, p.y), south = std::max(south, p.y);
        const Centres rows(north, south, view_.height);
        for (int row = rows.first; row <= rows.last; ++row) {
            const double y = row + 0.5;
            double west = std::numeric_limits<double>::infinity(), east = -west;
            for (std::size_t n = 0; n < polygon.size(); ++n) {
                const Pixel &a = polygon[n], &b = polygon[(n + 1) % polygon.size()];
                if ((a.y <= y) == (b.y <= y)) continue;
                const double x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
                west = std::min(west, x);
                east = std::max(east, x);
            }
            if (!(west <= east)) continue;
            const Centres columns(west, east, view_.width);
            for (int column = columns.first; column <= columns.last; ++column)
                covered_[static_cast<std::size_t>(row) * view_.width + static_cast<std::size_t>(column)] = 1;
        }
    }
    /// Of covered pixels above and left of a pixel's north-west corner.
    void sum_covered() {
        const std::size_t width = view_.width;
        sums_.assign((width + 1) * (view_.height + 1), 0);
        for (std::size_t row = 0; row < view_.height; ++row)
            for (std::size_t column = 0; column < width; ++column)
                sums_[(row + 1) * (width + 1) + column + 1] =
                    covered_[row * width + column] + sums_[row * (width + 1) + column + 1] +
                    sums_[(row + 1) * (width + 1) + column] - sums_[row * (width + 1) + column];
    }
    [[nodiscard]] int sum(int column, int row) const {
        return sums_[static_cast<std::size_t>(row) * (view_.width + 1) + static_cast<std::size_t>(column)];
    }

    const terrain::View& view_;
    std::vector<double> top_;
    std::vector<char> covered_;
    std::vector<int> sums_;
};

}  // namespace tedavis::test_support
