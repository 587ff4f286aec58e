#include "host_sim/version.hpp"

namespace tedavis::host_sim {

const char* version() { return TEDAVIS_VERSION; }

}  // namespace tedavis::host_sim
