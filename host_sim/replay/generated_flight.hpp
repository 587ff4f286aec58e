/// Tells a generated flight from a recorded one.
#pragma once

#include <string>

namespace tedavis::host_sim {

/// A scenario leaves its manifest beside the flight; such a flight says on the display that it is generated.
[[nodiscard]] bool is_generated_flight(const std::string& log);

}  // namespace tedavis::host_sim
