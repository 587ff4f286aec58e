/// Other aircraft that the own one receives (flight/traffic.hpp) as spatial data: a layer "received_traffic" of the role traffic,
/// so that the techniques for that role show it beside the scene's.
///
///   start(arena) · take(traffic, ahead) each frame · layer(): stays at its place
///
/// An aircraft is a line: the path that it has flown, and its last report as two points kBefore apart, whose difference is the
/// stated velocity. Heights are over the ellipsoid. Its points have the attributes "position_accuracy" and "height_accuracy" (m,
/// 95 %), missing where the report states none. Its name is its callsign, else its address in hexadecimal.
///
/// Memory  from an arena, once. Thread  the display's. Failure  start() false where the arena is too small.
#pragma once

#include <array>

#include "render_core/base/memory_budget.hpp"
#include "render_core/flight/traffic.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::display {

class TrafficLayer {
public:
    static constexpr base::Duration kBefore = base::Duration::milliseconds(100);
    static constexpr std::size_t kMaxPoints = flight::kMaxTraffic * (flight::kMaxTrafficPlaces + 2);
    static constexpr std::size_t kAttributes = 2;

    TrafficLayer();
    TrafficLayer(const TrafficLayer&) = delete;  // the layer points into it
    TrafficLayer& operator=(const TrafficLayer&) = delete;

    [[nodiscard]] bool start(base::Arena& arena);
    /// `ahead`: the flight's time, in which the layer states times, minus the source's time.
    void take(const flight::Traffic& traffic, base::Duration ahead);

    [[nodiscard]] const scene::Layer& layer() const { return layer_; }

private:
    void add(const flight::TrafficReport& report);
    void add_point(const flight::TrafficPlace& place);

    scene::LayerEntry entry_{};
    std::array<scene::AttributeEntry, kAttributes> attribute_entries_{};
    std::array<scene::Attribute, kAttributes> attributes_{};
    scene::Layer layer_;

    base::Span<scene::ScenePoint> points_;
    base::Span<std::uint32_t> starts_;
    base::Span<char> names_;
    std::array<base::Span<float>, kAttributes> values_{};
    base::Duration ahead_;
    std::uint32_t point_count_ = 0, aircraft_count_ = 0;
};

}  // namespace tedavis::display
