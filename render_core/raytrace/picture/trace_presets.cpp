#include "render_core/raytrace/picture/trace_presets.hpp"

namespace tedavis::raytrace {

TraceSettings time_preset() {
    TraceSettings settings;
    settings.surface.kind = SurfaceKind::two_triangles;
    return settings;
}

TraceSettings quality_preset() {
    TraceSettings settings;
    settings.surface.kind = SurfaceKind::bicubic;
    settings.antialiasing = Antialiasing::supersampling;
    settings.rays_along = 3;
    settings.shading = Shading::phong;
    settings.ambient = Ambient::apertures;
    settings.has_shadows = true;
    settings.mirrors = 1;
    return settings;
}

TraceSettings memory_preset() {
    TraceSettings settings;
    settings.surface.kind = SurfaceKind::bilinear;
    settings.antialiasing = Antialiasing::supersampling;
    settings.shading = Shading::phong;
    settings.has_shadows = true;
    return settings;
}

}  // namespace tedavis::raytrace
