/// Counts the terrain alerts of a run, and how many of them the flight did not confirm.
///
/// An alert is a sequence of consecutive frames with a caution or warning. A frame of it is confirmed if the track that was flown
/// afterwards, within 60 s (for a warning within 30 s), was lower over the true surface than the clearance that the frame
/// required. An alert without a confirmed frame is false. Track after a landing, or where the alert is inhibited, does not count;
/// track beyond the end of the run is taken as clear. A pilot who turns away makes an alert false, so most false alerts were not
/// needless.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host_sim/reports/alert_hindrance.hpp"
#include "render_core/display/planner/frame_record.hpp"

namespace tedavis::host_sim {

struct TerrainAlertCounts {
    double hours = 0;  ///< of the run
    double seconds_caution = 0, seconds_warning = 0;
    std::uint64_t count = 0, false_count = 0;        ///< alerts of either level
    std::uint64_t warnings = 0, false_warnings = 0;  ///< alerts with a frame of level warning

    /// Frames and hours by AlertHindrance; with `none`, alerts were possible. The sum of `hours_by` is `hours`.
    std::array<std::uint64_t, kAlertHindranceCount> frames_by{};
    std::array<double, kAlertHindranceCount> hours_by{};
    bool has_gaps = false;  ///< frames are so far apart that `hours` is not the whole run

    [[nodiscard]] std::uint64_t frames() const;
    [[nodiscard]] std::uint64_t possible_frames() const { return frames_by[0]; }
    [[nodiscard]] double possible_hours() const { return hours_by[0]; }

    [[nodiscard]] double false_per_hour() const { return hours > 0 ? static_cast<double>(false_count) / hours : 0; }
};

class AlertTally {
public:
    /// Adds a frame. A frame that is not later than the one before is ignored.
    void add(const display::FrameRecord& record);
    [[nodiscard]] TerrainAlertCounts counts() const;

private:
    struct Frame {
        double time_s = 0, height_m = 0, clearance_m = 0;
        policy::TerrainAhead level = policy::TerrainAhead::none;
        bool is_watching = false;
        AlertHindrance hindrance = AlertHindrance::none;
    };
    [[nodiscard]] double seconds_of(std::size_t n) const;
    [[nodiscard]] bool is_confirmed(std::size_t n, double within_s) const;
    void count_time(TerrainAlertCounts& counts) const;
    void count_alert(std::size_t begin, std::size_t end, TerrainAlertCounts& counts) const;

    std::vector<Frame> frames_;
};

}  // namespace tedavis::host_sim
