/// The parts of the accuracy overlay (host_sim/accuracy/accuracy_overlay.hpp).
#pragma once

namespace tedavis::host_sim {

/// Which figures and maps of accuracy a command draws over its finished pictures; the display itself draws none of them.
struct AccuracyShown {
    bool figures = false;    ///< requested and proven terrain error, quality level
    bool error_map = false;  ///< the measured error of the ground, in colors over it

    [[nodiscard]] bool any() const { return figures || error_map; }
    [[nodiscard]] bool operator==(const AccuracyShown& other) const {
        return figures == other.figures && error_map == other.error_map;
    }
};

}  // namespace tedavis::host_sim
