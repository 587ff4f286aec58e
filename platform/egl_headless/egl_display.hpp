/// Finds an EGL display that needs no window system.
#pragma once

#include <EGL/egl.h>

namespace tedavis::platform {

/// Whole-word search in a blank-separated extension list; false for a null list.
[[nodiscard]] bool has_egl_extension(const char* list, const char* name) noexcept;

/// Returns an initialised display that supports pixel buffers, or EGL_NO_DISPLAY. The display is never terminated: EGL returns
/// the same one again for the life of the process.
[[nodiscard]] EGLDisplay find_headless_display();

/// Returns a configuration with RGBA8, 24-bit depth and pixel buffers for the ES version (2 or 3), or null.
[[nodiscard]] EGLConfig find_headless_config(EGLDisplay display, int es_version);

}  // namespace tedavis::platform
