/// The table of GL entry points and the properties of each call; both are generated from gl_calls.inc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "render_core/effects/device_capability.hpp"
#include "render_core/gl/gles_types.hpp"

namespace tedavis::gl {

struct CallTable {
// A type and a parameter list cannot stand in parentheses. NOLINTNEXTLINE(bugprone-macro-parentheses)
#define TEDAVIS_GL_CALL(result, name, arguments, devices, stage, origin) result(GL_APIENTRY* name) arguments;
#include "render_core/gl/gl_calls.inc"
#undef TEDAVIS_GL_CALL
};

enum class CallId : std::uint16_t {
#define TEDAVIS_GL_CALL(result, name, arguments, devices, stage, origin) name,
#include "render_core/gl/gl_calls.inc"
#undef TEDAVIS_GL_CALL
    count
};
inline constexpr std::size_t kCallCount = static_cast<std::size_t>(CallId::count);

/// Which device classes have a call.
enum class CallDevices : std::uint8_t { all, es, es3, sc2, es3_sc2 };
/// When a call may be made.
enum class CallStage : std::uint8_t { start, both, teardown };
/// The version or extension that a driver must offer to have a call.
enum class CallOrigin : std::uint8_t { es20, es30, storage, binary, robust };

struct CallDescription {
    const char* name;  ///< without the `gl` prefix
    CallDevices devices;
    CallStage stage;
    CallOrigin origin;
};

inline constexpr CallDescription kCalls[kCallCount] = {
#define TEDAVIS_GL_CALL(result, name, arguments, devices, stage, origin) \
    {#name, CallDevices::devices, CallStage::stage, CallOrigin::origin},
#include "render_core/gl/gl_calls.inc"
#undef TEDAVIS_GL_CALL
};

[[nodiscard]] constexpr const CallDescription& describe(CallId id) { return kCalls[static_cast<std::size_t>(id)]; }

/// Returns the call of a name, or CallId::count.
[[nodiscard]] CallId find_call(std::string_view name);
/// True where the device's list contains the call: its class, plus `also`, minus `never`.
[[nodiscard]] bool device_has(const effects::GlRules& rules, CallId id);

}  // namespace tedavis::gl
