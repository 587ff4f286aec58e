/// The look of a traced picture: lights, materials, data, trajectories. Colours are linear; lengths are metres in a frame with
/// the axes of grid space (GridScale). Borrowed memory must stay valid while pictures are drawn.
#pragma once

#include "render_core/raytrace/shading/data_color.hpp"
#include "render_core/raytrace/shading/local_light.hpp"
#include "render_core/raytrace/shading/ray_capsule.hpp"

namespace tedavis::raytrace {

/// Colour by height: linear between equally spaced colours, constant beyond the first and last.
struct GroundColors {
    base::Span<const glm::vec3> palette;  ///< empty: `material.color` everywhere
    float lowest = 0, highest = 1;        ///< height steps; must differ
};

struct TraceLook {
    DirectedLight sun;
    glm::vec3 sky{0.25f};        ///< light of the sky on the ground
    glm::vec3 background{0.6f};  ///< colour of rays without a hit
    Material material;           ///< of the ground; it reflects only up to `mirror_below`
    GroundColors ground;
    float mirror_below = std::numeric_limits<float>::lowest();  ///< height steps: water
    DataGrid values, uncertainties;
    DataLegend legend;
    base::Span<const Capsule> capsules;
    glm::vec3 capsule_color{1, 0.2f, 0.1f};
};

}  // namespace tedavis::raytrace
