#include "host_sim/comparison/alignment.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "host_sim/calendar_time.hpp"
#include "host_sim/comparison/place_alignment.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kSameTime_s = 1e-3;
constexpr double kUsualSteps = 4;  // frames farther apart than so many steps have a gap between them

std::vector<double> times_of(const ComparedRun& run, double minus_s) {
    std::vector<double> times_s;
    for (const ComparedFrame& frame : run.frames) times_s.push_back(frame.time_s - minus_s);
    return times_s;
}

/// Where in the ascending times one lies; nothing outside them and in their gaps.
std::optional<double> position_of(double time_s, const std::vector<double>& times_s, double longest_s) {
    const auto after = std::lower_bound(times_s.begin(), times_s.end(), time_s - kSameTime_s);
    if (after == times_s.end()) return std::nullopt;
    const auto next = static_cast<std::size_t>(after - times_s.begin());
    if (std::abs(*after - time_s) <= kSameTime_s) return static_cast<double>(next);
    if (next == 0) return std::nullopt;
    const double before_s = times_s[next - 1], step_s = *after - before_s;
    if (step_s > longest_s) return std::nullopt;
    return static_cast<double>(next - 1) + (time_s - before_s) / step_s;
}

double distance_between(const ComparedFrame& frame, const ComparedRun& other, double position) {
    const auto first = static_cast<std::size_t>(position);
    const std::size_t second = std::min(first + 1, other.frames.size() - 1);
    const ComparedFrame &from = other.frames[first], &to = other.frames[second];
    if (!frame.has_place || !from.has_place || !to.has_place) return std::nan("");
    const double share = position - static_cast<double>(first);
    double east_deg = to.longitude_deg - from.longitude_deg;
    if (std::abs(east_deg) > 180) east_deg -= std::copysign(360.0, east_deg);
    return ground_distance_m(frame.latitude_deg, frame.longitude_deg,
                             from.latitude_deg + share * (to.latitude_deg - from.latitude_deg),
                             from.longitude_deg + share * east_deg);
}

std::vector<AlignedInstant> instants_by_time(const ComparedRun& a, const ComparedRun& b, double minus_a_s, double minus_b_s) {
    const std::vector<double> times_a_s = times_of(a, minus_a_s), times_b_s = times_of(b, minus_b_s);
    const double longest_s = kUsualSteps * median_step_s(b);
    std::vector<AlignedInstant> instants;
    for (std::size_t n = 0; n < times_a_s.size(); ++n)
        if (const auto position = position_of(times_a_s[n], times_b_s, longest_s))
            instants.push_back({n, *position, times_a_s[n], distance_between(a.frames[n], b, *position)});
    return instants;
}

std::string utc_span_words(const ComparedRun& run, double offset_s) {
    const auto text = [&](const ComparedFrame& frame) {
        return utc_text(base::Time{} + base::Duration::from_seconds(frame.time_s + offset_s));
    };
    return "from " + text(run.frames.front()) + " to " + text(run.frames.back());
}

/// An alignment, or why there is none.
struct Attempt {
    std::optional<AlignedRuns> runs;
    std::string why;
};

Attempt unless_empty(AlignedRuns runs, const std::string& why) {
    if (runs.instants.empty()) return {std::nullopt, why};
    return {std::move(runs), {}};
}

/// Of runs that do not show the same log.
Attempt by_time_of_day(const ComparedRun& a, const ComparedRun& b) {
    const std::optional<double> utc_a_s = utc_offset_s(a), utc_b_s = utc_offset_s(b);
    if (utc_a_s.has_value() != utc_b_s.has_value())
        return {std::nullopt, (utc_a_s ? b : a).folder + " does not know the date, so that the runs share no time"};
    AlignedRuns runs{Alignment::time, "The runs are aligned by the time of day (UTC)", "time of A", "s", {}};
    if (!utc_a_s) {
        runs.words = "The logs know no date, so that the runs are aligned by the seconds since each log began";
        runs.instants = instants_by_time(a, b, 0, 0);
        return unless_empty(std::move(runs), "the runs share no time since their logs began");
    }
    runs.instants = instants_by_time(a, b, 0, *utc_a_s - *utc_b_s);
    return unless_empty(std::move(runs), "the runs share no time: " + a.folder + " is " + utc_span_words(a, *utc_a_s) + ", " +
                                             b.folder + " " + utc_span_words(b, *utc_b_s));
}

Attempt by_time(const ComparedRun& a, const ComparedRun& b) {
    if (!is_same_flight(a, b)) return by_time_of_day(a, b);
    return unless_empty({Alignment::time, "The runs show the same log and are aligned by its time", "time of the log", "s",
                         instants_by_time(a, b, 0, 0)},
                        "the frames of " + a.folder + " and " + b.folder +
                            " share no time of their log; replays with the same --from, --to and --step do");
}

Attempt by_takeoff(const ComparedRun& a, const ComparedRun& b) {
    const std::optional<std::size_t> off_a = takeoff_frame(a), off_b = takeoff_frame(b);
    if (!off_a && !off_b) return {std::nullopt, "neither " + a.folder + " nor " + b.folder + " shows a take-off"};
    if (!off_a || !off_b) return {std::nullopt, (off_a ? b : a).folder + " shows no take-off"};
    const double a_s = a.frames[*off_a].time_s, b_s = b.frames[*off_b].time_s;
    return unless_empty({Alignment::takeoff,
                         "The runs are aligned by the seconds since take-off, which was at " + frame_time_words(a, a_s) +
                             " in A and at " + frame_time_words(b, b_s) + " in B",
                         "time since take-off", "s", instants_by_time(a, b, a_s, b_s)},
                        "no frame of " + a.folder + " and " + b.folder + " is equally long after take-off");
}

/// Frames with a place, thinned where there are too many for the search.
struct PlacedFrames {
    std::vector<std::size_t> frames;  // indices of frames of the run
    std::vector<TrackPlace> track;
    std::size_t stride = 1;  // 2 where every second frame was looked at
};

PlacedFrames placed_frames(const ComparedRun& run) {
    constexpr std::size_t kMaxPlaces = 4000;
    PlacedFrames placed;
    const std::size_t stride = placed.stride = run.frames.size() / kMaxPlaces + 1;
    const double longest_s = kUsualSteps * median_step_s(run) * static_cast<double>(stride);
    for (std::size_t n = 0; n < run.frames.size(); n += stride) {
        const ComparedFrame& frame = run.frames[n];
        if (!placed.frames.empty()) {
            const bool is_next = placed.frames.back() + stride == n;
            const double step_s = frame.time_s - run.frames[placed.frames.back()].time_s;
            placed.track.back().joins_next = frame.has_place && is_next && step_s <= longest_s;
        }
        if (!frame.has_place) continue;
        placed.frames.push_back(n);
        placed.track.push_back({frame.latitude_deg, frame.longitude_deg, false});
    }
    return placed;
}

double nearest_places_m(const PlacedFrames& a, const PlacedFrames& b) {
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const TrackPlace& from : a.track)
        for (const TrackPlace& to : b.track)
            nearest_m =
                std::min(nearest_m, ground_distance_m(from.latitude_deg, from.longitude_deg, to.latitude_deg, to.longitude_deg));
    return nearest_m;
}

/// On the track that was searched, to the frames of the run.
double position_in_frames(const PlacedFrames& placed, double along) {
    const auto first = static_cast<std::size_t>(along);
    const auto frame = static_cast<double>(placed.frames[first]);
    if (first + 1 == placed.frames.size()) return frame;
    return frame + (along - static_cast<double>(first)) * (static_cast<double>(placed.frames[first + 1]) - frame);
}

std::string why_no_places(const ComparedRun& a, const ComparedRun& b, double within_m) {
    const PlacedFrames placed_a = placed_frames(a), placed_b = placed_frames(b);
    if (placed_a.track.empty() || placed_b.track.empty())
        return (placed_a.track.empty() ? a : b).folder + " has no frame with a valid position";
    return "the frames of the runs come no nearer than " + decimal(nearest_places_m(placed_a, placed_b) / 1000, 1) +
           " km to one another, and counterparts are at most " + decimal(within_m / 1000, 1) + " km apart";
}

std::optional<AlignedRuns> by_place(const ComparedRun& a, const ComparedRun& b, double within_m) {
    const PlacedFrames placed_a = placed_frames(a), placed_b = placed_frames(b);
    const auto pairs = paired_places(placed_a.track, placed_b.track, within_m);
    AlignedRuns runs{
        Alignment::place,
        "The runs are aligned by place: beside each frame of A stands the nearest place of the track of B, in the order "
        "of the flight and at most " +
            decimal(within_m / 1000, 1) + " km away",
        "distance along the track of A",
        "km",
        {},
        placed_a.stride,
        placed_b.stride};
    double along_m = 0;
    for (std::size_t n = 0; n < pairs.size(); ++n) {
        const TrackPlace& here = placed_a.track[n];
        if (n > 0)
            along_m += ground_distance_m(placed_a.track[n - 1].latitude_deg, placed_a.track[n - 1].longitude_deg,
                                         here.latitude_deg, here.longitude_deg);
        if (!pairs[n]) continue;
        runs.instants.push_back(
            {placed_a.frames[n], position_in_frames(placed_b, pairs[n]->along), along_m / 1000, pairs[n]->distance_m});
    }
    if (runs.instants.empty()) return std::nullopt;
    return runs;
}

/// In metres, rounded up; nothing where no limit that may be given makes the runs meet.
std::optional<long> within_that_fits(const ComparedRun& a, const ComparedRun& b) {
    constexpr double kRoom = 1.1, kRounded_m = 100, kGreatest_m = 1e6;
    const double nearest_m = nearest_places_m(placed_frames(a), placed_frames(b));
    if (!(nearest_m * kRoom + kRounded_m < kGreatest_m)) return std::nullopt;
    const double within_m = std::ceil(nearest_m * kRoom / kRounded_m) * kRounded_m;
    if (!by_place(a, b, within_m)) return std::nullopt;
    return std::lround(within_m);
}

/// Which alignments these runs have, besides the one that failed.
std::string what_fits(const ComparedRun& a, const ComparedRun& b, double within_m) {
    std::string names;
    const auto add = [&names](const std::string& name) { names += (names.empty() ? "--align " : " or --align ") + name; };
    if (by_time(a, b).runs) add("time");
    if (by_place(a, b, within_m))
        add("place");
    else if (const auto fitting_m = within_that_fits(a, b))
        add("place --within " + std::to_string(*fitting_m));
    if (by_takeoff(a, b).runs) add("takeoff");
    return names.empty() ? "no other --align aligns these runs either; name another run" : names + " aligns them";
}

/// Runs of different flights of which neither knows the date share no time, though an alignment by it may be asked for.
std::optional<AlignedRuns> by_what_is_shared(const ComparedRun& a, const ComparedRun& b, double within_m) {
    if (is_same_flight(a, b) || utc_offset_s(a) || utc_offset_s(b))
        if (auto runs = by_time(a, b).runs) return runs;
    if (auto runs = by_place(a, b, within_m)) return runs;
    return by_takeoff(a, b).runs;
}

/// Of logs that are gone. The same path is taken for the same log.
bool has_same_log_by_summary(const ComparedRun& a, const ComparedRun& b) {
    if (!a.log.empty() && a.log == b.log) return true;
    const std::optional<double> utc_a_s = utc_offset_s(a), utc_b_s = utc_offset_s(b);
    return a.can_frames && a.can_frames == b.can_frames && utc_a_s && utc_b_s && std::abs(*utc_a_s - *utc_b_s) <= kSameTime_s;
}

bool is_takeoff(const ComparedFrame& frame) { return frame.phase.rfind("takeoff", 0) == 0; }

/// A run that begins during the climb shows a take-off, but not when it was.
std::optional<std::size_t> takeoff_by_phase(const ComparedRun& run) {
    if (run.frames.front().phase == "takeoff.start") return 0;
    for (std::size_t n = 1; n < run.frames.size(); ++n) {
        const ComparedFrame &before = run.frames[n - 1], &here = run.frames[n];
        if (!is_takeoff(here) || is_takeoff(before)) continue;
        if (knows_phase(before) || here.phase == "takeoff.start") return n;
    }
    return std::nullopt;
}

Attempt aligned_as_asked(const ComparedRun& a, const ComparedRun& b, Alignment by, double within_m) {
    if (by == Alignment::time) return by_time(a, b);
    if (by == Alignment::takeoff) return by_takeoff(a, b);
    auto runs = by_place(a, b, within_m);
    if (runs) return {std::move(runs), {}};
    return {std::nullopt, why_no_places(a, b, within_m)};
}

AlignedRuns aligned_or_refused(const ComparedRun& a, const ComparedRun& b, const AlignmentRequest& request) {
    const double within_m = request.within_m.value_or(kWithin_m);
    if (request.by) {
        Attempt attempt = aligned_as_asked(a, b, *request.by, within_m);
        if (attempt.runs) return std::move(*attempt.runs);
        throw UserError(std::string("--align ") + name_of(*request.by) + ": " + attempt.why + "; " + what_fits(a, b, within_m));
    }
    if (auto runs = by_what_is_shared(a, b, within_m)) return std::move(*runs);
    throw UserError(a.folder + " and " + b.folder +
                    ": the runs share no time, come nowhere near one another, and do not both show a take-off; " +
                    what_fits(a, b, within_m));
}

}  // namespace

const char* name_of(Alignment by) {
    switch (by) {
        case Alignment::time: return "time";
        case Alignment::place: return "place";
        case Alignment::takeoff: break;
    }
    return "takeoff";
}

bool is_same_flight(const ComparedRun& a, const ComparedRun& b) {
    std::error_code ignored;
    if (std::filesystem::equivalent(a.folder, b.folder, ignored)) return true;
    if (a.log_content && b.log_content) return *a.log_content == *b.log_content;
    return has_same_log_by_summary(a, b);
}

std::optional<std::size_t> takeoff_frame(const ComparedRun& run) {
    if (const auto by_phase = takeoff_by_phase(run)) return by_phase;
    constexpr double kStanding_mps = 15, kRolling_mps = 20;
    bool was_slow = false;
    for (std::size_t n = 0; n + 1 < run.frames.size(); ++n) {
        const ComparedFrame &here = run.frames[n], &next = run.frames[n + 1];
        const double step_s = next.time_s - here.time_s;
        if (!here.has_place || !next.has_place || !(step_s > 0)) continue;
        const double speed_mps =
            ground_distance_m(here.latitude_deg, here.longitude_deg, next.latitude_deg, next.longitude_deg) / step_s;
        if (was_slow && speed_mps > kRolling_mps) return n;
        was_slow = was_slow || speed_mps < kStanding_mps;
    }
    return std::nullopt;
}

AlignedRuns aligned(const ComparedRun& a, const ComparedRun& b, const AlignmentRequest& request) {
    if (request.within_m && request.by && *request.by != Alignment::place)
        throw UserError(std::string("--within: --align ") + name_of(*request.by) +
                        " takes places however far apart they are; leave --within out, or choose --align place");
    AlignedRuns runs = aligned_or_refused(a, b, request);
    runs.searched = (a.frames.size() + runs.stride_a - 1) / runs.stride_a;
    return runs;
}

double value_at(const ComparedRun& run, double position, std::size_t quantity) {
    const auto first = static_cast<std::size_t>(position);
    const double share = position - static_cast<double>(first);
    if (!kQuantities[quantity].is_flown) return run.frames[static_cast<std::size_t>(std::lround(position))].values[quantity];
    const double from = run.frames[first].values[quantity];
    if (share == 0) return from;
    const double to = run.frames[first + 1].values[quantity];
    return from + share * (to - from);
}

}  // namespace tedavis::host_sim
