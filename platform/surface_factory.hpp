/// Creates a surface by the backend name of the command line and the configuration files.
#pragma once

#include <memory>
#include <string_view>

#include "platform/surface_settings.hpp"
#include "render_core/base/error.hpp"
#include "render_core/base/ports/surface.hpp"
#include "render_core/base/result.hpp"

namespace tedavis::platform {

/// `backend` is "egl" or "osmesa". The surface is not current yet; at most one surface is current on a thread. Fails with one
/// sentence for an unknown name, an impossible size and a machine without the backend. Start-up only (allocates).
[[nodiscard]] base::Result<std::unique_ptr<base::Surface>, base::Error> make_surface(std::string_view backend,
                                                                                     const SurfaceSettings& settings);

}  // namespace tedavis::platform
