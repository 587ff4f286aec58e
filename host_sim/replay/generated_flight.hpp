/// Tells a generated flight from a recorded one.
#pragma once

#include <string>

namespace tedavis::host_sim {

/// True if the manifest of a scenario lies beside the log; the display then flags the flight as generated.
[[nodiscard]] bool is_generated_flight(const std::string& log);

}  // namespace tedavis::host_sim
