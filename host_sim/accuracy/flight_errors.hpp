/// The error of the drawn terrain along a flight, in pixels: the requested tolerance, the bound that the display proved, and the
/// measured error, for each frame and for each of several tolerances.
///
/// The proven bound (FrameRecord's worst_error_px) must never be below the measured error. The closer it is, the tighter it is.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host_sim/accuracy/knobs/knob_flight.hpp"
#include "host_sim/accuracy/knobs/terrain_tau_knob.hpp"

namespace tedavis::host_sim {

/// The ratio of the measured error to the proven bound, over frames: 0..1, above 1 where the bound does not hold. Frames whose
/// bound is too small to be measured do not count.
struct Tightness {
    double median = 0, max = 0;
};

/// A frame of the flight, drawn with the tolerance of the design.
struct MeasuredMoment {
    double time_s = 0;                      ///< since the flight's begin
    double proven_px = 0, measured_px = 0;  ///< measured: the greatest of the frame's samples
    double ms = 0;
    std::uint64_t samples = 0;  ///< points of the ground where the error was measured
    std::string pose;           ///< as `--pose` of `tedavis shot` takes it
    std::string phase = {};     ///< its option of `tedavis shot`, " --phase P"; empty: no phase
};

/// The result of one tolerance, over all frames.
struct ToleranceLine {
    double asked_px = 0;
    double proven_px = 0, measured_px = 0;  ///< the largest of all frames
    std::uint64_t samples = 0, broken = 0;  ///< broken: samples above the bound of their frame
    Tightness tightness = {};               ///< of the frames
};

struct FlightErrors {
    std::string flight, terrain;
    std::uint64_t identity = 0;               ///< RecordedPoses::identity; 0: the shipped flight
    std::uint64_t terrain_identity = 0;       ///< of the heights (replay/index_key.hpp)
    std::string drawn = {};                   ///< options of `tedavis shot` besides pose, phase and tolerance
    double asked_px = 0;                      ///< tolerance of the moments: the design's
    double known_to_px = kSeenErrorBound_px;  ///< upper bound of the error of a measured error
    std::vector<MeasuredMoment> moments;
    std::vector<ToleranceLine> lines;  ///< the largest tolerance first

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

/// Returns the element of `flights` that was measured along the flight of `ground` and over its heights; null if there is none.
[[nodiscard]] const FlightErrors* errors_over(const KnobGround& ground, const std::vector<FlightErrors>& flights);

/// Returns the elements of `flights` that belong to one of `grounds`, each once: a run over these grounds reuses what an earlier
/// run measured.
[[nodiscard]] std::vector<FlightErrors> errors_over(const std::vector<KnobGround>& grounds,
                                                    const std::vector<FlightErrors>& flights);

/// Measures the errors along the ground's flight, drawn with the ground's display. Throws UserError.
[[nodiscard]] FlightErrors measure_flight_errors(const KnobGround& ground, const FlightErrorsPlan& plan);

}  // namespace tedavis::host_sim
