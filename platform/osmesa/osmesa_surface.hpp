/// A surface of OSMesa, Mesa's off-screen software renderer: it owns its colour buffer, has 24-bit depth, and needs neither a
/// window system nor a device.
///
/// The library is loaded at run time because it exports every gl* name and would shadow EGL's. Mesa 25.1 removed it, so nothing
/// may depend on it. The context is desktop GL with the compatibility profile; its pictures equal those of headless EGL of the
/// same Mesa build bit for bit.
///
/// Thread  one. Memory  allocates when created.
#pragma once

#include <memory>

#include "platform/surface_settings.hpp"
#include "render_core/base/error.hpp"
#include "render_core/base/ports/surface.hpp"
#include "render_core/base/result.hpp"

namespace tedavis::platform {

/// The returned surface is not current yet. Fails with one sentence when the build or the machine has no OSMesa.
[[nodiscard]] base::Result<std::unique_ptr<base::Surface>, base::Error> make_osmesa_surface(const SurfaceSettings& settings);

}  // namespace tedavis::platform
