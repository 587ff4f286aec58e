/// Terrain with its look, as traced_light.hpp follows paths through it.
#pragma once

#include "render_core/raytrace/picture/trace_look.hpp"
#include "render_core/raytrace/picture/traced_terrain.hpp"
#include "render_core/raytrace/shading/traced_light.hpp"

namespace tedavis::raytrace {

/// All borrowed.
struct LitTerrain {
    const TracedTerrain* terrain = nullptr;
    const TraceLook* look = nullptr;
    GridScale scale;

    /// Borrows this.
    [[nodiscard]] LitScene scene() const;
};

}  // namespace tedavis::raytrace
