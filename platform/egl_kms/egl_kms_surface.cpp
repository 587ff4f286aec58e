#include "platform/egl_kms/egl_kms_surface.hpp"

#if defined(TEDAVIS_HAVE_KMS)

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstring>
#include <new>
#include <optional>

#include "platform/current_surface.hpp"
#include "platform/egl_headless/egl_display.hpp"
#include "platform/egl_headless/reset_status.hpp"
#include "platform/egl_kms/drm_inventory.hpp"
#include "platform/egl_kms/gbm_buffers.hpp"
#include "platform/egl_kms/scanout.hpp"
#include "platform/egl_kms/seat_offer.hpp"
#include "render_core/base/driver_scope.hpp"

namespace tedavis::platform {
namespace {

EGLDisplay gbm_display(gbm_device* device) {
    const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (get_display == nullptr) return EGL_NO_DISPLAY;
    EGLDisplay display = get_display(EGL_PLATFORM_GBM_KHR, device, nullptr);
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) return EGL_NO_DISPLAY;
    return display;
}

/// One whose buffers are XRGB8888, as the screen reads them: other configurations of eight bits a color may hold other orders.
EGLConfig gbm_config(EGLDisplay display, ContextLane lane) {
    const EGLint renderable = lane == ContextLane::es3 ? EGL_OPENGL_ES3_BIT_KHR : EGL_OPENGL_ES2_BIT;
    const EGLint attributes[] = {EGL_SURFACE_TYPE,
                                 EGL_WINDOW_BIT,
                                 EGL_RENDERABLE_TYPE,
                                 renderable,
                                 EGL_RED_SIZE,
                                 8,
                                 EGL_GREEN_SIZE,
                                 8,
                                 EGL_BLUE_SIZE,
                                 8,
                                 EGL_DEPTH_SIZE,
                                 24,
                                 EGL_SAMPLE_BUFFERS,
                                 0,
                                 EGL_NONE};
    constexpr EGLint kMaxConfigs = 128;
    EGLConfig configs[kMaxConfigs] = {};
    EGLint count = 0;
    if (eglChooseConfig(display, attributes, configs, kMaxConfigs, &count) != EGL_TRUE) return nullptr;
    for (EGLint n = 0; n < count; ++n) {
        EGLint visual = 0;
        if (eglGetConfigAttrib(display, configs[n], EGL_NATIVE_VISUAL_ID, &visual) == EGL_TRUE &&
            static_cast<std::uint32_t>(visual) == GBM_FORMAT_XRGB8888)
            return configs[n];
    }
    return nullptr;
}

class EglKmsSurface final : public base::Surface {
public:
    EglKmsSurface(const SurfaceSettings& settings, const ScreenSettings& screen)
        : settings_(settings), screen_(screen), report_(screen.report != nullptr ? *screen.report : own_report_) {}
    ~EglKmsSurface() override {
        release_current();
        if (scanout_) scanout_->stop();
        if (is_lit_) card_.restore();
        if (scanout_) scanout_->let_go();
        const base::DriverScope driver;
        if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
        if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
        if (display_ != EGL_NO_DISPLAY) eglTerminate(display_);
        buffers_.close();
    }
    EglKmsSurface(const EglKmsSurface&) = delete;
    EglKmsSurface& operator=(const EglKmsSurface&) = delete;

    /// An empty sentence when all is there. Only the last step changes what the screen shows.
    [[nodiscard]] base::Error create() {
        if (base::Error error = open_screen()) return error;
        if (base::Error error = buffers_.open(card_, settings_.width_px, settings_.height_px)) return error;
        if (const char* const missing = create_context()) return base::make_error(missing);
        is_lit_ = true;
        if (base::Error error = card_.show_black()) {
            report_.may_come = card_.is_held();
            return error;
        }
        scanout_->mode_is_set();
        report_.is_atomic = card_.is_atomic();
        return {};
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
        if (!swap()) return eglGetError() == EGL_CONTEXT_LOST ? base::SurfaceState::context_lost : base::SurfaceState::failed;
        if (reset_.is_lost()) return base::SurfaceState::context_lost;
        const bool is_shown = scanout_->show();
        report_.manager_end = card_.manager_end();
        return is_shown ? base::SurfaceState::ready : base::SurfaceState::failed;
    }

    const char* backend_name() const override { return "kms"; }

private:
    /// Waits for the GPU: its work is the frame's, not a wait for the screen.
    [[nodiscard]] bool swap() {
        const base::DriverScope driver;
        return eglSwapBuffers(display_, surface_) == EGL_TRUE && eglWaitClient() == EGL_TRUE;
    }

    [[nodiscard]] base::Error open_screen() {
        const std::unique_ptr<ScreenInventory> inventory(new (std::nothrow) ScreenInventory());
        if (inventory == nullptr) return base::make_error("no memory for a list of screens; free some");
        list_screens(screen_.path.view(), *inventory);
        const auto choice = choose_screen(*inventory, screen_, settings_.width_px, settings_.height_px);
        report_ = {};
        if (!choice.ok()) report_.may_come = choice.error().may_come;
        if (!choice.ok()) return choice.error().error;
        const ScreenCard& card = inventory->cards[choice.value().card];
        const ScreenMode& mode = choice.value().mode;
        report_.driver = card.driver;
        report_.connector = card.connectors[choice.value().connector].name;
        report_.mode = mode_text(mode.width_px, mode.height_px, mode.refresh_mhz);
        report_.refresh_mhz = mode.refresh_mhz;
        scanout_.emplace(card_, buffers_, report_, mode.refresh_mhz);
        return open_card(card, choice.value());
    }

    [[nodiscard]] base::Error open_card(const ScreenCard& card, const ScreenChoice& choice) {
        const SeatOffer offer = find_seat();
        base::Error error = card_.open(card, choice, offer.is_there ? make_libseat_port() : nullptr);
        report_.may_come = card_.is_held();
        report_.seat_manager = card_.seat_manager();
        if (report_.seat_manager.empty()) report_.seat_note = offer.text.view();
        if (report_.seat_manager.empty() && offer.is_there) say_refusal(report_.seat_note);
        return error;
    }

    void say_refusal(base::FixedString<255>& note) const {
        note.append(" does not give the card");
        if (card_.seat_fault() == 0) return;
        note.append(" (");
        note.append(std::strerror(card_.seat_fault()));
        note.append(")");
    }

    /// Null when all is there, else what is missing.
    [[nodiscard]] const char* create_context() {
        const base::DriverScope driver;
        display_ = gbm_display(buffers_.device());
        if (display_ == EGL_NO_DISPLAY) return "EGL cannot draw for this graphics card (no platform GBM); install libegl-mesa0";
        EGLConfig config = gbm_config(display_, settings_.lane);
        if (config == nullptr)
            return "EGL has no XRGB8888 configuration with 24-bit depth for this lane; use a device of the other lane";
        eglBindAPI(EGL_OPENGL_ES_API);
        surface_ = eglCreateWindowSurface(display_, config, reinterpret_cast<EGLNativeWindowType>(buffers_.surface()), nullptr);
        if (surface_ == EGL_NO_SURFACE) return "EGL refuses the screen's buffers; use another mode of [screen]";
        context_ = create_es_context(display_, config, settings_.lane);
        if (context_ == EGL_NO_CONTEXT) return "EGL refuses a GL ES context of this lane; use a device of the other lane";
        return nullptr;
    }

    SurfaceSettings settings_;
    ScreenSettings screen_;
    ScreenReport own_report_;
    ScreenReport& report_;
    DrmCard card_;
    std::optional<Scanout> scanout_;  // outlives the buffers: it is told of the end of each
    GbmBuffers buffers_;
    bool is_lit_ = false;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLSurface surface_ = EGL_NO_SURFACE;
    EGLContext context_ = EGL_NO_CONTEXT;
    ResetStatus reset_;
};

}  // namespace

base::Result<std::unique_ptr<base::Surface>, base::Error> make_egl_kms_surface(const SurfaceSettings& settings,
                                                                               const ScreenSettings& screen) {
    if (!size_is_possible(settings))
        return base::fail(base::make_error("the picture's edges must be 16 to 16384 pixels; give such a size"));
    std::unique_ptr<EglKmsSurface> surface(new (std::nothrow) EglKmsSurface(settings, screen));
    if (surface == nullptr) return base::fail(base::make_error("no memory for a surface on the screen; free some"));
    const base::Error error = surface->create();
    if (error) return base::fail(error);
    return std::unique_ptr<base::Surface>(std::move(surface));
}

}  // namespace tedavis::platform

#else

namespace tedavis::platform {

base::Result<std::unique_ptr<base::Surface>, base::Error> make_egl_kms_surface(const SurfaceSettings&, const ScreenSettings&) {
    return base::fail(base::make_error(
        "this build shows nothing on a screen; install libgbm-dev and libdrm-dev and build again, or use backend = \"egl\""));
}

}  // namespace tedavis::platform

#endif
