#include "host_sim/scene_builder/grid_preparation.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::host_sim {
namespace {

using scene::Uncertainty;
using scene::ValueState;

constexpr double kReachOfGaussian = 3;  // standard deviations

struct Window {
    int i0, i1, j0, j1;  // both included
};

Window window_round(const PreparedPlane& plane, int i, int j, int reach) {
    return {std::max(i - reach, 0), std::min(i + reach, plane.columns - 1), std::max(j - reach, 0),
            std::min(j + reach, plane.rows - 1)};
}

std::size_t index_of(const PreparedPlane& plane, int i, int j) {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(plane.columns) + static_cast<std::size_t>(i);
}

/// What posts round a place say together.
struct Blend {
    double weight = 0, value = 0, level = 0, nearest_cells = 1e9;
    Uncertainty worst = Uncertainty::from_code(0);
    bool is_known = true;

    void add(double w, float v, Uncertainty u) {
        weight += w;
        value += w * double{v};
        level += w * u.level();
        is_known = is_known && u.is_known();
        worst = scene::worse(worst, u);
    }
};

template <class Weight>
Blend blend_round(const PreparedPlane& plane, int i, int j, int reach, const Weight& weight_at) {
    Blend blend;
    const Window window = window_round(plane, i, j, reach);
    for (int b = window.j0; b <= window.j1; ++b)
        for (int a = window.i0; a <= window.i1; ++a) {
            const std::size_t n = index_of(plane, a, b);
            if (std::isnan(plane.values[n])) continue;
            const double apart = std::hypot(a - i, b - j), weight = weight_at(apart);
            if (!(weight > 0)) continue;
            blend.add(weight, plane.values[n], plane.uncertainties[n]);
            blend.nearest_cells = std::min(blend.nearest_cells, apart);
        }
    return blend;
}

}  // namespace

void fill_gaps(PreparedPlane& plane, double reach_cells, double level_per_cell) {
    if (!(reach_cells > 0)) return;
    const PreparedPlane stated = plane;
    const int reach = static_cast<int>(std::ceil(reach_cells));
    for (int j = 0; j < plane.rows; ++j)
        for (int i = 0; i < plane.columns; ++i) {
            const std::size_t n = index_of(plane, i, j);
            if (!std::isnan(stated.values[n])) continue;
            const Blend blend =
                blend_round(stated, i, j, reach, [&](double apart) { return apart <= reach_cells ? 1 / (apart * apart) : 0; });
            if (!(blend.weight > 0)) continue;
            plane.values[n] = static_cast<float>(blend.value / blend.weight);
            plane.states[n] = ValueState::interpolated;
            plane.uncertainties[n] = blend.worst.is_known()
                                         ? Uncertainty::from_level(blend.worst.level() + level_per_cell * blend.nearest_cells)
                                         : Uncertainty();
        }
}

void smooth(PreparedPlane& plane, double cells) {
    if (!(cells > 0)) return;
    const PreparedPlane stated = plane;
    const int reach = static_cast<int>(std::ceil(kReachOfGaussian * cells));
    for (int j = 0; j < plane.rows; ++j)
        for (int i = 0; i < plane.columns; ++i) {
            const std::size_t n = index_of(plane, i, j);
            if (std::isnan(stated.values[n])) continue;
            const Blend blend =
                blend_round(stated, i, j, reach, [&](double apart) { return std::exp(-0.5 * apart * apart / (cells * cells)); });
            plane.values[n] = static_cast<float>(blend.value / blend.weight);
            plane.uncertainties[n] = blend.is_known ? Uncertainty::from_level(blend.level / blend.weight) : Uncertainty();
        }
}

}  // namespace tedavis::host_sim
