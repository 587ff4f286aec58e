/// Errors of a knob over all its samples, and grounds to make one on.
#pragma once

#include <sstream>
#include <vector>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"
#include "host_sim/accuracy/statistics.hpp"
#include "host_sim/commands/trace.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::test_support {

struct MadeKnobGround {
    FlownFiles files;
    base::SerialWorkers workers;
    host_sim::TracedGround ground{files.terrain, workers};
    [[nodiscard]] host_sim::KnobGround quick() const { return {ground, true}; }
};

/// The shipped hills, which knobs are measured on by default.
struct ShippedKnobGround {
    TemporaryFolder folder;
    std::ostringstream results, notes;
    host_sim::Console console{results, notes, true, false};
    base::SerialWorkers workers;
    host_sim::TracedGround ground{host_sim::database_of({"", ""}, folder.path(), console), workers};
    [[nodiscard]] host_sim::KnobGround quick() const { return {ground, true}; }
};

inline std::vector<double> all_errors(host_sim::Knob& knob, std::size_t level) {
    std::vector<double> all, errors;
    for (std::size_t sample = 0; sample < knob.samples(); ++sample) {
        errors.clear();
        knob.find_errors(level, sample, errors);
        all.insert(all.end(), errors.begin(), errors.end());
    }
    return all;
}

inline host_sim::ErrorDistribution errors_of(host_sim::Knob& knob, std::size_t level) {
    return host_sim::distribution_of(all_errors(knob, level));
}

/// Mean errors of the levels over their amounts.
inline std::vector<host_sim::LawPoint> points_of(const host_sim::Knob& knob, const std::vector<double>& means) {
    std::vector<host_sim::LawPoint> points;
    for (std::size_t level = 0; level < means.size(); ++level)
        points.push_back({knob.facts().levels[level].amount, means[level]});
    return points;
}

/// Of the mean errors over the amounts, as the report has it.
inline host_sim::FittedLaw law_of(host_sim::Knob& knob) {
    std::vector<double> means;
    for (std::size_t level = 0; level < knob.facts().levels.size(); ++level) means.push_back(errors_of(knob, level).mean);
    return host_sim::fit_law(points_of(knob, means));
}

}  // namespace tedavis::test_support
