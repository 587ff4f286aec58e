/// The inputs of `tedavis accuracy`: for each --flight its heights and poses.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/accuracy/knobs/knob_ground.hpp"
#include "host_sim/commands/accuracy.hpp"

namespace tedavis::host_sim {

/// The heights and the recorded flight of a --flight, or of a run without one.
struct MeasuredFlight {
    std::shared_ptr<TracedGround> ground;
    std::optional<RecordedPoses> recorded;  ///< nothing: the shipped flight
    std::string terrain;                    ///< as the user named it

    [[nodiscard]] KnobGround knob_ground(const AccuracyOptions& options) const {
        return {*ground, options.is_quick, recorded ? &*recorded : nullptr, options.display};
    }
};

/// Throws UserError where --terrain, --flight and --switches do not belong together.
void require_pairs(const AccuracyOptions& options);

/// Reads the flights, and the heights of each terrain once into memory. Knobs fly the first flight. Throws UserError and
/// Interrupted.
[[nodiscard]] std::vector<MeasuredFlight> read_flights(const AccuracyOptions& options, base::Workers& workers, Console& console);

}  // namespace tedavis::host_sim
