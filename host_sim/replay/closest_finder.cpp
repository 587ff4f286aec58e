#include "host_sim/replay/closest_finder.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/calendar_time.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

using flight::Signal;

constexpr double kShortestStep_s = 0.1, kLongestStep_s = 1, kMaxSamples = 200'000;

std::string tenths_text(base::Time utc) {
    constexpr std::int64_t kSecond = 1'000'000'000;
    std::string text = utc_text(utc);
    const std::int64_t within = (utc.ns % kSecond + kSecond) % kSecond;
    return text.insert(text.size() - 1, "." + std::to_string(within / (kSecond / 10)));
}

TrackSample sample_of(const flight::FrameInput& input, const OwnShipPlace& own, ClearanceMeter& meter) {
    TrackSample sample;
    sample.time = input.time;
    sample.own = own;
    sample.height_above_terrain_m = meter.height_above_terrain_m(own);
    sample.uncertainty = meter.uncertainty_of(input.state, input.time);
    sample.phase = input.phase.phase;
    sample.is_on_ground =
        stands_on_ground(sample.phase, input.state[Signal::ground_speed].value_or(0), sample.height_above_terrain_m);
    return sample;
}

}  // namespace

std::vector<TrackSample> flown_track(FlightPlayer& player, ClearanceMeter& meter, base::Time from, base::Time to) {
    const double post_m = base::radians(meter.database().header().step_lat_deg) * earth::kMeanRadius_m;
    const double shortest_s = std::min(std::max(kShortestStep_s, (to - from).to_seconds() / kMaxSamples), 5.0);
    std::vector<TrackSample> track;
    for (base::Time time = from; time <= to;) {
        const flight::FrameInput input = player.at(time);
        if (const auto own = meter.place_of(input.state.own_ship)) {
            TrackSample sample = sample_of(input, *own, meter);
            sample.time = time;
            if (!track.empty())
                sample.along_m = track.back().along_m + earth::surface_distance_m(track.back().own.place, own->place);
            track.push_back(sample);
        }
        const double speed_mps = std::max(input.state[Signal::ground_speed].value_or(0), 1.0);
        const double step_s = std::max(std::min(post_m / speed_mps, kLongestStep_s), shortest_s);
        const base::Time next = time + base::Duration::from_seconds(step_s);
        time = time < to && next > to ? to : next;
    }
    return track;
}

std::vector<base::Time> closest_instants(FlightPlayer& player, ClearanceMeter& meter, const TimeRange& part, std::size_t most) {
    const ClosestPoints points = closest_points(flown_track(player, meter, part.from, part.to), meter);
    std::vector<base::Time> instants;
    for (std::size_t n = 0; n < std::min(most, points.by_height.size()); ++n) instants.push_back(points.by_height[n].sample.time);
    if (!points.by_distance.empty()) instants.push_back(points.by_distance.front().sample.time);
    return instants;
}

bool ClosestFinder::wants_picture(base::Time time) const {
    constexpr std::int64_t kSameFrame_ns = 1000;
    return std::any_of(shown_.begin(), shown_.end(), [&](base::Time one) { return std::abs((one - time).ns) <= kSameFrame_ns; });
}

void ClosestFinder::add(const display::FrameRecord& record, bool has_picture, std::string small_png) {
    FrameBeside frame{record.frame, seconds(record.time), record.alerts.terrain, std::string(record.design.view()),
                      {},           std::move(small_png)};
    if (has_picture) frame.picture = frame_picture_path(".", record.frame).substr(2);
    frames_.push_back(frame);
}

StatedClosest ClosestFinder::stated(const ClosestPoint& point, FlightPlayer& player) const {
    StatedClosest closest{point, seconds(point.sample.time), {}, {}};
    const flight::FrameInput input = player.at(point.sample.time);
    const flight::FlightTime time = flight::flight_time(input.state.utc, point.sample.time);
    if (time.is_date) closest.utc = tenths_text(time.utc);
    closest.frame = *std::min_element(frames_.begin(), frames_.end(), [&](const FrameBeside& a, const FrameBeside& b) {
        return std::fabs(a.time_s - closest.time_s) < std::fabs(b.time_s - closest.time_s);
    });
    return closest;
}

ClosestReport ClosestFinder::find(FlightPlayer& player, ClearanceMeter& meter) const {
    ClosestReport report;
    if (frames_.empty()) return report;
    const auto [first, last] = std::minmax_element(
        frames_.begin(), frames_.end(), [](const FrameBeside& a, const FrameBeside& b) { return a.time_s < b.time_s; });
    const base::Time from = origin_ + base::Duration::from_seconds(first->time_s),
                     to = origin_ + base::Duration::from_seconds(last->time_s);
    report.is_searched = true;
    report.track = flown_track(player, meter, from, to);
    const std::vector<bool> counts = counted_samples(report.track);
    report.unknown_s = (to - from).to_seconds();
    for (std::size_t n = 0; n + 1 < report.track.size(); ++n) {
        const double step_s = (report.track[n + 1].time - report.track[n].time).to_seconds();
        if (step_s > kLongestGap_s) continue;
        report.sample_step_s = std::max(report.sample_step_s, step_s);
        const bool is_known = !std::isnan(report.track[n].height_above_terrain_m);
        report.unknown_s -= is_known ? step_s : 0;
        report.left_out_s += is_known && !counts[n] ? step_s : 0;
    }
    const ClosestPoints points = closest_points(report.track, meter);
    for (const ClosestPoint& point : points.by_height) report.by_height.push_back(stated(point, player));
    for (const ClosestPoint& point : points.by_distance) report.by_distance.push_back(stated(point, player));
    return report;
}

}  // namespace tedavis::host_sim
