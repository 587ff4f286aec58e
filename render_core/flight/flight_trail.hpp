/// The flight trail: where the own aircraft has flown in the last minutes, with its measurements of the air.
///
/// A point is added every kSpacing while the own ship's position is valid; the oldest points are dropped. A position that is
/// invalid for one step, or no step for kLongestGap, ends a part of the trail: the gap is not drawn. A position that cannot
/// have been reached since the last point, and time that runs back, clear the trail.
///
/// The result depends on the times of the steps: both programs use the grid of phase_monitor.hpp. Plain data; a copy is a
/// checkpoint. Thread  one. Memory  fixed, inside. Failure  none.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "render_core/flight/aircraft_state.hpp"

namespace tedavis::flight {

/// A point of the trail. NaN: not stated, or not valid at that time.
struct FlownPoint {
    double latitude_rad = 0, longitude_rad = 0;
    base::Time at;
    float height_m = 0;  ///< above the ellipsoid; where `is_geometric` is false a pressure height above MSL
    float position_accuracy_m = 0, height_accuracy_m = 0;  ///< figures of merit, 95 %
    float wind_speed_mps = 0, wind_from_rad = 0;           ///< both or neither
    float temperature_k = 0;
    bool is_geometric = false;
    bool begins = false;  ///< first point of a part
};

/// Makes a point from the own ship's estimate and the signals that are valid at `now`.
[[nodiscard]] FlownPoint flown_point(const AircraftState& aircraft, base::Time now) noexcept;

class FlightTrail {
public:
    static constexpr std::size_t kMax = 128;
    static constexpr base::Duration kSpacing = base::Duration::seconds(2);
    static constexpr base::Duration kLongestGap = base::Duration::seconds(5);
    /// A step longer than kFastest_mps times its duration plus kLeap_m is impossible.
    static constexpr double kFastest_mps = 700, kLeap_m = 500;

    void step(const AircraftState& aircraft, base::Time now);

    [[nodiscard]] std::size_t size() const { return count_; }
    /// Point n, the oldest first.
    [[nodiscard]] const FlownPoint& operator[](std::size_t n) const { return points_[(first_ + n) % kMax]; }
    /// Number of points before the oldest one, that is, the oldest point's permanent number.
    [[nodiscard]] std::uint64_t number_of_oldest() const { return passed_; }
    /// True where the last part continues to a point, so that a line may join them.
    [[nodiscard]] bool goes_on_to(const FlownPoint& next) const;

private:
    void clear();
    void add(const FlownPoint& point);
    [[nodiscard]] const FlownPoint& last() const { return (*this)[count_ - 1]; }

    std::array<FlownPoint, kMax> points_{};
    std::size_t first_ = 0, count_ = 0;
    std::uint64_t passed_ = 0;
    base::Time last_step_;
    bool is_broken_ = false;
};
static_assert(std::is_trivially_copyable_v<FlightTrail>);

}  // namespace tedavis::flight
