/// Reads the section [canny] of files that state the edge detector for clutter: sigma, low, high.
#pragma once

#include <optional>

#include "render_core/base/config_reader.hpp"
#include "render_core/perception/edge_detector.hpp"

namespace tedavis::host_sim {

/// Returns the settings; nothing where the file has no such section. Wrong values are reported as faults of the section.
[[nodiscard]] inline std::optional<perception::CannySettings> read_canny(base::ConfigSection& root) {
    base::ConfigSection section = root.section("canny");
    if (!section.present()) return std::nullopt;
    perception::CannySettings canny;
    canny.sigma = section.number("sigma", 0, perception::kMaxSigma);
    canny.low = section.number("low", 0, 32767);
    canny.high = section.number("high", 0, 32767);
    if (canny.low > canny.high) section.fault("low", "'low' must not be above 'high'");
    return canny;
}

}  // namespace tedavis::host_sim
