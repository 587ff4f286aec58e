/// Terrain with its look, as the scene of traced_light.hpp.
#pragma once

#include "render_core/raytrace/picture/trace_look.hpp"
#include "render_core/raytrace/picture/traced_terrain.hpp"
#include "render_core/raytrace/shading/traced_light.hpp"

namespace tedavis::raytrace {

/// All members are borrowed.
struct LitTerrain {
    const TracedTerrain* terrain = nullptr;
    const TraceLook* look = nullptr;
    GridScale scale;

    /// The returned scene refers to this object.
    [[nodiscard]] LitScene scene() const;
};

}  // namespace tedavis::raytrace
