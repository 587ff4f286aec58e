/// The own ship's trail, with the air data measured along it, as layers like those of a scene, so that the same techniques show
/// them.
///
///   start(arena) · take(frame) each frame · trail(), winds(): layers that stay at their places
///
/// The trail has a line for each of its parts (flight/flight_trail.hpp), up to the own ship. Its points have the attributes
/// "position_accuracy" and "height_accuracy" (m, 95 %), "wind_speed" (m/s), "temperature" (K), which are missing where they were
/// not stated. Where no accuracy was stated the layer's accuracy is kUnstatedAccuracy_m: an unknown accuracy must not look
/// certain. Winds are at the places where they were measured, one for every kWindEvery points, and at the own ship; there are
/// none while the aircraft states no valid wind. Pressure heights count as heights above the geoid.
///
/// Memory  from an arena, once. Thread  the display's. Failure  start() false where the arena is too small.
#pragma once

#include <array>

#include "render_core/base/memory_budget.hpp"
#include "render_core/draw/data/element_input.hpp"
#include "render_core/flight/flight_time.hpp"
#include "render_core/flight/flight_trail.hpp"
#include "render_core/scene/glyph_selection.hpp"

namespace tedavis::display {

struct OwnFlightFrame {
    const flight::FlightTrail* way = nullptr;  ///< null: no trail is kept, and nothing is shown
    const flight::AircraftState* aircraft = nullptr;
    base::Time now;
};

class OwnFlight {
public:
    static constexpr std::size_t kMaxPoints = flight::FlightTrail::kMax + 1;
    static constexpr std::uint64_t kWindEvery = 15;
    static constexpr std::size_t kMaxWinds = flight::FlightTrail::kMax / kWindEvery + 2;
    static constexpr std::size_t kAttributes = 4;
    static constexpr float kUnstatedAccuracy_m = 100;

    OwnFlight();
    OwnFlight(const OwnFlight&) = delete;  // layers point into it
    OwnFlight& operator=(const OwnFlight&) = delete;

    [[nodiscard]] bool start(base::Arena& arena);
    void take(const OwnFlightFrame& frame, const flight::FlightTime& time, scene::Ground& ground);

    [[nodiscard]] const scene::Layer& trail() const { return trail_; }
    [[nodiscard]] const scene::Layer& winds() const { return winds_; }
    /// Returns the glyphs of winds(), relative to an eye point in ECEF; valid until the next call.
    [[nodiscard]] base::Span<const scene::SelectedGlyph> wind_glyphs(const glm::dvec3& eye);

private:
    enum Measured : std::size_t { kPositionAccuracy, kHeightAccuracy, kWindSpeed, kTemperature };
    void add(const flight::FlownPoint& point, bool begins, scene::Ground& ground);
    void add_wind(const flight::FlownPoint& point, scene::Ground& ground);
    void finish_trail();
    void finish_winds();

    scene::LayerEntry trail_entry_{}, winds_entry_{};
    std::array<scene::AttributeEntry, kAttributes> trail_attribute_entries_{};
    scene::AttributeEntry wind_speed_entry_{};
    std::array<scene::Attribute, kAttributes> trail_attributes_{};
    scene::Attribute wind_speed_;
    scene::Layer trail_, winds_;

    base::Span<scene::ScenePoint> points_;
    base::Span<std::uint32_t> starts_;
    std::array<base::Span<float>, kAttributes> values_{};
    base::Span<flight::FlownPoint> measured_;  ///< winds, with heights over the ellipsoid
    base::Span<scene::SelectedGlyph> glyphs_;
    base::Duration ahead_;  ///< the flight's time minus the source's
    std::uint32_t point_count_ = 0, part_count_ = 0, wind_count_ = 0;
};

}  // namespace tedavis::display
