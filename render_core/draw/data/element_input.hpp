/// Input and result of the builders of data elements. Plain data; the ground is queried on the display's thread.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "render_core/base/display_units.hpp"
#include "render_core/design/data_element.hpp"
#include "render_core/earth/geodetic.hpp"
#include "render_core/policy/obstacle_alerts.hpp"
#include "render_core/scene/ground.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::draw {

class LayerFoci;

/// The own ship's place, for what depends on where it is.
struct OwnPlace {
    earth::Geodetic place;
    bool is_valid = false;    ///< false: unknown, or not current
    bool has_height = false;  ///< it is valid, and its height above the ellipsoid is known
};

struct ElementInput {
    const design::DataElement& element;
    std::uint8_t group = 0;  ///< group of this element and layer
    const scene::Layer& layer;
    scene::Ground& ground;
    design::Color missing;            ///< colour of a missing value
    std::int64_t time_ns = 0;         ///< the frame's time, which determines the position of moving features
    bool has_date = false;            ///< false: moving features stay at their position in the data
    glm::dvec3 eye{0};                ///< eye point, ECEF; for features that face the viewer
    double metres_per_px_m = 0;       ///< width of a pixel at a distance of 1 m
    bool has_age = true;              ///< false: the frame's time is extrapolated, and ages are unknown
    const LayerFoci* foci = nullptr;  ///< of this layer; null: everything is in the focus
    OwnPlace own_ship{};
    const policy::ObstacleAlerts* alerts = nullptr;  ///< of obstacles of the scene; null: this layer has none
    std::uint16_t layer_number = 0;                  ///< among the scene's, as the alerts count
    base::DisplayUnits units = base::DisplayUnits::feet_and_knots;
};

inline constexpr double kFloating_m = 5;  ///< height above the ground below which no link is drawn

/// Counts of an element's features (points of a field); each is counted exactly once.
struct ElementCount {
    std::uint32_t drawn = 0;
    std::uint32_t aggregated = 0;  ///< shown as part of an aggregate
    std::uint32_t hidden = 0;      ///< not drawn: no place, no room, out of view

    [[nodiscard]] std::uint32_t all() const { return drawn + aggregated + hidden; }
};

}  // namespace tedavis::draw
