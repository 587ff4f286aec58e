/// The program's version, "major.minor.patch".
#pragma once

namespace tedavis::host_sim {

[[nodiscard]] const char* version();

}  // namespace tedavis::host_sim
