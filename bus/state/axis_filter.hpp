/// One axis of the own ship: a Kalman filter of position and velocity over measurements that may come out of order.
///
/// The last kRing measurements are kept sorted by source time; one that comes late but within the ring is inserted and the
/// filter is run again from the state before the ring, so that the order of arrival does not matter. Model: constant velocity,
/// white acceleration. A position far from the prediction is rejected. At the kOutliersToRestart-th rejection in a row, and
/// after a gap longer than `restart_gap`, the filter restarts.
///
/// Positions may be angles (radians, with metres per radian given per measurement) or metres (scale 1); all noise and the
/// velocity are in metres. Thread  one. Memory  fixed, trivially copyable. Cost  at most kRing + 1 steps a measurement.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "render_core/base/time.hpp"

namespace tedavis::bus {

struct AxisMeasurement {
    base::Time at;               ///< source time
    double value = 0;            ///< position (rad or m) or velocity (m/s)
    double sigma = 1;            ///< standard deviation, m or m/s
    double metres_per_unit = 1;  ///< of the position at this place
    bool is_velocity = false;
};

struct AxisModel {
    double acceleration_mps2 = 4;
    base::Duration restart_gap = base::Duration::seconds(2);
    bool wraps = false;  ///< positions are longitudes: differences go the shorter way round
};

struct AxisEstimate {
    double position = 0;
    double velocity_mps = 0;
    base::Duration age;    ///< since the last accepted position
    bool started = false;  ///< false: no position yet, and the other members are meaningless
};

class AxisFilter {
public:
    static constexpr std::size_t kRing = 8;
    static constexpr std::uint8_t kOutliersToRestart = 4;

    explicit AxisFilter(AxisModel model = AxisModel()) : model_(model) {}

    /// Returns false when the measurement was dropped: a duplicate, older than the ring, or not finite.
    bool add(const AxisMeasurement& measurement);
    /// Returns the estimate at `now`, or at the last position's time plus `limit` where that is earlier.
    [[nodiscard]] AxisEstimate estimate(base::Time now, base::Duration limit) const;
    [[nodiscard]] std::uint64_t dropped() const { return dropped_; }

private:
    struct State {
        base::Time at;
        base::Time last_position;
        double position = 0;
        double velocity = 0;
        double metres_per_unit = 1;
        double p00 = 0, p01 = 0, p11 = 0;  // covariance, m and m/s
        std::uint8_t outliers = 0;
        bool started = false;
    };
    [[nodiscard]] State after(const State& before, const AxisMeasurement& measurement) const;
    [[nodiscard]] State started_at(const AxisMeasurement& measurement) const;
    void predict(State& state, base::Time to) const;
    [[nodiscard]] double difference_m(const State& state, const AxisMeasurement& measurement) const;
    void correct_by_velocity(State& state, const AxisMeasurement& measurement) const;
    void correct_by_position(State& state, const AxisMeasurement& measurement, double innovation_m) const;
    void move(State& state, double by_m, double by_mps) const;
    void push_sorted(const AxisMeasurement& measurement);

    AxisModel model_;
    State before_ring_;
    State current_;
    std::array<AxisMeasurement, kRing> ring_{};
    std::size_t count_ = 0;
    std::uint64_t dropped_ = 0;
};
static_assert(std::is_trivially_copyable_v<AxisFilter>);

}  // namespace tedavis::bus
