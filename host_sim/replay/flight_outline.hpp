/// Positions of a recorded flight, about one per second, and the times of its phase changes, in bounded memory. They are
/// collected in the one pass over the log.
///
/// When the memory is full, every second place is removed and the spacing doubles, as with the checkpoints. Of phase changes only
/// the first kMaxChanges are kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render_core/flight/aircraft_state.hpp"
#include "render_core/flight/flight_phase.hpp"

namespace tedavis::host_sim {

/// A valid position of the own ship, WGS 84, radians.
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
    /// With the values of another outline.
    FlightOutline(std::int64_t stride, std::vector<OutlinePlace> places, std::vector<base::Time> changes)
        : stride_(stride), places_(std::move(places)), changes_(std::move(changes)) {}

    /// Whether a place at this time is to be added; times must not decrease.
    [[nodiscard]] bool wants_place(base::Time time) const {
        return places_.empty() || (time - places_.back().time).ns >= kSpacing.ns * stride_;
    }
    /// Adds the position; an invalid one is ignored.
    void add_place(const flight::OwnShipEstimate& own_ship, base::Time time);
    /// Adds the phase that the display follows; to be called at each step of the flight's tracker.
    void add_phase(const flight::FlightPhase& presented, base::Time time);

    /// The places, ascending in time.
    [[nodiscard]] const std::vector<OutlinePlace>& places() const { return places_; }
    /// Times of the first step of each new phase, ascending; the flight's first phase is no change.
    [[nodiscard]] const std::vector<base::Time>& phase_changes() const { return changes_; }
    /// The factor of kSpacing: 1, 2, 4, ...
    [[nodiscard]] std::int64_t stride() const { return stride_; }

private:
    std::int64_t stride_ = 1;
    std::vector<OutlinePlace> places_;
    std::vector<base::Time> changes_;
    flight::FlightPhase phase_;
    bool has_phase_ = false;
};

}  // namespace tedavis::host_sim
