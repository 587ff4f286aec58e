/// Makes a surface by the name that the command line and the configs use.
#pragma once

#include <memory>
#include <string_view>

#include "platform/surface_settings.hpp"
#include "render_core/base/error.hpp"
#include "render_core/base/ports/surface.hpp"
#include "render_core/base/result.hpp"

namespace tedavis::platform {

/// `backend` is "egl" or "osmesa". The surface is not current yet; one surface at a time is current on a thread. An unknown
/// name, an impossible size and a machine without the backend are refused in one sentence. Start-up only (allocates).
[[nodiscard]] base::Result<std::unique_ptr<base::Surface>, base::Error> make_surface(std::string_view backend,
                                                                                     const SurfaceSettings& settings);

}  // namespace tedavis::platform
