#include "platform/egl_headless/egl_display.hpp"

#include <EGL/eglext.h>

#include <cstring>

namespace tedavis::platform {
namespace {

template <class Function>
Function egl_function(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

/// The display when it initialises and offers what the surface needs, else EGL_NO_DISPLAY.
EGLDisplay usable(EGLDisplay display) {
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) return EGL_NO_DISPLAY;
    return find_headless_config(display, 2) != nullptr ? display : EGL_NO_DISPLAY;
}

EGLDisplay surfaceless_display(const char* extensions) {
    const auto get_display = egl_function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    if (get_display == nullptr || !has_egl_extension(extensions, "EGL_MESA_platform_surfaceless")) return EGL_NO_DISPLAY;
    return usable(get_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr));
}

EGLDisplay device_display(const char* extensions) {
    const auto get_display = egl_function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    const auto query_devices = egl_function<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    if (get_display == nullptr || query_devices == nullptr || !has_egl_extension(extensions, "EGL_EXT_platform_device"))
        return EGL_NO_DISPLAY;
    constexpr EGLint kMaxDevices = 16;
    EGLDeviceEXT devices[kMaxDevices] = {};
    EGLint count = 0;
    if (query_devices(kMaxDevices, devices, &count) != EGL_TRUE) return EGL_NO_DISPLAY;
    for (EGLint i = 0; i < count; ++i) {
        EGLDisplay display = usable(get_display(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
        if (display != EGL_NO_DISPLAY) return display;
    }
    return EGL_NO_DISPLAY;
}

constexpr EGLint kDepthBits = 24;

EGLConfig headless_config_with_depth(EGLDisplay display, int es_version, EGLint depth_bits) {
    const EGLint renderable = es_version >= 3 ? EGL_OPENGL_ES3_BIT_KHR : EGL_OPENGL_ES2_BIT;
    const EGLint attributes[] = {EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT,
                                 EGL_RENDERABLE_TYPE,
                                 renderable,
                                 EGL_RED_SIZE,
                                 8,
                                 EGL_GREEN_SIZE,
                                 8,
                                 EGL_BLUE_SIZE,
                                 8,
                                 EGL_ALPHA_SIZE,
                                 8,
                                 EGL_DEPTH_SIZE,
                                 depth_bits,
                                 EGL_SAMPLE_BUFFERS,
                                 0,
                                 EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, attributes, &config, 1, &count) != EGL_TRUE || count < 1) return nullptr;
    return config;
}

}  // namespace

bool has_egl_extension(const char* list, const char* name) noexcept {
    if (list == nullptr || *name == '\0') return false;
    const std::size_t length = std::strlen(name);
    for (const char* p = std::strstr(list, name); p != nullptr; p = std::strstr(p + length, name)) {
        const bool starts = p == list || p[-1] == ' ';
        if (starts && (p[length] == ' ' || p[length] == '\0')) return true;
    }
    return false;
}

EGLDisplay find_headless_display() {
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    EGLDisplay surfaceless = surfaceless_display(extensions);
    if (surfaceless != EGL_NO_DISPLAY) return surfaceless;
    EGLDisplay device = device_display(extensions);
    if (device != EGL_NO_DISPLAY) return device;
    return usable(eglGetDisplay(EGL_DEFAULT_DISPLAY));
}

EGLConfig find_headless_config(EGLDisplay display, int es_version) {
    return headless_config_with_depth(display, es_version, kDepthBits);
}

const char* missing_headless_config(EGLDisplay display, ContextLane lane) {
    const int version = lane == ContextLane::es3 ? 3 : 2;
    if (headless_config_with_depth(display, version, 0) != nullptr)
        return "EGL has no RGBA8 configuration with 24-bit depth for this lane; use another GL ES driver, or a device of the "
               "other "
               "lane";
    return version == 3 ? "EGL has no GL ES 3 on this machine; use a device of the lane es2, or install another GL ES driver"
                        : "EGL has no GL ES 2 on this machine; use a device of the lane es3, or install another GL ES driver";
}

EGLContext create_es_context(EGLDisplay display, EGLConfig config, ContextLane lane) {
    const EGLint version = lane == ContextLane::es3 ? 3 : 2;
    const EGLint robust[] = {EGL_CONTEXT_CLIENT_VERSION,
                             version,
                             EGL_CONTEXT_OPENGL_ROBUST_ACCESS_EXT,
                             EGL_TRUE,
                             EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT,
                             EGL_LOSE_CONTEXT_ON_RESET_EXT,
                             EGL_NONE};
    const EGLint plain[] = {EGL_CONTEXT_CLIENT_VERSION, version, EGL_NONE};
    EGLContext context = EGL_NO_CONTEXT;
    if (has_egl_extension(eglQueryString(display, EGL_EXTENSIONS), "EGL_EXT_create_context_robustness"))
        context = eglCreateContext(display, config, EGL_NO_CONTEXT, robust);
    return context != EGL_NO_CONTEXT ? context : eglCreateContext(display, config, EGL_NO_CONTEXT, plain);
}

}  // namespace tedavis::platform
