/// Finds where a run came closest to the terrain, also between its frames: the player plays the flight once more.
#pragma once

#include <vector>

#include "host_sim/clearance/closest_points.hpp"
#include "host_sim/replay/flight_player.hpp"
#include "host_sim/replay/time_range.hpp"
#include "host_sim/reports/closest_json.hpp"
#include "render_core/display/planner/frame_record.hpp"

namespace tedavis::host_sim {

/// Samples the flight between two times. The step is the time in which the aircraft passes one post of the terrain, at least 0.1
/// s (in flights of more than 20,000 s their 200,000th part) and at most 1 s. Times without a valid position have no sample.
[[nodiscard]] std::vector<TrackSample> flown_track(FlightPlayer& player, ClearanceMeter& meter, base::Time from, base::Time to);

/// Returns the times of the closest points in a part of the flight: the `most` lowest by height above the terrain, the lowest
/// first, then the nearest by distance to the ground. Plays the flight.
[[nodiscard]] std::vector<base::Time> closest_instants(FlightPlayer& player, ClearanceMeter& meter, const TimeRange& part,
                                                       std::size_t most);

class ClosestFinder {
public:
    explicit ClosestFinder(base::Time origin) : origin_(origin) {}

    /// Sets the times whose frames show a closest point, as closest_instants() returns them.
    void set_shown(std::vector<base::Time> instants) { shown_ = std::move(instants); }
    /// True for the frame at one of these times, whose picture is part of the report.
    [[nodiscard]] bool wants_picture(base::Time time) const;

    /// Adds a frame of the run. `has_picture`: its picture is in the run's folder. `small_png` is the picture for the report.
    void add(const display::FrameRecord& record, bool has_picture, std::string small_png);
    /// Searches between the earliest and the latest frame; plays the flight.
    [[nodiscard]] ClosestReport find(FlightPlayer& player, ClearanceMeter& meter) const;

private:
    [[nodiscard]] double seconds(base::Time time) const { return (time - origin_).to_seconds(); }
    [[nodiscard]] StatedClosest stated(const ClosestPoint& point, FlightPlayer& player) const;

    base::Time origin_;
    std::vector<base::Time> shown_;
    std::vector<FrameBeside> frames_;
};

}  // namespace tedavis::host_sim
