/// The negative control of a report: a level that is wrong on purpose, and whether the report's own figures show it.
#pragma once

#include <string>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/statistics.hpp"

namespace tedavis::host_sim {

struct NegativeControl {
    /// Least ratio of the wrong level's mean error to that of the right level, and to the reference's own bound.
    static constexpr double kMinRatio = 10;

    std::string title, unit, wrong_name, right_name, worst_place;
    double reference_bound = 0;
    ErrorDistribution wrong, right;
    bool is_caught = false;
};

/// Measures the errors of a knob with two levels, the wrong one first (make_ray_control()).
[[nodiscard]] NegativeControl measure_control(Knob& control);

/// "The control, 16 steps instead of 4096, is wrong by 61 cells of the grid in the mean (4096 steps: 0.2): the report shows it."
[[nodiscard]] std::string control_text(const NegativeControl& control);

}  // namespace tedavis::host_sim
