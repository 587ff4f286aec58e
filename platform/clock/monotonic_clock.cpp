#include "platform/clock/monotonic_clock.hpp"

#include <ctime>

namespace tedavis::platform {

base::Time monotonic_now() noexcept {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return {static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec};
}

}  // namespace tedavis::platform
