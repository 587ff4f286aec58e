/// A GL ES context on a screen that the kernel drives: EGL on GBM buffers, shown by KMS without a window system.
///
/// present() returns once the screen shows the frame, or after kFlipLimit at the latest. A screen that is unplugged or taken away
/// is no failure: present() returns `ready`, the frame is not shown, and the report counts it.
///
/// Thread   one. Memory  allocates when created.
/// Failure  one sentence: no card, no permission, a card without screens, no such driver, connector or mode, nothing connected,
///          a picture of another size than the mode, a screen that another program has, a driver without a context.
#pragma once

#include <memory>

#include "platform/egl_kms/screen_settings.hpp"
#include "platform/surface_settings.hpp"
#include "render_core/base/error.hpp"
#include "render_core/base/ports/surface.hpp"
#include "render_core/base/result.hpp"

namespace tedavis::platform {

/// The returned surface is not current yet; the screen is black. Where libgbm and libdrm were missing at the build, this fails.
[[nodiscard]] base::Result<std::unique_ptr<base::Surface>, base::Error> make_egl_kms_surface(const SurfaceSettings& settings,
                                                                                             const ScreenSettings& screen);

}  // namespace tedavis::platform
