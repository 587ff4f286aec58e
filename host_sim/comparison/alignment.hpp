/// Says which moment of one run belongs to which moment of another one.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/comparison/compared_run.hpp"

namespace tedavis::host_sim {

enum class Alignment {
    time,    ///< of the same log, else UTC, else seconds since each log began
    place,   ///< the nearest place on the other track, without going back
    takeoff  ///< seconds since take-off
};

/// A frame of run A and its counterpart.
struct AlignedInstant {
    std::size_t a = 0;      ///< index of the frame
    double b = 0;           ///< in the frames of B: 3.25 is a quarter of the way from its frame 3 to its frame 4
    double axis = 0;        ///< place on the horizontal axis of charts
    double distance_m = 0;  ///< between both places along the ground; NaN where one is not known

    [[nodiscard]] std::size_t nearest_b() const { return static_cast<std::size_t>(std::lround(b)); }
};

struct AlignedRuns {
    Alignment by = Alignment::time;
    std::string words;                     ///< by what they are aligned, in a sentence
    std::string axis;                      ///< "time of the log", for charts
    std::string axis_unit;                 ///< "s", "km"
    std::vector<AlignedInstant> instants;  ///< in the order of A's frames; at least one
    /// 1 where every frame is looked at, 2 where every second one is, as by place in long runs.
    std::size_t stride_a = 1, stride_b = 1;
    std::size_t searched = 0;  ///< frames of A that were looked at, with a counterpart or without one
};

inline constexpr double kWithin_m = 3000;
struct AlignmentRequest {
    std::optional<Alignment> by;  ///< nothing: by time where the runs share one, else by place, else by take-off
    /// Places farther apart are no counterparts; above 0. Nothing: kWithin_m. Refused beside an alignment that is not by place.
    std::optional<double> within_m;
};

/// "time", "place", "takeoff".
[[nodiscard]] const char* name_of(Alignment by);
/// True where both are the same folder or show the same log: by its content where both logs are still there, else by its path, or
/// by its number of frames and the UTC of its begin.
[[nodiscard]] bool is_same_flight(const ComparedRun& a, const ComparedRun& b);
/// The index of the first frame of take-off: of the phase, where the run shows its begin, else of the ground speed between
/// frames, which rises above 20 m/s after it was below 15 m/s. Nothing where there is none.
[[nodiscard]] std::optional<std::size_t> takeoff_frame(const ComparedRun& run);
/// Throws UserError where no frame of A has a counterpart; the sentence names those alignments alone that these runs have.
[[nodiscard]] AlignedRuns aligned(const ComparedRun& a, const ComparedRun& b, const AlignmentRequest& request);

/// The value at a moment of a run that may lie between two frames: of what is flown it is interpolated, else it is the nearest
/// frame's.
[[nodiscard]] double value_at(const ComparedRun& run, double position, std::size_t quantity);

}  // namespace tedavis::host_sim
