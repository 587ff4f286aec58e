/// A GL ES context without a window system: an EGL pixel buffer with 24-bit depth.
///
/// Displays are tried in this order: Mesa's surfaceless platform, the EGL devices, the default display. Where the driver has
/// EGL_EXT_create_context_robustness, the context is lost on a GPU reset instead of drawing undefined content.
///
/// Thread  one. Memory  allocates when created.
#pragma once

#include <memory>

#include "platform/surface_settings.hpp"
#include "render_core/base/error.hpp"
#include "render_core/base/ports/surface.hpp"
#include "render_core/base/result.hpp"

namespace tedavis::platform {

/// The returned surface is not current yet.
[[nodiscard]] base::Result<std::unique_ptr<base::Surface>, base::Error> make_egl_headless_surface(
    const SurfaceSettings& settings);

}  // namespace tedavis::platform
