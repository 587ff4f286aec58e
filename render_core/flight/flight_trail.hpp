/// The way that the own aircraft has flown in the last minutes, and what it has measured of the air there.
///
/// A point every kSpacing while the own ship's place is valid; the oldest give way. A place that is not valid for one step, or no
/// step for kLongestGap, ends a part of the way: nothing is said of what lies between. A place that cannot have been reached
/// since the last point, and time that runs back, clear it: what was believed before is not.
///
/// The result depends on the steps: both programs take them on the grid of the phase (phase_monitor.hpp). Plain data; a
/// copy is a checkpoint. Thread  one. Memory  fixed, inside. Failure  none.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "render_core/flight/aircraft_state.hpp"

namespace tedavis::flight {

/// NaN: not stated, or not valid then.
struct FlownPoint {
    double latitude_rad = 0, longitude_rad = 0;
    base::Time at;
    float height_m = 0;  ///< over the ellipsoid; where `is_geometric` is false over MSL, by pressure
    float position_accuracy_m = 0, height_accuracy_m = 0;  ///< figures of merit, 95 %
    float wind_speed_mps = 0, wind_from_rad = 0;           ///< both or none
    float temperature_k = 0;
    bool is_geometric = false;
    bool begins = false;  ///< the first of its part
};

/// Of the own ship's estimate and the signals that are valid now.
[[nodiscard]] FlownPoint flown_point(const AircraftState& aircraft, base::Time now) noexcept;

class FlightTrail {
public:
    static constexpr std::size_t kMax = 128;
    static constexpr base::Duration kSpacing = base::Duration::seconds(2);
    static constexpr base::Duration kLongestGap = base::Duration::seconds(5);
    static constexpr double kFastest_mps = 700, kLeap_m = 500;  ///< farther than both together is a leap

    void step(const AircraftState& aircraft, base::Time now);

    [[nodiscard]] std::size_t size() const { return count_; }
    /// The oldest first.
    [[nodiscard]] const FlownPoint& operator[](std::size_t n) const { return points_[(first_ + n) % kMax]; }
    /// How many points there have been before the oldest: its number, which stays with it.
    [[nodiscard]] std::uint64_t number_of_oldest() const { return passed_; }
    /// True where the last part goes on to a point: what is drawn may join them.
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
