/// A file of costs, as `tedavis calibrate` writes it, in which every cost is the same.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "render_core/display/calibration_subject.hpp"
#include "render_core/effects/effect_table.hpp"
#include "target/board_display.hpp"

namespace tedavis::target {

inline std::string costs_of(const BoardSettings& settings, const std::string& renderer) {
    std::string text = "device = '" + std::string(settings.device.name.view()) + "'\nrenderer = '" + renderer +
                       "'\nwidth_px = " + std::to_string(settings.width_px) +
                       "\nheight_px = " + std::to_string(settings.height_px) + "\n";
    const auto line = [&](std::string_view name) {
        text += "[cost." + std::string(name) + "]\nfixed_ms = 9\nms_per_megapixel = 0\nms_per_thousand = 0\n";
    };
    for (std::size_t n = 0; n < effects::kEffectCount; ++n) line(effects::row_of(static_cast<effects::Effect>(n)).name);
    for (const std::string_view name : effects::kOverheadNames) line(name);
    return text;
}

inline std::string costs_of_this_board(const BoardSettings& settings) {
    BoardDisplay board(settings);
    EXPECT_TRUE(board.open_surface().message.empty() && !board.start());
    return costs_of(settings, std::string(display::calibration_subject(board.core()).renderer.view()));
}

}  // namespace tedavis::target
