/// Finds where a run came closest to the terrain: between its frames too, in the track that the player plays once more.
#pragma once

#include <vector>

#include "host_sim/clearance/closest_points.hpp"
#include "host_sim/replay/flight_player.hpp"
#include "host_sim/replay/time_range.hpp"
#include "host_sim/reports/closest_json.hpp"
#include "render_core/display/planner/frame_record.hpp"

namespace tedavis::host_sim {

/// Samples the flight from one instant to another. They are as far apart as the aircraft needs for one post of the terrain, at
/// least 0.1 s and at most 1 s; of more than 200 000 samples' worth of time, farther. Instants without a valid position have
/// none.
[[nodiscard]] std::vector<TrackSample> flown_track(FlightPlayer& player, ClearanceMeter& meter, base::Time from, base::Time to);

/// The instants of the closest points between two instants, the closest first: the first `most` by height above the terrain, and
/// the first by distance to the ground. Plays the flight.
[[nodiscard]] std::vector<base::Time> closest_instants(FlightPlayer& player, ClearanceMeter& meter, const TimeRange& part,
                                                       std::size_t most);

class ClosestFinder {
public:
    explicit ClosestFinder(base::Time origin) : origin_(origin) {}

    /// Instants whose frames show a closest point, as closest_instants() finds them.
    void set_shown(std::vector<base::Time> instants) { shown_ = std::move(instants); }
    /// True for the frame of such an instant: its picture belongs into the report.
    [[nodiscard]] bool wants_picture(base::Time time) const;

    /// A frame of the run; `has_picture`: its picture is kept in the run's folder. `small_png` is for the report.
    void add(const display::FrameRecord& record, bool has_picture, std::string small_png);
    /// Searches from the earliest to the latest frame, and plays the flight for that.
    [[nodiscard]] ClosestReport find(FlightPlayer& player, ClearanceMeter& meter) const;

private:
    [[nodiscard]] double seconds(base::Time time) const { return (time - origin_).to_seconds(); }
    [[nodiscard]] StatedClosest stated(const ClosestPoint& point, FlightPlayer& player) const;

    base::Time origin_;
    std::vector<base::Time> shown_;
    std::vector<FrameBeside> frames_;
};

}  // namespace tedavis::host_sim
