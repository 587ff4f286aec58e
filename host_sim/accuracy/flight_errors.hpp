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
#include "host_sim/accuracy/knobs/terrain_tau_knob.hpp"

namespace tedavis::host_sim {

/// How much of the proven bound the measured error is, over frames: 0 .. 1, above 1 where the bound is broken. Frames whose bound
/// is too small to be measured do not count.
struct Tightness {
    double median = 0, max = 0;
};

/// A frame of the flight, drawn with the tolerance of the design.
struct MeasuredMoment {
    double time_s = 0;                      ///< since the flight's begin
    double proven_px = 0, measured_px = 0;  ///< measured: the greatest of the frame's samples
    double ms = 0;
    std::uint64_t samples = 0;  ///< places of the ground
    std::string pose;           ///< as `--pose` of `tedavis shot` takes it
    std::string phase = {};     ///< " --phase P" of it; empty: none
};

/// One tolerance over all frames.
struct ToleranceLine {
    double asked_px = 0;
    double proven_px = 0, measured_px = 0;  ///< the greatest
    std::uint64_t samples = 0, broken = 0;  ///< broken: samples above the bound of their frame
    Tightness tightness = {};               ///< of the frames
};

struct FlightErrors {
    std::string flight, terrain;
    std::uint64_t identity = 0;               ///< RecordedPoses::identity; 0: the shipped flight
    std::uint64_t terrain_identity = 0;       ///< of the heights (replay/index_key.hpp)
    std::string drawn = {};                   ///< options of `tedavis shot` besides pose, phase and tolerance
    double asked_px = 0;                      ///< of the moments
    double known_to_px = kSeenErrorBound_px;  ///< what a measured error may be wrong by
    std::vector<MeasuredMoment> moments;
    std::vector<ToleranceLine> lines;  ///< from the coarsest

    [[nodiscard]] bool holds() const;             ///< no sample was above its bound
    [[nodiscard]] std::uint64_t samples() const;  ///< of all frames
    [[nodiscard]] Tightness tightness() const;    ///< of the moments
};

struct FlightErrorsPlan {
    std::size_t moments = 24, line_poses = 6;  ///< frames; those that show no ground are left out
    std::uint32_t across = SeenGrid().across;  ///< places over the width of a frame
    /// Called before each frame. It may throw.
    std::function<void(std::size_t done, std::size_t total)> progress;
};

/// Those of the ground's flight over its heights, among others; null where there are none.
[[nodiscard]] const FlightErrors* errors_over(const KnobGround& ground, const std::vector<FlightErrors>& flights);

/// Those of all grounds that are among others, each once: what an earlier run leaves for a run over these.
[[nodiscard]] std::vector<FlightErrors> errors_over(const std::vector<KnobGround>& grounds,
                                                    const std::vector<FlightErrors>& flights);

/// Along the flight of the ground, drawn with its display. Throws UserError.
[[nodiscard]] FlightErrors measure_flight_errors(const KnobGround& ground, const FlightErrorsPlan& plan);

}  // namespace tedavis::host_sim
