/// Closes gaps and smooths noise in one plane of a grid, and adds the resulting uncertainty.
#pragma once

#include <vector>

#include "render_core/scene/uncertainty.hpp"

namespace tedavis::host_sim {

/// Row by row; all of one size.
struct PreparedPlane {
    int columns = 0, rows = 0;
    std::vector<float> values;  ///< NaN where missing
    std::vector<scene::Uncertainty> uncertainties;
    std::vector<scene::ValueState> states;
};

/// Missing posts no farther than `reach_cells` from known ones get their mean, weighted by 1 / distance^2 (Shepard 1968). They
/// are marked as interpolated; their uncertainty is the greatest of the known ones used, plus `level_per_cell` for each cell to
/// the nearest.
void fill_gaps(PreparedPlane& plane, double reach_cells, double level_per_cell);

/// Filters with a Gaussian of standard deviation `cells`, over known posts only. Missing posts stay missing. Uncertainties are
/// averaged with the same weights, since the correlation of the errors is not known.
void smooth(PreparedPlane& plane, double cells);

}  // namespace tedavis::host_sim
