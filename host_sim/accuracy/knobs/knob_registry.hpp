/// The list of all knobs that `tedavis accuracy` can measure.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

struct RegisteredKnob {
    const char* name;
    std::unique_ptr<Knob> (*make)(const KnobGround& ground);
};

/// Returns all knobs, in the order in which they are measured.
[[nodiscard]] const std::vector<RegisteredKnob>& knob_registry();

/// Returns the knobs with these names, or all knobs if `names` is empty, in the registry's order. Throws UserError for a name
/// that no knob has.
[[nodiscard]] std::vector<RegisteredKnob> chosen_knobs(const std::vector<std::string>& names);

/// Returns why a knob cannot be measured credibly, or an empty text if it can. The faults are an empty statement, fewer than two
/// levels (none, where the product has one level only), an expected law of a single level, two levels with the same name, and a
/// reference whose error bound is not 0 or more. Tests call it for every knob.
[[nodiscard]] std::string fault_of(const KnobFacts& facts);

}  // namespace tedavis::host_sim
