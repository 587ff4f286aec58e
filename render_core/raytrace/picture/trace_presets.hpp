/// Settings that favour one of time, quality and memory (thesis 6.2.2.3). A design may start from one and change single
/// operators.
#pragma once

#include "render_core/raytrace/picture/trace_settings.hpp"

namespace tedavis::raytrace {

/// Shortest time: the vector kernel on the true surface with Lambert's light only. It needs the maximum mipmap (4/3 of
/// sizeof(Height) per cell) and neither secondary rays nor maps.
[[nodiscard]] TraceSettings time_preset();

/// Best picture: exact hits of bicubic patches, apertures and cast shadows, supersampling, one mirror. It needs much time (each
/// ray separately, in double) and 7 bytes per post for the apertures.
[[nodiscard]] TraceSettings quality_preset();

/// Least memory: only heights and their maxima. Maps are omitted (sky view) or replaced by rays (shadows; supersampling instead
/// of the average mipmap), which takes time. Use int16 heights.
[[nodiscard]] TraceSettings memory_preset();

}  // namespace tedavis::raytrace
