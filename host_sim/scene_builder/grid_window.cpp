#include "host_sim/scene_builder/grid_window.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::host_sim {
namespace {

constexpr double kRound_deg = 360, kOnPost = 1e-6;  // of a step

/// East of `from`, 0 .. 360.
double east_of(double longitude_deg, double from_deg) {
    const double east = longitude_deg - from_deg;
    return east - kRound_deg * std::floor(east / kRound_deg);
}

bool is_closed(const GridPlaces& places) { return places.step_lon_deg * places.columns >= kRound_deg - kOnPost; }

/// Columns round the Earth that differ: the last may stand upon the first.
int columns_of_turn(const GridPlaces& places) {
    return std::min(places.columns, static_cast<int>(std::lround(kRound_deg / places.step_lon_deg)));
}

std::vector<int> columns_of(const GridPlaces& places, const RegionRecipe& region) {
    const double width_deg =
        region.east_deg - region.west_deg >= kRound_deg ? kRound_deg : east_of(region.east_deg, region.west_deg);
    // Posts from the region's west side on; those a whole turn away are those that lie just west of it.
    double first = east_of(region.west_deg, places.west_deg) / places.step_lon_deg;
    if (!is_closed(places) && first > places.columns) first -= kRound_deg / places.step_lon_deg;
    const double last = first + width_deg / places.step_lon_deg;
    std::vector<int> columns;
    const int turn = columns_of_turn(places);
    for (int i = static_cast<int>(std::floor(first + kOnPost)); i <= static_cast<int>(std::ceil(last - kOnPost)); ++i) {
        if (is_closed(places)) {
            if (static_cast<int>(columns.size()) <= turn) columns.push_back(((i % turn) + turn) % turn);
        } else if (i >= 0 && i < places.columns) {
            columns.push_back(i);
        }
    }
    return columns;
}

std::vector<int> rows_of(const GridPlaces& places, const RegionRecipe& region) {
    const int first = static_cast<int>(std::floor((places.north_deg - region.north_deg) / places.step_lat_deg + kOnPost)),
              last = static_cast<int>(std::ceil((places.north_deg - region.south_deg) / places.step_lat_deg - kOnPost));
    std::vector<int> rows;
    for (int j = std::max(first, 0); j <= std::min(last, places.rows - 1); ++j) rows.push_back(j);
    return rows;
}

}  // namespace

GridWindow window_of(const GridPlaces& places, const std::optional<RegionRecipe>& region) {
    GridWindow window;
    if (region) {
        window.columns = columns_of(places, *region);
        window.rows = rows_of(places, *region);
    } else {
        for (int i = 0; i < places.columns; ++i) window.columns.push_back(i);
        for (int j = 0; j < places.rows; ++j) window.rows.push_back(j);
    }
    if (window.columns.empty() || window.rows.empty()) return {};
    window.west_deg = places.west_deg + places.step_lon_deg * window.columns.front();
    if (window.west_deg >= 180) window.west_deg -= kRound_deg;
    window.north_deg = places.north_deg - places.step_lat_deg * window.rows.front();
    return window;
}

std::vector<float> cut(const std::vector<float>& plane, const GridPlaces& places, const GridWindow& window) {
    std::vector<float> values;
    values.reserve(window.columns.size() * window.rows.size());
    for (const int j : window.rows)
        for (const int i : window.columns)
            values.push_back(
                plane[static_cast<std::size_t>(j) * static_cast<std::size_t>(places.columns) + static_cast<std::size_t>(i)]);
    return values;
}

}  // namespace tedavis::host_sim
