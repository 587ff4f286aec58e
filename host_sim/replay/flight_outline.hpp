/// Where a recorded flight leads, and when its phase changes, in memory of a bounded size: a place about each second and the
/// changes, which the one pass over the log leaves.
///
/// When it is full every second place goes and the spacing doubles, as with the checkpoints. A flight that flickers has its first
/// kMaxChanges changes alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render_core/flight/aircraft_state.hpp"
#include "render_core/flight/flight_phase.hpp"

namespace tedavis::host_sim {

/// A place of the own ship, whose position was valid then. Radians.
struct OutlinePlace {
    base::Time time;
    double latitude_rad = 0, longitude_rad = 0;
};
static_assert(std::is_trivially_copyable_v<OutlinePlace>);

class FlightOutline {
public:
    static constexpr base::Duration kSpacing = base::Duration::seconds(1);
    static constexpr std::size_t kMaxPlaces = 1u << 16, kMaxChanges = 4096;

    FlightOutline() = default;
    /// As they were taken from another outline.
    FlightOutline(std::int64_t stride, std::vector<OutlinePlace> places, std::vector<base::Time> changes)
        : stride_(stride), places_(std::move(places)), changes_(std::move(changes)) {}

    /// True where a place is wanted of this time; times never decrease.
    [[nodiscard]] bool wants_place(base::Time time) const {
        return places_.empty() || (time - places_.back().time).ns >= kSpacing.ns * stride_;
    }
    /// A position that is not valid is left out.
    void add_place(const flight::OwnShipEstimate& own_ship, base::Time time);
    /// The phase that the picture follows, at each step of the flight's tracker.
    void add_phase(const flight::FlightPhase& presented, base::Time time);

    /// In order of time.
    [[nodiscard]] const std::vector<OutlinePlace>& places() const { return places_; }
    /// First steps of another phase than the one before; the flight's first phase is no change.
    [[nodiscard]] const std::vector<base::Time>& phase_changes() const { return changes_; }
    /// How often the spacing is taken: 1, 2, 4, ...
    [[nodiscard]] std::int64_t stride() const { return stride_; }

private:
    std::int64_t stride_ = 1;
    std::vector<OutlinePlace> places_;
    std::vector<base::Time> changes_;
    flight::FlightPhase phase_;
    bool has_phase_ = false;
};

}  // namespace tedavis::host_sim
