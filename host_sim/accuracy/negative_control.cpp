#include "host_sim/accuracy/negative_control.hpp"

#include <algorithm>
#include <cstdio>

#include "host_sim/accuracy/measure_knob.hpp"

namespace tedavis::host_sim {

NegativeControl measure_control(Knob& control) {
    const MeasuredLevel wrong = level_errors(control, 0), right = level_errors(control, 1);
    NegativeControl measured;
    measured.title = control.facts().title.text();
    measured.unit = control.facts().unit.text();
    measured.wrong_name = wrong.name;
    measured.right_name = right.name;
    measured.worst_place = wrong.worst_place;
    measured.reference_bound = control.facts().reference.error_bound();
    measured.wrong = wrong.error;
    measured.right = right.error;
    const double known = std::max(right.error.mean, measured.reference_bound);
    measured.is_caught = wrong.error.mean >= NegativeControl::kMinRatio * known && wrong.error.mean > 0;
    return measured;
}

std::string control_text(const NegativeControl& control) {
    char text[400];
    std::snprintf(
        text, sizeof text,
        "The negative control, %s instead of %s, is wrong by %.3g %s in the mean and %.3g at most (%s: %.3g and %.3g): %s.",
        control.wrong_name.c_str(), control.right_name.c_str(), control.wrong.mean, control.unit.c_str(), control.wrong.max,
        control.right_name.c_str(), control.right.mean, control.right.max,
        control.is_caught ? "the figures show that it is wrong"
                          : "the figures do not show that it is wrong, so they cannot be trusted");
    return text;
}

}  // namespace tedavis::host_sim
