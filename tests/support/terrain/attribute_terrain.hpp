/// Tiles of posts made from formulas, for the tests of attribute maps.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "host_sim/terrain_builder/attributes/attribute_tile.hpp"
#include "host_sim/terrain_builder/attributes/far_horizons.hpp"

namespace tedavis::test_support {

/// Heights of inner column and row; the apron's are negative or beyond the last.
using HeightFormula = std::function<double(int, int)>;

inline host_sim::AttributeTile make_tile(int columns, int rows, double east_m, double north_m, const HeightFormula& height_m) {
    host_sim::AttributeTile tile;
    tile.columns = columns;
    tile.rows = rows;
    tile.north_m = north_m;
    tile.east_m.assign(static_cast<std::size_t>(tile.full_rows()), east_m);
    for (int j = 0; j < tile.full_rows(); ++j)
        for (int i = 0; i < tile.full_columns(); ++i)
            tile.height_m.push_back(static_cast<float>(height_m(i - host_sim::kAttributeApron, j - host_sim::kAttributeApron)));
    tile.post_class.assign(tile.height_m.size(), terrain::PostClass::land);
    return tile;
}

inline std::size_t post_of(const host_sim::AttributeTile& tile, int column, int row) {
    return static_cast<std::size_t>((row + host_sim::kAttributeApron) * tile.full_columns() + column + host_sim::kAttributeApron);
}

/// A square of heights, and nothing round it.
struct HeightSquare {
    int posts = 0;
    std::vector<double> height_m;
    double spacing_m = 0;

    [[nodiscard]] bool holds(int column, int row) const { return column >= 0 && row >= 0 && column < posts && row < posts; }
    [[nodiscard]] double at(int column, int row) const { return height_m[static_cast<std::size_t>(row * posts + column)]; }
    /// The level above: means of two by two posts. The number of posts must be even.
    [[nodiscard]] HeightSquare halved() const {
        HeightSquare half{posts / 2, {}, 2 * spacing_m};
        for (int j = 0; j < half.posts; ++j)
            for (int i = 0; i < half.posts; ++i)
                half.height_m.push_back(
                    (at(2 * i, 2 * j) + at(2 * i + 1, 2 * j) + at(2 * i, 2 * j + 1) + at(2 * i + 1, 2 * j + 1)) / 4);
        return half;
    }
    [[nodiscard]] host_sim::AttributeTile tile() const {
        host_sim::AttributeTile result =
            make_tile(posts, posts, spacing_m, spacing_m, [this](int i, int j) { return holds(i, j) ? at(i, j) : 0.0; });
        for (int j = -host_sim::kAttributeApron; j < posts + host_sim::kAttributeApron; ++j)
            for (int i = -host_sim::kAttributeApron; i < posts + host_sim::kAttributeApron; ++i)
                if (!holds(i, j)) result.post_class[post_of(result, i, j)] = terrain::PostClass::outside;
        return result;
    }
    /// The far horizons of its own level, seen through the whole pyramid above it.
    [[nodiscard]] host_sim::FarHorizons far_horizons() const;
};

/// How a level of HeightSquare looks at the one above.
inline host_sim::FarView view_of(const host_sim::FarHorizons& above) { return {&above, -0.25, -0.25}; }

inline host_sim::FarHorizons HeightSquare::far_horizons() const {
    const host_sim::AttributeTile own = tile();
    const host_sim::HeightPlanes planes(own);
    if (posts < 4) return host_sim::make_far_horizons(planes, {});
    const host_sim::FarHorizons above = halved().far_horizons();
    return host_sim::make_far_horizons(planes, view_of(above));
}

}  // namespace tedavis::test_support
