/// A clock that goes on by the same time at every look, so that every frame of a calibration takes exactly this long.
#pragma once

#include "target/board_clocks.hpp"

namespace tedavis::target {

struct TickingClock {
    static constexpr std::int64_t kTick_ns = 7'000'000;
    static inline std::int64_t now_ns = 0;
    static inline void (*on_look)() = nullptr;

    static base::Time monotonic() {
        now_ns += kTick_ns;
        if (on_look != nullptr) on_look();
        return {now_ns};
    }
    static base::Time wall() { return {1'780'322'557'000'000'000}; }
    static BoardClocks clocks() { return {{&monotonic, &wall}, nullptr}; }
    static void reset() {
        now_ns = 0;
        on_look = nullptr;
    }
};

}  // namespace tedavis::target
