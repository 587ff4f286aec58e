#include "host_sim/accuracy/flight_errors.hpp"

#include <algorithm>

#include "host_sim/accuracy/knobs/flown_knob.hpp"
#include "host_sim/accuracy/knobs/seen_ground.hpp"
#include "host_sim/accuracy/knobs/terrain_tau_knob.hpp"
#include "host_sim/accuracy/statistics.hpp"
#include "host_sim/replay/index_key.hpp"
#include "host_sim/replay/load_design.hpp"
#include "platform/clock/monotonic_clock.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kTolerances_px[] = {16, 8, 4, 2, 1, 0.5};

Tightness tightness_of(const std::vector<double>& shares) {
    if (shares.empty()) return {};
    return {spread_of(shares).median, *std::max_element(shares.begin(), shares.end())};
}

/// Of a frame with ground, whose bound is larger than what a measured error may be wrong by.
void add_share(const MeasuredMoment& moment, double known_to_px, std::vector<double>& shares) {
    if (moment.samples > 0 && moment.proven_px > known_to_px) shares.push_back(moment.measured_px / moment.proven_px);
}

/// The places that each pose shows, and displays at some tolerances.
class ErrorFlight {
public:
    ErrorFlight(const KnobGround& ground, const KnobFlight& flight, const std::vector<double>& tolerances_px, std::size_t poses,
                std::uint32_t across)
        : begin_(flight.begin()),
          known_to_px_(known_to_px(ground)),
          tolerances_px_(tolerances_px),
          seen_(seen_poses(ground.ground, flight.poses(poses), seen_grid(ground.display, across))),
          pictures_(levels(ground, tolerances_px_), poses_of(seen_)) {}

    [[nodiscard]] std::size_t poses() const { return seen_.size(); }

    /// Adds the samples above their bound to `broken`.
    [[nodiscard]] MeasuredMoment moment(std::size_t level, std::size_t pose, std::uint64_t& broken) {
        MeasuredMoment moment;
        pictures_.show(level, pose);
        const base::Time begun = platform::monotonic_now();
        pictures_.draw(level, pose);
        moment.ms = (platform::monotonic_now() - begun).to_seconds() * 1000;
        display::Display& display = pictures_.display(level, pose);
        moment.proven_px = display.record().terrain.worst_error_px;
        for (const SeenPlace& place : seen_[pose].places)
            if (const auto error = terrain_error_px(display, place)) {
                ++moment.samples;
                broken += *error > moment.proven_px + known_to_px_ ? 1 : 0;
                moment.measured_px = std::max(moment.measured_px, *error);
            }
        moment.pose = pose_text(seen_[pose].pose);
        moment.phase = phase_option(seen_[pose].pose);
        moment.time_s = (seen_[pose].pose.time - begin_).to_seconds();
        return moment;
    }

    /// Calls `begin_frame` before each frame.
    [[nodiscard]] ToleranceLine line(std::size_t level, const std::function<void()>& begin_frame) {
        ToleranceLine line;
        line.asked_px = tolerances_px_[level];
        std::vector<double> shares;
        for (std::size_t pose = 0; pose < poses(); ++pose) {
            begin_frame();
            const MeasuredMoment at = moment(level, pose, line.broken);
            line.proven_px = std::max(line.proven_px, at.proven_px);
            line.measured_px = std::max(line.measured_px, at.measured_px);
            line.samples += at.samples;
            add_share(at, known_to_px_, shares);
        }
        line.tightness = tightness_of(shares);
        return line;
    }

    [[nodiscard]] static double known_to_px(const KnobGround& ground) { return kSeenErrorBound_px * pixel_scale(ground.display); }

private:
    static std::vector<FlownLevel> levels(const KnobGround& ground, const std::vector<double>& tolerances_px) {
        std::vector<FlownLevel> levels;
        for (const double tau_px : tolerances_px) levels.push_back(terrain_level(ground.ground.path(), tau_px, ground.display));
        return levels;
    }

    base::Time begin_;
    double known_to_px_;  ///< what terrain_error_px() may be wrong by
    std::vector<double> tolerances_px_;
    std::vector<SeenPose> seen_;
    FlownPictures pictures_;
};

}  // namespace

bool FlightErrors::holds() const {
    return std::all_of(lines.begin(), lines.end(), [](const ToleranceLine& line) { return line.broken == 0; }) &&
           std::all_of(moments.begin(), moments.end(),
                       [this](const MeasuredMoment& moment) { return moment.measured_px <= moment.proven_px + known_to_px; });
}

std::uint64_t FlightErrors::samples() const {
    std::uint64_t all = 0;
    for (const MeasuredMoment& moment : moments) all += moment.samples;
    for (const ToleranceLine& line : lines) all += line.samples;
    return all;
}

Tightness FlightErrors::tightness() const {
    std::vector<double> shares;
    for (const MeasuredMoment& moment : moments) add_share(moment, known_to_px, shares);
    return tightness_of(shares);
}

const FlightErrors* errors_over(const KnobGround& ground, const std::vector<FlightErrors>& flights) {
    const std::uint64_t flight = ground.recorded == nullptr ? 0 : ground.recorded->identity;
    const std::uint64_t terrain = terrain_identity(&ground.ground.database());
    const auto found = std::find_if(flights.begin(), flights.end(), [&](const FlightErrors& one) {
        return one.identity == flight && one.terrain_identity == terrain;
    });
    return found == flights.end() ? nullptr : &*found;
}

std::vector<FlightErrors> errors_over(const std::vector<KnobGround>& grounds, const std::vector<FlightErrors>& flights) {
    std::vector<FlightErrors> kept;
    for (const KnobGround& ground : grounds)
        if (const FlightErrors* const known = errors_over(ground, flights); known && errors_over(ground, kept) == nullptr)
            kept.push_back(*known);
    return kept;
}

FlightErrors measure_flight_errors(const KnobGround& ground, const FlightErrorsPlan& plan) {
    const KnobFlight flight(ground);
    const FlownLevel as_designed = flown_level(ground.ground.path(), ground.display);
    FlightErrors measured;
    measured.flight = flight.name();
    measured.terrain = ground.ground.path();
    measured.identity = ground.recorded == nullptr ? 0 : ground.recorded->identity;
    measured.terrain_identity = terrain_identity(&ground.ground.database());
    measured.drawn = shot_options(as_designed).value_or("");
    measured.known_to_px = ErrorFlight::known_to_px(ground);
    measured.asked_px = load_design(as_designed.picture).terrain.tau_px;
    std::size_t frames = 0;
    const std::size_t all = plan.moments + plan.line_poses * std::size(kTolerances_px);
    const auto begin_frame = [&] { plan.progress(frames++, all); };
    {
        std::uint64_t broken = 0;
        ErrorFlight along(ground, flight, {measured.asked_px}, plan.moments, plan.across);
        for (std::size_t n = 0; n < along.poses(); ++n) {
            begin_frame();
            measured.moments.push_back(along.moment(0, n, broken));
        }
    }
    ErrorFlight lines(ground, flight, {std::begin(kTolerances_px), std::end(kTolerances_px)}, plan.line_poses, plan.across);
    for (std::size_t level = 0; level < std::size(kTolerances_px); ++level)
        measured.lines.push_back(lines.line(level, begin_frame));
    return measured;
}

}  // namespace tedavis::host_sim
