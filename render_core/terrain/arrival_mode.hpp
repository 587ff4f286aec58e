/// When something that was asked for may be used.
#pragma once

#include <cstdint>

namespace tedavis::terrain {

enum class ArrivalMode : std::uint8_t {
    exact,  ///< a stated number of frames later, whatever the machine does: replay waits where it must
    live,   ///< when it has been read; what is late is drawn coarser
};

}  // namespace tedavis::terrain
