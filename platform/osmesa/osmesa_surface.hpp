/// Mesa's off-screen renderer on the processor: colour in memory of its own, 24-bit depth, no window system, no device.
///
/// The library is loaded at run time because it exports every gl* name and would shadow EGL's. Mesa 25.1 dropped it, so
/// nothing may depend on it. The context is desktop GL with the compatibility profile, whose pictures are the same, bit by
/// bit, as those of headless EGL of the same Mesa build.
///
/// Thread  one. Memory  allocates when made.
#pragma once

#include <memory>

#include "platform/surface_settings.hpp"
#include "render_core/base/error.hpp"
#include "render_core/base/ports/surface.hpp"
#include "render_core/base/result.hpp"

namespace tedavis::platform {

/// The surface is not current yet. Refused in one sentence when the build or the machine has no OSMesa.
[[nodiscard]] base::Result<std::unique_ptr<base::Surface>, base::Error> make_osmesa_surface(const SurfaceSettings& settings);

}  // namespace tedavis::platform
