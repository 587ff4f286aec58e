/// The colour of spatial data and their uncertainty at a point of the ground (thesis 7: intrinsic display in the traced
/// picture).
///
/// Two grids over the terrain give a value, which selects a colour of a palette, and an uncertainty, which sets its
/// transparency. Where either is missing, the terrain's colour is shown. Missing values are not interpolated. Pure; any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

#include "render_core/base/span.hpp"

namespace tedavis::raytrace {

/// Values at regular posts; NaN where missing. Borrowed.
struct DataGrid {
    const float* values = nullptr;  ///< row by row
    std::uint32_t columns = 0, rows = 0;
    double first_x = 0, first_y = 0;  ///< position of the first post, in the terrain's grid space
    double step_x = 1, step_y = 1;    ///< spacing of posts, in posts of the terrain; not 0
};

struct DataColor {
    glm::vec3 color{0};
    float cover = 0;  ///< 0: only the terrain's colour; 1: only the data's
};

struct DataLegend {
    base::Span<const glm::vec3> palette;  ///< from the lowest value to the highest; classes of equal width
    float lowest = 0, highest = 1;        ///< beyond them the first and last colour
    float certain = 0, uncertain = 1;     ///< uncertainties with full and with no opacity; linear between
    float cover = 1;                      ///< opacity of certain data
};

/// Bilinear between four posts that all have values; NaN elsewhere.
[[nodiscard]] inline float value_at(const DataGrid& grid, double x, double y) {
    const double across = (x - grid.first_x) / grid.step_x, down = (y - grid.first_y) / grid.step_y;
    const bool is_inside = across >= 0 && down >= 0 && across <= grid.columns - 1.0 && down <= grid.rows - 1.0;
    if (grid.values == nullptr || grid.columns < 2 || grid.rows < 2 || !is_inside) return std::nanf("");
    const auto i = std::min(static_cast<std::uint32_t>(across), grid.columns - 2);
    const auto j = std::min(static_cast<std::uint32_t>(down), grid.rows - 2);
    const float* const post = grid.values + std::size_t{j} * grid.columns + i;
    const auto u = static_cast<float>(across - i), v = static_cast<float>(down - j);
    return (post[0] * (1 - u) + post[1] * u) * (1 - v) + (post[grid.columns] * (1 - u) + post[grid.columns + 1] * u) * v;
}

/// The class of a value, 0..classes - 1, by comparisons.
[[nodiscard]] inline std::size_t class_of(float value, float lowest, float highest, std::size_t classes) {
    const float share = (value - lowest) / (highest - lowest) * static_cast<float>(classes);
    if (!(share > 0)) return 0;
    return share >= static_cast<float>(classes) ? classes - 1 : static_cast<std::size_t>(share);
}

[[nodiscard]] inline DataColor data_color(const DataGrid& values, const DataGrid& uncertainties, const DataLegend& legend,
                                          double x, double y) {
    const float value = value_at(values, x, y), uncertainty = value_at(uncertainties, x, y);
    if (std::isnan(value) || std::isnan(uncertainty) || legend.palette.empty()) return {};
    DataColor found;
    found.color = legend.palette[class_of(value, legend.lowest, legend.highest, legend.palette.size())];
    const float doubt = (uncertainty - legend.certain) / (legend.uncertain - legend.certain);
    found.cover = legend.cover * (1 - std::clamp(doubt, 0.0f, 1.0f));
    return found;
}

}  // namespace tedavis::raytrace
