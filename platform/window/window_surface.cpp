#include "platform/window/window_surface.hpp"

#if defined(TEDAVIS_HAVE_SDL2)

#include <SDL.h>

#include <cstring>
#include <new>

#include "platform/current_surface.hpp"
#include "platform/window/window_event_translation.hpp"
#include "render_core/base/driver_scope.hpp"

namespace tedavis::platform {
namespace {

base::Error sdl_error(const char* what) {
    return base::make_error(what, SDL_GetError(), "; start it on a desk with a screen, or leave out --window");
}

bool shows_nothing(const char* driver) {
    return driver == nullptr || std::strcmp(driver, "offscreen") == 0 || std::strcmp(driver, "dummy") == 0 ||
           std::strcmp(driver, "evdev") == 0;
}

void ask_for_context(ContextLane lane) {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, lane == ContextLane::es3 ? 3 : 2);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
    for (SDL_GLattr color : {SDL_GL_RED_SIZE, SDL_GL_GREEN_SIZE, SDL_GL_BLUE_SIZE}) SDL_GL_SetAttribute(color, 8);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
}

class SdlWindow final : public Window {
public:
    explicit SdlWindow(const SurfaceSettings& settings) : settings_(settings) {}
    ~SdlWindow() override {
        release_current();
        const base::DriverScope driver;
        if (context_ != nullptr) SDL_GL_DeleteContext(context_);
        if (window_ != nullptr) SDL_DestroyWindow(window_);
        if (started_) SDL_QuitSubSystem(SDL_INIT_VIDEO);
    }
    SdlWindow(const SdlWindow&) = delete;
    SdlWindow& operator=(const SdlWindow&) = delete;

    /// An empty sentence when the window is open.
    [[nodiscard]] base::Error create(const char* title) {
        const base::DriverScope driver;
        SDL_SetHint(SDL_HINT_VIDEO_X11_FORCE_EGL, "1");  // GL ES from EGL, never from GLX
        SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");   // Ctrl-C belongs to the composition root
        if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) return sdl_error("no window can be opened: ");
        started_ = true;
        const char* video = SDL_GetCurrentVideoDriver();
        if (shows_nothing(video))
            return base::make_error("no window can be opened: there is no screen (SDL offers only its driver '",
                                    video == nullptr ? "none" : video,
                                    "'); start it on a desk with a screen, or leave out --window");
        ask_for_context(settings_.lane);
        window_ = SDL_CreateWindow(title, SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, static_cast<int>(settings_.width_px),
                                   static_cast<int>(settings_.height_px), SDL_WINDOW_OPENGL);
        if (window_ == nullptr) return sdl_error("no window can be opened: ");
        context_ = SDL_GL_CreateContext(window_);
        if (context_ == nullptr) return sdl_error("the window has no GL ES context: ");
        SDL_GL_MakeCurrent(window_, nullptr);
        return {};
    }

    std::uint32_t width() const override { return settings_.width_px; }
    std::uint32_t height() const override { return settings_.height_px; }

    bool make_current() override {
        if (!claim_current(this)) return false;
        const base::DriverScope driver;
        if (SDL_GL_MakeCurrent(window_, context_) == 0) return true;
        drop_current(this);
        return false;
    }

    void release_current() override {
        if (!is_current(this)) return;
        const base::DriverScope driver;
        SDL_GL_MakeCurrent(window_, nullptr);
        drop_current(this);
    }

    void* proc_address(const char* name) override {
        const base::DriverScope driver;
        return SDL_GL_GetProcAddress(name);
    }

    base::SurfaceState present() override {
        if (!is_current(this)) return base::SurfaceState::failed;
        const base::DriverScope driver;
        SDL_GL_SwapWindow(window_);
        return base::SurfaceState::ready;
    }

    const char* backend_name() const override { return "window"; }

    std::size_t poll_events(base::Span<WindowEvent> out) override {
        const base::DriverScope driver;
        std::size_t count = 0;
        SDL_Event event;
        while (count < out.size() && SDL_PollEvent(&event) != 0)
            if (translate_event(event, out[count])) ++count;
        return count;
    }

    void set_title(const char* title) override {
        const base::DriverScope driver;
        SDL_SetWindowTitle(window_, title);
    }

private:
    SurfaceSettings settings_;
    SDL_Window* window_ = nullptr;
    SDL_GLContext context_ = nullptr;
    bool started_ = false;
};

}  // namespace

base::Result<std::unique_ptr<Window>, base::Error> make_window(const SurfaceSettings& settings, const char* title) {
    if (!size_is_possible(settings))
        return base::fail(base::make_error("the picture's edges must be 16 to 16384 pixels; give such a --size"));
    if (any_current())  // SDL makes a new context current at once
        return base::fail(base::make_error("no window can be opened: another surface is current; release it first"));
    std::unique_ptr<SdlWindow> window(new (std::nothrow) SdlWindow(settings));
    if (window == nullptr) return base::fail(base::make_error("no memory for a window; free some"));
    const base::Error error = window->create(title);
    if (error) return base::fail(error);
    return std::unique_ptr<Window>(std::move(window));
}

}  // namespace tedavis::platform

#else

namespace tedavis::platform {

base::Result<std::unique_ptr<Window>, base::Error> make_window(const SurfaceSettings&, const char*) {
    return base::fail(base::make_error("this build has no window; install libsdl2-dev and build again, or leave out --window"));
}

}  // namespace tedavis::platform

#endif
