/// Settings that favour one of what a picture costs (thesis 6.2.2.3). A design may start from one and change single operators.
#pragma once

#include "render_core/raytrace/picture/trace_settings.hpp"

namespace tedavis::raytrace {

/// Shortest time: the vector kernel on the true surface, Lambert's light, nothing besides. Spends: two bounds a cell, 4/3 Height.
/// Saves: every ray but the first, and all maps.
[[nodiscard]] TraceSettings time_preset();

/// Best picture: bicubic patches, met exactly; apertures and cast shadows; supersampling; one mirror. Spends: time above all
/// (each ray alone, in double), 7 bytes a post for the apertures. Saves nothing.
[[nodiscard]] TraceSettings quality_preset();

/// Least memory: nothing but heights and their maxima. What maps would hold is left out (sky view) or paid for by rays (shadows;
/// supersampling instead of the average mipmap). Spends: time where rays are many. Give it int16 heights.
[[nodiscard]] TraceSettings memory_preset();

}  // namespace tedavis::raytrace
