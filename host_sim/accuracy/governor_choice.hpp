/// The quality levels of a calibration file, and how often the governor chose each of them along a flight. Frames are planned in
/// the order of the flight, as in a replay, and are not drawn.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "host_sim/accuracy/knobs/knob_flight.hpp"
#include "host_sim/options/picture_options.hpp"
#include "render_core/effects/calibration.hpp"

namespace tedavis::host_sim {

struct GovernorChoice {
    std::string costs, device, renderer;  ///< the calibration file as it was named, and its device and renderer
    std::string flight;
    effects::QualityLevels levels;
    double deadline_ms = 0;
    std::array<std::uint64_t, effects::kQualityLevelCount> frames{};  ///< of the flight, at each level
    std::uint64_t missed = 0;                                         ///< frames whose modelled time exceeds the deadline
};

struct GovernorChoicePlan {
    std::optional<double> deadline_ms;  ///< nothing: the time of a frame at the device's rate
    double rate_hz = 10;                ///< of the planned frames
    /// Called after each tenth of the flight. It may throw.
    std::function<void(std::size_t done, std::size_t total)> progress;
};

/// Reads a calibration file. Throws UserError where it is not valid.
[[nodiscard]] effects::Calibration read_costs(const std::string& path);

/// `costs` is the path of a calibration file; terrain and scene are those of `picture`, device and size those of the file. Throws
/// UserError where the file is not valid, or was measured with another renderer.
[[nodiscard]] GovernorChoice governor_choice(const std::string& costs, const PictureOptions& picture, const KnobFlight& flight,
                                             const GovernorChoicePlan& plan);

}  // namespace tedavis::host_sim
