/// Assigns to each time of one run a time of another one.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/comparison/compared_run.hpp"

namespace tedavis::host_sim {

enum class Alignment {
    time,    ///< time of the same log, else UTC, else seconds since each log began
    place,   ///< the nearest place on the other track, without going back
    takeoff  ///< seconds since take-off
};

/// A frame of run A and its counterpart.
struct AlignedInstant {
    std::size_t a = 0;      ///< index of the frame
    double b = 0;           ///< fractional index in the frames of B: 3.25 is a quarter of the way from its frame 3 to its frame 4
    double axis = 0;        ///< coordinate on the horizontal axis of charts
    double distance_m = 0;  ///< distance along the ground between both positions; NaN where one is not known

    [[nodiscard]] std::size_t nearest_b() const { return static_cast<std::size_t>(std::lround(b)); }
};

struct AlignedRuns {
    Alignment by = Alignment::time;
    std::string words;                     ///< description of the alignment, in a sentence
    std::string axis;                      ///< "time of the log", for charts
    std::string axis_unit;                 ///< "s", "km"
    std::vector<AlignedInstant> instants;  ///< in the order of A's frames; at least one
    /// 1: every frame is compared; 2: every second one, as in long runs that are aligned by place.
    std::size_t stride_a = 1, stride_b = 1;
    std::size_t searched = 0;  ///< frames of A that were searched, with or without a counterpart
};

inline constexpr double kWithin_m = 3000;
struct AlignmentRequest {
    std::optional<Alignment> by;  ///< nothing: by time where the runs share one, else by place, else by take-off
    /// Largest distance of counterparts, above 0; nothing: kWithin_m. Refused where `by` is another alignment than place.
    std::optional<double> within_m;
};

/// "time", "place", "takeoff".
[[nodiscard]] const char* name_of(Alignment by);
/// True if both are the same folder or show the same log. Logs are compared by content if both still exist, else by path, or by
/// the number of frames and the UTC of the begin.
[[nodiscard]] bool is_same_flight(const ComparedRun& a, const ComparedRun& b);
/// Returns the index of the first frame of take-off: of the phase, if the run contains its begin, else of the first ground speed
/// above 20 m/s after one below 15 m/s. The speed is computed from the positions of frames. Nothing where there is none.
[[nodiscard]] std::optional<std::size_t> takeoff_frame(const ComparedRun& run);
/// Throws UserError where no frame of A has a counterpart; the message names the alignments that are possible for these runs.
[[nodiscard]] AlignedRuns aligned(const ComparedRun& a, const ComparedRun& b, const AlignmentRequest& request);

/// Returns a quantity at a fractional frame index: interpolated if Quantity::is_flown, else that of the nearest frame.
[[nodiscard]] double value_at(const ComparedRun& run, double position, std::size_t quantity);

}  // namespace tedavis::host_sim
