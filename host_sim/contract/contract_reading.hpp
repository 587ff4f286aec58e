/// The reading of one picture for one condition of a contract.
#pragma once

#include <cstdint>
#include <string>

#include "render_core/perception/edge_density.hpp"

namespace tedavis::host_sim {

enum class ReadingState : std::uint8_t {
    measured,
    absent,  ///< another phase, no obstacle on the way: there is nothing to measure
    missing  ///< the run was recorded without what the measure needs
};

struct ContractReading {
    ReadingState state = ReadingState::absent;
    double value = 0;             ///< infinite for an obstacle without a rank
    perception::PixelRegion box;  ///< of the picture; empty: all of it
    std::string region;           ///< in words
    std::string words;            ///< for `missing` the reason; else an explanation of the value where needed
};

[[nodiscard]] inline ContractReading missing_reading(std::string why) {
    return {ReadingState::missing, 0, {}, {}, std::move(why)};
}

/// Returns "upper left" .. "lower right", by the third in which a box's middle lies.
[[nodiscard]] std::string third_of(const perception::PixelRegion& box, int width, int height);

}  // namespace tedavis::host_sim
