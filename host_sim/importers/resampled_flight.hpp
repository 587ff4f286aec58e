/// A recorded flight as a continuous one: signals at any time; signals that were not recorded are derived from the motion.
///
/// Positions: cubic Hermite curves through the fixes; the tangents are limited so that a piece never leaves its chord by more
/// than 8/27 of the chord's length, and stands still where the fixes do. Everything else: monotone curves, which never overshoot.
/// Heading is the track; bank that of a coordinated turn, tan(bank) = V omega / g, at most 60 degrees; pitch the flight-path
/// angle, at most 25 degrees. Between fixes further apart than the gap limit there are no signals.
///
/// Where fixes lie 8 s or more apart (the median of a piece without gaps), ground speed and track are those of the position
/// curve, so that they never contradict the positions. Error of the velocity at fixes that were left out, two ADS-B recordings
/// and one IGC recording with a fix each second:
///
///     kept          quantile   of the position curve    of curves through the recorded velocities
///     each tenth    95 %       2.7, 7.3, 8.1 m/s        5.5, 11.5, 10.4 m/s
///     each fifth    50 %       1.0, 2.0 m/s (ADS-B)     0.4, 0.5 m/s (ADS-B)
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/flight_log/flight_source.hpp"
#include "host_sim/geoid_egm96.hpp"
#include "host_sim/importers/monotone_curve.hpp"
#include "host_sim/importers/recorded_flight.hpp"

namespace tedavis::host_sim {

struct ResampleSettings {
    std::optional<double> qnh_pa;    ///< turns pressure altitude into an altitude on QNH (319 and 320)
    bool assume_geometric = false;   ///< without GNSS heights, use the pressure altitude as a height above sea level
    double fit_half_window_s = 2.5;  ///< of velocities and heights
    double turn_half_window_s = 4;   ///< of the turn rate
};

/// The source of each signal, for the companion file and the notes.
struct Derivation {
    std::string position, height, velocity, vertical_speed, heading, roll, pitch;
    bool height_is_geometric = false;
    std::size_t fixes = 0, segments = 0;
    double gap_limit_s = 0, longest_gap_s = 0;
    double largest_height_smoothing_m = 0;
    std::size_t velocities_not_believed = 0;  ///< recorded speeds that the positions contradict
};

/// Fixes further apart than this are not joined, since the flight between them is not known: four times the usual interval, but
/// at least 20 s and at most ten minutes.
[[nodiscard]] double gap_limit_s(const RecordedFlight& flight);

class ResampledFlight final : public FlightSource {
public:
    /// `flight` must be clean (see fix_cleaner.hpp). Throws UserError with `name` where no two fixes lie close enough, or where
    /// they span more than a week.
    ResampledFlight(const RecordedFlight& flight, const ResampleSettings& settings, const GeoidEgm96& geoid,
                    const std::string& name);

    [[nodiscard]] base::Time begin() const override { return begin_; }
    [[nodiscard]] base::Time end() const override { return end_; }
    [[nodiscard]] std::optional<SignalSample> at(base::Time time) const override;
    [[nodiscard]] const Derivation& derivation() const { return derivation_; }

private:
    /// Fixes without a gap between them; times in seconds since begin_.
    struct Segment {
        std::vector<double> times;
        std::vector<double> latitudes, longitudes;            ///< longitudes unwrapped
        std::vector<double> latitude_rates, longitude_rates;  ///< rad/s, limited
        MonotoneCurve ellipsoid_height, pressure_altitude, ground_speed, track, vertical_speed, roll, pitch, undulation;
        MonotoneCurve heading;   ///< empty: it is the track
        bool is_sparse = false;  ///< its fixes are far apart: ground speed and track are those of the position curve
    };
    struct Motion;

    void split(const RecordedFlight& flight, std::vector<std::vector<RecordedFix>>& parts);
    Segment build_segment(const RecordedFlight& flight, const std::vector<RecordedFix>& fixes);
    void add_heights(const RecordedFlight& flight, const std::vector<RecordedFix>& fixes, Segment& segment, Motion& motion);
    void add_velocity(const std::vector<RecordedFix>& fixes, Segment& segment, Motion& motion);
    void add_attitude(const std::vector<RecordedFix>& fixes, Segment& segment, const Motion& motion);
    [[nodiscard]] MonotoneCurve smoothed_heights(const std::vector<double>& times, const std::vector<double>& heights);
    void describe(const RecordedFlight& flight);
    [[nodiscard]] const Segment* segment_at(double time_s) const;
    void add_ground_motion(const Segment& segment, double t, SignalSample& sample) const;
    void add_altitudes(const Segment& segment, double t, SignalSample& sample) const;

    ResampleSettings settings_;
    const GeoidEgm96& geoid_;
    base::Time begin_, end_;
    std::vector<Segment> segments_;
    Derivation derivation_;
};

}  // namespace tedavis::host_sim
