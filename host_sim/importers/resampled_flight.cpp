#include "host_sim/importers/resampled_flight.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/flight_log/pressure_altitude.hpp"
#include "host_sim/importers/local_fit.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

using flight::Signal;

constexpr double kLongestFlight_days = 7;
constexpr double kShortestGap_s = 20.0, kLongestLink_s = 600.0;  // limits of the gap limit
constexpr double kGapFactor = 4.0;                               // times the median interval
constexpr double kSlowest_mps = 3.0;                             // below, the track says nothing
constexpr double kLargestBank_rad = base::radians(60.0);
constexpr double kLargestPitch_rad = base::radians(25.0);
constexpr double kSlowestForPitch_mps = 10.0;
constexpr double kBelievedShare = 0.1;  // of the speed, plus
constexpr double kBelieved_mps = 5.0;   // how far a recorded velocity may differ from the positions'
constexpr double kBelievedVertical_mps = 4.0;
constexpr double kSmallestCosine = 1e-4;  // of the latitude, near the poles
constexpr double kFarApart_s = 8.0;       // between fixes in the median: their curve knows the velocities best

std::vector<double> unwrapped(std::vector<double> angles) {
    for (std::size_t i = 1; i < angles.size(); ++i) angles[i] = angles[i - 1] + earth::angle_difference(angles[i], angles[i - 1]);
    return angles;
}

template <class Member>
bool all_have(const std::vector<RecordedFix>& fixes, Member member) {
    return std::all_of(fixes.begin(), fixes.end(), [&](const RecordedFix& fix) { return (fix.*member).has_value(); });
}

template <class Member>
std::vector<double> values_of(const std::vector<RecordedFix>& fixes, Member member) {
    std::vector<double> values;
    values.reserve(fixes.size());
    for (const RecordedFix& fix : fixes) values.push_back(*(fix.*member));
    return values;
}

template <class Member>
bool any_has(const RecordedFlight& flight, Member member) {
    return std::any_of(flight.fixes.begin(), flight.fixes.end(),
                       [&](const RecordedFix& fix) { return (fix.*member).has_value(); });
}

/// The tangent pulled towards the chord until it lies within one chord length of it.
void limit_tangents(const std::vector<double>& times, const std::vector<double>& north, const std::vector<double>& east,
                    std::vector<double>& north_rates, std::vector<double>& east_rates) {
    for (std::size_t node = 0; node < times.size(); ++node) {
        for (std::size_t i = node == 0 ? 0 : node - 1; i <= std::min(node, times.size() - 2); ++i) {
            const double h = times[i + 1] - times[i];
            const double chord_north = (north[i + 1] - north[i]) / h, chord_east = (east[i + 1] - east[i]) / h;
            const double off_north = north_rates[node] - chord_north, off_east = east_rates[node] - chord_east;
            const double off = std::hypot(off_north, off_east), chord = std::hypot(chord_north, chord_east);
            if (off <= chord) continue;
            north_rates[node] = chord_north + off_north * chord / off;
            east_rates[node] = chord_east + off_east * chord / off;
        }
    }
}

double hermite(const std::vector<double>& times, const std::vector<double>& values, const std::vector<double>& rates,
               double time) {
    const std::size_t i = interval_of(times, time);
    const double h = times[i + 1] - times[i], t = (time - times[i]) / h, s = 1 - t;
    return values[i] * s * s * (1 + 2 * t) + values[i + 1] * t * t * (3 - 2 * t) + h * t * s * (rates[i] * s - rates[i + 1] * t);
}

double median_step(const std::vector<double>& times) {
    std::vector<double> steps;
    for (std::size_t n = 1; n < times.size(); ++n) steps.push_back(times[n] - times[n - 1]);
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

/// Its derivative by time.
double hermite_rate(const std::vector<double>& times, const std::vector<double>& values, const std::vector<double>& rates,
                    double time) {
    const std::size_t i = interval_of(times, time);
    const double h = times[i + 1] - times[i], t = (time - times[i]) / h, s = 1 - t;
    return 6 * t * s * (values[i + 1] - values[i]) / h + rates[i] * s * (s - 2 * t) + rates[i + 1] * t * (t - 2 * s);
}

double east_m_per_rad(double latitude_rad) {
    return earth::prime_vertical_radius_m(latitude_rad) * std::max(kSmallestCosine, std::cos(latitude_rad));
}

void set_geometric_altitude(double msl_m, double undulation_m, SignalSample& sample) {
    sample[Signal::ellipsoid_height] = msl_m + undulation_m;
    sample[Signal::true_altitude] = msl_m;
}

/// Binomial weights 1 2 1.
std::vector<double> filtered(std::vector<double> values) {
    const std::vector<double> raw = values;
    for (std::size_t i = 1; i + 1 < raw.size(); ++i) values[i] = 0.25 * raw[i - 1] + 0.5 * raw[i] + 0.25 * raw[i + 1];
    return values;
}

}  // namespace

/// Velocities at the fixes of one segment.
struct ResampledFlight::Motion {
    std::vector<double> north_mps, east_mps, up_mps, ground_speed_mps, track_rad;
};

double gap_limit_s(const RecordedFlight& flight) {
    std::vector<double> intervals;
    for (std::size_t i = 1; i < flight.fixes.size(); ++i)
        intervals.push_back((flight.fixes[i].time - flight.fixes[i - 1].time).to_seconds());
    if (intervals.empty()) return kShortestGap_s;
    const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
    std::nth_element(intervals.begin(), middle, intervals.end());
    return std::clamp(kGapFactor * *middle, kShortestGap_s, kLongestLink_s);
}

ResampledFlight::ResampledFlight(const RecordedFlight& flight, const ResampleSettings& settings, const GeoidEgm96& geoid,
                                 const std::string& name)
    : settings_(settings), geoid_(geoid) {
    std::vector<std::vector<RecordedFix>> parts;
    split(flight, parts);
    if (parts.empty())
        throw UserError(name + ": no two fixes follow each other closely enough to be flown; give a denser recording");
    begin_ = parts.front().front().time;
    end_ = parts.back().back().time;
    const double days = (end_ - begin_).to_seconds() / 86400;
    if (days > kLongestFlight_days)
        throw UserError(name + ": its fixes span " + std::to_string(static_cast<long>(days)) +
                        " days; a flight lasts a week at most, so correct the times or split the recording");
    for (const auto& part : parts) segments_.push_back(build_segment(flight, part));
    derivation_.fixes = flight.fixes.size();
    derivation_.segments = segments_.size();
    describe(flight);
}

void ResampledFlight::split(const RecordedFlight& flight, std::vector<std::vector<RecordedFix>>& parts) {
    std::vector<double> intervals;
    for (std::size_t i = 1; i < flight.fixes.size(); ++i)
        intervals.push_back((flight.fixes[i].time - flight.fixes[i - 1].time).to_seconds());
    if (intervals.empty()) return;
    derivation_.gap_limit_s = gap_limit_s(flight);
    parts.push_back({flight.fixes[0]});
    for (std::size_t i = 1; i < flight.fixes.size(); ++i) {
        if (intervals[i - 1] > derivation_.gap_limit_s) {
            derivation_.longest_gap_s = std::max(derivation_.longest_gap_s, intervals[i - 1]);
            parts.emplace_back();
        }
        parts.back().push_back(flight.fixes[i]);
    }
    parts.erase(std::remove_if(parts.begin(), parts.end(), [](const auto& part) { return part.size() < 2; }), parts.end());
}

ResampledFlight::Segment ResampledFlight::build_segment(const RecordedFlight& flight, const std::vector<RecordedFix>& fixes) {
    Segment segment;
    for (const RecordedFix& fix : fixes) {
        segment.times.push_back((fix.time - begin_).to_seconds());
        segment.latitudes.push_back(fix.latitude_rad);
        segment.longitudes.push_back(fix.longitude_rad);
    }
    segment.longitudes = unwrapped(std::move(segment.longitudes));
    segment.is_sparse = median_step(segment.times) >= kFarApart_s;
    Motion motion;
    add_heights(flight, fixes, segment, motion);
    add_velocity(fixes, segment, motion);
    add_attitude(fixes, segment, motion);
    return segment;
}

MonotoneCurve ResampledFlight::smoothed_heights(const std::vector<double>& times, const std::vector<double>& heights) {
    const FittedSeries fitted = fit_locally(times, heights, settings_.fit_half_window_s);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        derivation_.largest_height_smoothing_m =
            std::max(derivation_.largest_height_smoothing_m, std::abs(fitted.values[i] - heights[i]));
    }
    return {times, fitted.values};
}

void ResampledFlight::add_heights(const RecordedFlight& flight, const std::vector<RecordedFix>& fixes, Segment& segment,
                                  Motion& motion) {
    std::vector<double> gnss_times, gnss, pressure_times, pressure, undulations;
    for (std::size_t i = 0; i < fixes.size(); ++i) {
        const RecordedFix& fix = fixes[i];
        undulations.push_back(geoid_.undulation(fix.latitude_rad, fix.longitude_rad).m);
        if (fix.pressure_altitude_m) {
            pressure_times.push_back(segment.times[i]);
            pressure.push_back(*fix.pressure_altitude_m);
        }
        if (fix.gnss_height_m) {
            const double separation = fix.geoid_separation_m.value_or(undulations.back());
            gnss_times.push_back(segment.times[i]);
            gnss.push_back(*fix.gnss_height_m + (flight.gnss_datum == HeightDatum::msl_egm96 ? separation : 0.0));
        }
    }
    segment.undulation = MonotoneCurve(segment.times, undulations);
    if (!pressure.empty()) segment.pressure_altitude = smoothed_heights(pressure_times, pressure);
    if (!gnss.empty()) segment.ellipsoid_height = smoothed_heights(gnss_times, gnss);
    const MonotoneCurve& best = gnss.size() >= pressure.size() ? segment.ellipsoid_height : segment.pressure_altitude;
    std::vector<double> heights;
    for (const double t : segment.times) heights.push_back(best.empty() ? 0.0 : best.at(t));
    motion.up_mps = fit_locally(segment.times, heights, settings_.fit_half_window_s).slopes;
    for (std::size_t i = 0; i < fixes.size(); ++i) {
        const auto& recorded = fixes[i].vertical_speed_mps;
        if (recorded && (best.empty() || std::abs(*recorded - motion.up_mps[i]) < kBelievedVertical_mps))
            motion.up_mps[i] = *recorded;
    }
    segment.vertical_speed = MonotoneCurve(segment.times, motion.up_mps);
}

void ResampledFlight::add_velocity(const std::vector<RecordedFix>& fixes, Segment& segment, Motion& motion) {
    const FittedSeries latitude = fit_locally(segment.times, segment.latitudes, settings_.fit_half_window_s);
    const FittedSeries longitude = fit_locally(segment.times, segment.longitudes, settings_.fit_half_window_s);
    double held_track = 0;
    for (std::size_t i = 0; i < fixes.size(); ++i) {
        const double north_scale = earth::meridian_radius_m(fixes[i].latitude_rad);
        const double east_scale = east_m_per_rad(fixes[i].latitude_rad);
        double north = latitude.slopes[i] * north_scale, east = longitude.slopes[i] * east_scale;
        if (fixes[i].ground_speed_mps && fixes[i].true_track_rad) {
            const double speed = *fixes[i].ground_speed_mps;
            const double stated_north = speed * std::cos(*fixes[i].true_track_rad),
                         stated_east = speed * std::sin(*fixes[i].true_track_rad);
            const bool believed = std::hypot(stated_north - north, stated_east - east) <= kBelievedShare * speed + kBelieved_mps;
            derivation_.velocities_not_believed += believed ? 0 : 1;
            if (believed) north = stated_north, east = stated_east;
        }
        motion.north_mps.push_back(north);
        motion.east_mps.push_back(east);
        motion.ground_speed_mps.push_back(std::hypot(north, east));
        if (motion.ground_speed_mps.back() >= kSlowest_mps) held_track = std::atan2(east, north);
        motion.track_rad.push_back(held_track);
        segment.latitude_rates.push_back(north / north_scale);
        segment.longitude_rates.push_back(east / east_scale);
    }
    // A flight that begins at rest points where it will go.
    const auto moving =
        std::find_if(motion.ground_speed_mps.begin(), motion.ground_speed_mps.end(), [](double v) { return v >= kSlowest_mps; });
    if (moving != motion.ground_speed_mps.end()) {
        const auto first = moving - motion.ground_speed_mps.begin();
        std::fill(motion.track_rad.begin(), motion.track_rad.begin() + first, motion.track_rad[static_cast<std::size_t>(first)]);
    }
    limit_tangents(segment.times, segment.latitudes, segment.longitudes, segment.latitude_rates, segment.longitude_rates);
    motion.track_rad = unwrapped(std::move(motion.track_rad));
    segment.ground_speed = MonotoneCurve(segment.times, motion.ground_speed_mps);
    segment.track = MonotoneCurve(segment.times, motion.track_rad);
}

void ResampledFlight::add_attitude(const std::vector<RecordedFix>& fixes, Segment& segment, const Motion& motion) {
    if (all_have(fixes, &RecordedFix::true_heading_rad))
        segment.heading = MonotoneCurve(segment.times, unwrapped(values_of(fixes, &RecordedFix::true_heading_rad)));
    const std::vector<double> turn_rates = fit_locally(segment.times, motion.track_rad, settings_.turn_half_window_s).slopes;
    std::vector<double> rolls, pitches;
    for (std::size_t i = 0; i < fixes.size(); ++i) {
        const double bank = std::atan(motion.ground_speed_mps[i] * turn_rates[i] / base::kStandardGravity);
        rolls.push_back(std::clamp(bank, -kLargestBank_rad, kLargestBank_rad));
        const double path = std::atan2(motion.up_mps[i], std::max(kSlowestForPitch_mps, motion.ground_speed_mps[i]));
        pitches.push_back(std::clamp(path, -kLargestPitch_rad, kLargestPitch_rad));
    }
    const bool has_roll = all_have(fixes, &RecordedFix::roll_rad), has_pitch = all_have(fixes, &RecordedFix::pitch_rad);
    segment.roll = MonotoneCurve(segment.times, has_roll ? values_of(fixes, &RecordedFix::roll_rad) : filtered(rolls));
    segment.pitch = MonotoneCurve(segment.times, has_pitch ? values_of(fixes, &RecordedFix::pitch_rad) : filtered(pitches));
}

void ResampledFlight::describe(const RecordedFlight& flight) {
    Derivation& d = derivation_;
    const bool gnss = any_has(flight, &RecordedFix::gnss_height_m), pressure = any_has(flight, &RecordedFix::pressure_altitude_m);
    const bool recorded_speed = any_has(flight, &RecordedFix::ground_speed_mps) && any_has(flight, &RecordedFix::true_track_rad);
    d.position = "recorded fixes, cubic Hermite curves between them";
    d.height_is_geometric = gnss || (pressure && settings_.assume_geometric);
    if (gnss) {
        d.height = flight.gnss_datum == HeightDatum::msl_egm96 ? "recorded GNSS height above sea level, EGM96 undulation added"
                                                               : "recorded GNSS height above the WGS84 ellipsoid";
    } else if (pressure && settings_.assume_geometric) {
        d.height = settings_.qnh_pa
                       ? "altitude on QNH, from pressure altitude, taken for a height above sea level "
                         "(--assume-geometric), EGM96 undulation added"
                       : "pressure altitude taken for a height above sea level (--assume-geometric), EGM96 undulation "
                         "added";
    } else if (pressure) {
        d.height = settings_.qnh_pa ? "no geometric height; altitude on QNH from pressure altitude"
                                    : "no geometric height; pressure altitude only";
    } else {
        d.height = "none recorded";
    }
    d.velocity = recorded_speed ? "recorded where the positions agree and lie less than 8 s apart, else derived from them"
                                : "derived from the positions";
    d.vertical_speed = any_has(flight, &RecordedFix::vertical_speed_mps)
                           ? "recorded where the heights agree, else derived from them"
                           : "derived from the heights";
    d.heading =
        any_has(flight, &RecordedFix::true_heading_rad) ? "recorded where complete, else the track" : "derived: the track";
    d.roll = any_has(flight, &RecordedFix::roll_rad) ? "recorded where complete, else a coordinated turn"
                                                     : "derived: bank of a coordinated turn, at most 60 degrees";
    d.pitch = any_has(flight, &RecordedFix::pitch_rad) ? "recorded where complete, else the flight-path angle"
                                                       : "derived: the flight-path angle, at most 25 degrees";
}

const ResampledFlight::Segment* ResampledFlight::segment_at(double time_s) const {
    const auto after = std::upper_bound(segments_.begin(), segments_.end(), time_s,
                                        [](double t, const Segment& segment) { return t < segment.times.front(); });
    if (after == segments_.begin()) return nullptr;
    const Segment& segment = *(after - 1);
    return time_s <= segment.times.back() ? &segment : nullptr;
}

std::optional<SignalSample> ResampledFlight::at(base::Time time) const {
    const double t = (time - begin_).to_seconds();
    const Segment* segment = segment_at(t);
    if (segment == nullptr) return std::nullopt;
    SignalSample sample;
    sample[Signal::latitude] = hermite(segment->times, segment->latitudes, segment->latitude_rates, t);
    sample[Signal::longitude] = earth::wrap_longitude(hermite(segment->times, segment->longitudes, segment->longitude_rates, t));
    add_ground_motion(*segment, t, sample);
    sample[Signal::roll] = segment->roll.at(t);
    sample[Signal::pitch] = segment->pitch.at(t);
    add_altitudes(*segment, t, sample);
    return sample;
}

void ResampledFlight::add_ground_motion(const Segment& segment, double t, SignalSample& sample) const {
    double speed_mps = segment.ground_speed.at(t), track_rad = segment.track.at(t);
    if (segment.is_sparse) {
        const double latitude_rad = sample[Signal::latitude];
        const double north_mps =
            hermite_rate(segment.times, segment.latitudes, segment.latitude_rates, t) * earth::meridian_radius_m(latitude_rad);
        const double east_mps =
            hermite_rate(segment.times, segment.longitudes, segment.longitude_rates, t) * east_m_per_rad(latitude_rad);
        speed_mps = std::hypot(north_mps, east_mps);
        if (speed_mps >= kSlowest_mps) track_rad = std::atan2(east_mps, north_mps);
    }
    sample[Signal::ground_speed] = speed_mps;
    sample[Signal::true_track] = earth::wrap_heading(track_rad);
    sample[Signal::true_heading] = earth::wrap_heading(segment.heading.empty() ? track_rad : segment.heading.at(t));
}

void ResampledFlight::add_altitudes(const Segment& segment, double t, SignalSample& sample) const {
    const double undulation = segment.undulation.at(t);
    const bool gnss = segment.ellipsoid_height.covers(t, derivation_.gap_limit_s);
    const bool pressure = segment.pressure_altitude.covers(t, derivation_.gap_limit_s);
    if (gnss || pressure) sample[Signal::vertical_speed] = segment.vertical_speed.at(t);
    if (gnss) set_geometric_altitude(segment.ellipsoid_height.at(t) - undulation, undulation, sample);
    if (!pressure) return;
    sample[Signal::standard_altitude] = segment.pressure_altitude.at(t);
    if (settings_.qnh_pa) {
        sample[Signal::baro_setting] = *settings_.qnh_pa;
        sample[Signal::baro_altitude] = altitude_on_qnh(sample[Signal::standard_altitude], *settings_.qnh_pa);
    }
    if (segment.ellipsoid_height.empty() && settings_.assume_geometric) {
        set_geometric_altitude(settings_.qnh_pa ? sample[Signal::baro_altitude] : sample[Signal::standard_altitude], undulation,
                               sample);
    }
}

}  // namespace tedavis::host_sim
