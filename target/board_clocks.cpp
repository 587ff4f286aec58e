#include "target/board_clocks.hpp"

#include <ctime>

#include "platform/clock/monotonic_clock.hpp"

namespace tedavis::target {
namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;

base::Time monotonic_now() { return platform::monotonic_now(); }

base::Time wall_now() {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    return {static_cast<std::int64_t>(now.tv_sec) * kNanosecondsPerSecond + now.tv_nsec};
}

void sleep_until(base::Time time) {
    if (time.ns <= 0) return;
    timespec end{};
    end.tv_sec = static_cast<time_t>(time.ns / kNanosecondsPerSecond);
    end.tv_nsec = static_cast<long>(time.ns % kNanosecondsPerSecond);
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &end, nullptr);
}

}  // namespace

BoardClocks machine_clocks() noexcept { return {{&monotonic_now, &wall_now}, &sleep_until}; }

}  // namespace tedavis::target
