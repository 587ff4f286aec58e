/// Every knob of `tedavis accuracy`.
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

/// In the order in which they are measured.
[[nodiscard]] const std::vector<RegisteredKnob>& knob_registry();

/// The knobs of these names, all where there are none; in the registry's order. Throws UserError for one that is unknown.
[[nodiscard]] std::vector<RegisteredKnob> chosen_knobs(const std::vector<std::string>& names);

/// Why a knob cannot be measured credibly; empty where it can: a statement that is empty, no levels, two levels of one name, a
/// reference without a bound.
[[nodiscard]] std::string fault_of(const KnobFacts& facts);

}  // namespace tedavis::host_sim
