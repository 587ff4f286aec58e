/// Costs for the display of a board.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "render_core/display/calibration_subject.hpp"
#include "target/board_display.hpp"
#include "tests/support/flights/even_costs.hpp"

namespace tedavis::target {

inline std::string costs_of(const BoardSettings& settings, const std::string& renderer) {
    return test_support::even_costs(
        {settings.device.name, base::FixedString<127>(renderer), settings.width_px, settings.height_px});
}

inline std::string costs_of_this_board(const BoardSettings& settings) {
    platform::DisplayHost host;
    EXPECT_FALSE(start_board_display(settings, host));
    return test_support::even_costs(display::calibration_subject(host.display()));
}

}  // namespace tedavis::target
