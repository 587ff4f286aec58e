/// The overlay by which a picture shows how accurate it is (host_sim/accuracy/accuracy_overlay.hpp).
#pragma once

namespace tedavis::host_sim {

/// What a command draws over its finished pictures to show how accurate they are; the display never draws it.
struct AccuracyShown {
    bool figures = false;    ///< requested and proven error, quality level
    bool error_map = false;  ///< the measured error of the ground, in colors over it

    [[nodiscard]] bool any() const { return figures || error_map; }
    [[nodiscard]] bool operator==(const AccuracyShown& other) const {
        return figures == other.figures && error_map == other.error_map;
    }
};

}  // namespace tedavis::host_sim
