/// A GL ES context without a window system: an EGL pixel buffer with 24-bit depth.
///
/// Tried in this order: Mesa's surfaceless platform, the EGL devices, the default display. The context loses itself on a
/// reset instead of drawing nonsense where the driver can (EGL_EXT_create_context_robustness).
///
/// Thread  one. Memory  allocates when made.
#pragma once

#include <memory>

#include "platform/surface_settings.hpp"
#include "render_core/base/error.hpp"
#include "render_core/base/ports/surface.hpp"
#include "render_core/base/result.hpp"

namespace tedavis::platform {

/// The surface is not current yet.
[[nodiscard]] base::Result<std::unique_ptr<base::Surface>, base::Error> make_egl_headless_surface(
    const SurfaceSettings& settings);

}  // namespace tedavis::platform
