/// The own aircraft's flight as spatial data: its flown way and the air that it has measured, as layers like those of a scene, so
/// that the techniques for them show them.
///
///   start(arena) · take(frame) each frame · trail(), winds(): layers that stay at their places
///
/// The trail is a line a part of the way (flight/flight_trail.hpp), up to the own ship, with the attributes of its points
/// "position_accuracy" and "height_accuracy" (m, 95 %), "wind_speed" (m/s), "temperature" (K); missing where they were not
/// stated. Where no accuracy was, kUnstatedAccuracy_m is the layer's: unknown must not look certain. Winds stand where they were
/// measured every kWindEvery points, and at the own ship; there are none while the aircraft states no valid wind. Heights by
/// pressure are those over MSL on the geoid.
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
    const flight::FlightTrail* way = nullptr;  ///< null: nobody keeps it, and there is nothing to show
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
    /// Of winds(), relative to an eye in ECEF; valid until the next call.
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
    base::Duration ahead_;  ///< of the flight's time before the source's
    std::uint32_t point_count_ = 0, part_count_ = 0, wind_count_ = 0;
};

}  // namespace tedavis::display
