#include "platform/egl_headless/egl_headless_surface.hpp"

#include <EGL/egl.h>

#include <new>

#include "platform/current_surface.hpp"
#include "platform/egl_headless/egl_display.hpp"
#include "platform/egl_headless/reset_status.hpp"
#include "render_core/base/driver_scope.hpp"

namespace tedavis::platform {
namespace {

class EglHeadlessSurface final : public base::Surface {
public:
    explicit EglHeadlessSurface(const SurfaceSettings& settings) : settings_(settings) {}
    ~EglHeadlessSurface() override {
        release_current();
        const base::DriverScope driver;
        if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
        if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
    }
    EglHeadlessSurface(const EglHeadlessSurface&) = delete;
    EglHeadlessSurface& operator=(const EglHeadlessSurface&) = delete;

    /// Null when all is there, else what is missing.
    [[nodiscard]] const char* create() {
        const base::DriverScope driver;
        display_ = find_headless_display();
        if (display_ == EGL_NO_DISPLAY)
            return "EGL finds no display that works without a window system; install a GL ES driver (libegl-mesa0) or use --gl "
                   "osmesa";
        config_ = find_headless_config(display_, settings_.lane == ContextLane::es3 ? 3 : 2);
        if (config_ == nullptr) return missing_headless_config(display_, settings_.lane);
        const EGLint size[] = {EGL_WIDTH, static_cast<EGLint>(settings_.width_px), EGL_HEIGHT,
                               static_cast<EGLint>(settings_.height_px), EGL_NONE};
        surface_ = eglCreatePbufferSurface(display_, config_, size);
        if (surface_ == EGL_NO_SURFACE) return "EGL refuses a pixel buffer of this size; use a smaller --size";
        eglBindAPI(EGL_OPENGL_ES_API);
        context_ = create_es_context(display_, config_, settings_.lane);
        if (context_ == EGL_NO_CONTEXT) return "EGL refuses a GL ES context of this lane; use a device of the other lane";
        return nullptr;
    }

    std::uint32_t width() const override { return settings_.width_px; }
    std::uint32_t height() const override { return settings_.height_px; }

    bool make_current() override {
        if (!claim_current(this)) return false;
        const base::DriverScope driver;
        if (eglBindAPI(EGL_OPENGL_ES_API) == EGL_TRUE && eglMakeCurrent(display_, surface_, surface_, context_) == EGL_TRUE) {
            reset_.find(&eglGetProcAddress);
            return true;
        }
        drop_current(this);
        return false;
    }

    void release_current() override {
        if (!is_current(this)) return;
        const base::DriverScope driver;
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        drop_current(this);
    }

    void* proc_address(const char* name) override {
        const base::DriverScope driver;
        return reinterpret_cast<void*>(eglGetProcAddress(name));
    }

    base::SurfaceState present() override {
        if (!is_current(this)) return base::SurfaceState::failed;
        const base::DriverScope driver;
        if (eglWaitClient() == EGL_TRUE) return reset_.is_lost() ? base::SurfaceState::context_lost : base::SurfaceState::ready;
        return eglGetError() == EGL_CONTEXT_LOST ? base::SurfaceState::context_lost : base::SurfaceState::failed;
    }

    const char* backend_name() const override { return "egl"; }

private:
    SurfaceSettings settings_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLConfig config_ = nullptr;
    EGLSurface surface_ = EGL_NO_SURFACE;
    EGLContext context_ = EGL_NO_CONTEXT;
    ResetStatus reset_;
};

}  // namespace

base::Result<std::unique_ptr<base::Surface>, base::Error> make_egl_headless_surface(const SurfaceSettings& settings) {
    std::unique_ptr<EglHeadlessSurface> surface(new (std::nothrow) EglHeadlessSurface(settings));
    if (surface == nullptr) return base::fail(base::make_error("no memory for an EGL surface; free some"));
    if (const char* missing = surface->create()) return base::fail(base::make_error(missing));
    return std::unique_ptr<base::Surface>(std::move(surface));
}

}  // namespace tedavis::platform
