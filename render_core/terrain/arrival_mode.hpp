/// When data that were requested become available.
#pragma once

#include <cstdint>

namespace tedavis::terrain {

enum class ArrivalMode : std::uint8_t {
    exact,  ///< a fixed number of frames later, whatever the machine's speed; a replay waits where necessary
    live,   ///< when they have been read; until then the terrain is drawn coarser
};

}  // namespace tedavis::terrain
