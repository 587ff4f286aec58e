/// Reads what the driver of the current context reports about itself. Decisions from these facts are made elsewhere.
///
/// A non-null entry point does not prove that a function exists (Mesa returns stubs for unknown names), so the version and the
/// extension string decide.
#pragma once

#include <cstdint>
#include <type_traits>

#include "render_core/base/error.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/ports/surface.hpp"
#include "render_core/base/result.hpp"
#include "render_core/gl/call_table.hpp"

namespace tedavis::gl {

struct DriverFacts {
    base::FixedString<127> version, renderer, vendor;
    bool embedded = false;  ///< an ES context; else desktop GL (OSMesa)
    std::int32_t major = 0, minor = 0;
    std::int32_t depth_bits = 0;  ///< depth bits of the surface's framebuffer
    std::int32_t max_texture_px = 0;
    std::int32_t max_attributes = 0;
    std::int32_t max_texture_units = 0;
    std::int32_t max_vertex_texture_units = 0;
    std::int32_t program_binary_formats = 0;
    bool depth24_targets = false;
    bool texture_storage = false;
    bool program_binary = false;
    bool robustness = false;
};
static_assert(std::is_trivially_copyable_v<DriverFacts>);

/// Parses "OpenGL ES 3.2 Mesa 22.3.6" or "4.5 (Compatibility Profile) Mesa 22.3.6"; returns false when there is no number.
[[nodiscard]] bool parse_version(const char* text, DriverFacts& facts);
/// Whole-word search in a blank-separated list.
[[nodiscard]] bool has_extension(const char* list, const char* name);
[[nodiscard]] bool provides(const DriverFacts& facts, CallOrigin origin);

/// Probes the driver; the surface must be current.
[[nodiscard]] base::Result<DriverFacts, base::Error> probe_driver(base::Surface& surface);

}  // namespace tedavis::gl
