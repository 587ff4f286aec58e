/// EGL without a window system: displays, configurations, contexts.
#pragma once

#include <EGL/egl.h>

#include "platform/surface_settings.hpp"

namespace tedavis::platform {

/// Whole-word search in a blank-separated extension list; false for a null list.
[[nodiscard]] bool has_egl_extension(const char* list, const char* name) noexcept;

/// Returns an initialised display that supports pixel buffers, or EGL_NO_DISPLAY. The display is never terminated: EGL returns
/// the same one again for the life of the process.
[[nodiscard]] EGLDisplay find_headless_display();

/// Returns a configuration with RGBA8, 24-bit depth and pixel buffers for the ES version (2 or 3), or null.
[[nodiscard]] EGLConfig find_headless_config(EGLDisplay display, int es_version);

/// Returns the sentence about a display that has no such configuration for the lane.
[[nodiscard]] const char* missing_headless_config(EGLDisplay display, ContextLane lane);

/// Returns a context of the lane, or EGL_NO_CONTEXT. Where the driver has EGL_EXT_create_context_robustness, it is lost on a GPU
/// reset instead of drawing undefined content.
[[nodiscard]] EGLContext create_es_context(EGLDisplay display, EGLConfig config, ContextLane lane);

}  // namespace tedavis::platform
