#include "host_sim/version.hpp"

#include "host_sim/commit.hpp"

namespace tedavis::host_sim {

const char* version() { return TEDAVIS_VERSION; }
const char* commit() { return TEDAVIS_COMMIT; }

}  // namespace tedavis::host_sim
