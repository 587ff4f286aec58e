/// Finds an EGL display that needs no window system.
#pragma once

#include <EGL/egl.h>

namespace tedavis::platform {

/// Whole-word search in a blank-separated extension list; false for a null list.
[[nodiscard]] bool has_egl_extension(const char* list, const char* name) noexcept;

/// An initialised display that has pixel buffers, or EGL_NO_DISPLAY. Displays live as long as the process (EGL hands out
/// the same one again), so nobody terminates them.
[[nodiscard]] EGLDisplay find_headless_display();

/// A configuration with RGBA8, 24-bit depth and pixel buffers for the ES version (2 or 3); null for none.
[[nodiscard]] EGLConfig find_headless_config(EGLDisplay display, int es_version);

}  // namespace tedavis::platform
