/// What one picture says of one condition of a contract.
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
    double value = 0;             ///< infinite for a rank that no place has
    perception::PixelRegion box;  ///< of the picture; empty: all of it
    std::string region;           ///< in words
    std::string words;            ///< of `missing` why; else what it is, where the value does not say it
};

[[nodiscard]] inline ContractReading missing_reading(std::string why) {
    return {ReadingState::missing, 0, {}, {}, std::move(why)};
}

/// "upper left" .. "lower right", by the third that a box's middle lies in.
[[nodiscard]] std::string third_of(const perception::PixelRegion& box, int width, int height);

}  // namespace tedavis::host_sim
