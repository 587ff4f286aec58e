/// The text of a costs file, as `tedavis calibrate` writes it, in which every cost is the same, and whose only level is the
/// design's own picture.
#pragma once

#include <string>

#include "render_core/effects/calibration.hpp"
#include "render_core/effects/effect_table.hpp"

namespace tedavis::test_support {

inline std::string even_costs(const effects::CalibrationSubject& subject) {
    std::string text = "device = '" + std::string(subject.device.view()) + "'\nrenderer = '" +
                       std::string(subject.renderer.view()) + "'\nwidth_px = " + std::to_string(subject.width_px) +
                       "\nheight_px = " + std::to_string(subject.height_px) + "\n";
    const auto add = [&](std::string_view name) {
        text += "[cost." + std::string(name) + "]\nfixed_ms = 9\nms_per_megapixel = 0\nms_per_thousand = 0\n";
    };
    for (std::size_t n = 0; n < effects::kEffectCount; ++n) add(effects::row_of(static_cast<effects::Effect>(n)).name);
    for (const std::string_view name : effects::kOverheadNames) add(name);
    return text + "[[quality]]\ntau_factor = 1\ndetail_factor = 1\ngiven_up = []\nms = 9\nerror_px = 1\nerror_color = 0\n";
}

}  // namespace tedavis::test_support
