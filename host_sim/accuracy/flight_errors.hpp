/// The terrain's error along a flight, and the three lines of its tolerance: what was asked for, what the display proved for each
/// frame, and what was measured.
///
/// The proven bound (FrameRecord's worst_error_px) must never be below the measured error. How far above it lies says how tight
/// it is.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host_sim/accuracy/knobs/knob_flight.hpp"
#include "host_sim/tracing/traced_ground.hpp"

namespace tedavis::host_sim {

/// A frame of the flight, drawn with the tolerance of the design.
struct MeasuredMoment {
    double time_s = 0;                      ///< since the flight's begin
    double proven_px = 0, measured_px = 0;  ///< measured: the greatest of the frame's samples
    double ms = 0;
    std::uint64_t samples = 0;  ///< places of the ground
    std::string pose;           ///< as `--pose` of `tedavis shot` takes it
};

/// One tolerance over all frames.
struct ToleranceLine {
    double asked_px = 0;
    double proven_px = 0, measured_px = 0;  ///< the greatest
    std::uint64_t samples = 0, broken = 0;  ///< broken: samples above the bound of their frame
};

struct FlightErrors {
    std::string flight, terrain;
    double asked_px = 0;  ///< of the moments
    std::vector<MeasuredMoment> moments;
    std::vector<ToleranceLine> lines;  ///< from the coarsest

    [[nodiscard]] bool holds() const;  ///< no sample was above its bound
};

struct FlightErrorsPlan {
    std::size_t moments = 24, line_poses = 6;  ///< frames; those that show no ground are left out
    /// Called before each frame. It may throw.
    std::function<void(std::size_t done, std::size_t total)> progress;
};

[[nodiscard]] FlightErrors measure_flight_errors(const TracedGround& ground, const KnobFlight& flight,
                                                 const FlightErrorsPlan& plan);

}  // namespace tedavis::host_sim
