/// What a display without a screen draws: RGBA, bottom row first.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "render_core/display/preroll.hpp"
#include "render_core/gl/readback.hpp"
#include "tests/support/flights/default_flight.hpp"

namespace tedavis::test_support {

/// Of what update() planned.
inline std::vector<std::uint8_t> drawn_pixels(HeadlessDisplay& headless) {
    headless.display().draw(headless.surface());
    const std::uint32_t width = headless.surface().width(), height = headless.surface().height();
    std::vector<std::uint8_t> rgba(std::size_t{width} * height * 4);
    EXPECT_TRUE(gl::read_pixels(headless.display().gl(), width, height, {rgba.data(), rgba.size()}));
    return rgba;
}

/// With all terrain arrived.
inline std::vector<std::uint8_t> settled_pixels(HeadlessDisplay& headless, const flight::AircraftState& state, base::Time now,
                                                const flight::PhaseStatus& phase = {}) {
    display::settle(headless.display(), {state, phase, now});
    headless.display().plan({state, phase, now});
    return drawn_pixels(headless);
}

}  // namespace tedavis::test_support
