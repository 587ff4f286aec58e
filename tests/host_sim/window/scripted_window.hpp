/// A window without a screen: the surface is headless, the person is a list of events.
#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "platform/surface_factory.hpp"
#include "platform/window/window_surface.hpp"

namespace tedavis::test_support {

class ScriptedWindow final : public platform::Window {
public:
    explicit ScriptedWindow(std::unique_ptr<base::Surface> surface) : surface_(std::move(surface)) {}

    /// What the next poll hands out.
    void press(platform::Key key, bool shift = false) { events_.push_back(key_event(key, '\0', shift)); }
    void press(char character, bool shift = false) { events_.push_back(key_event(platform::Key::character, character, shift)); }
    void send(const platform::WindowEvent& event) { events_.push_back(event); }
    /// Called with every picture that is shown.
    std::function<void()> on_present = [] {};
    [[nodiscard]] const std::string& title() const { return title_; }
    [[nodiscard]] int presented() const { return presented_; }

    [[nodiscard]] static platform::WindowEvent key_event(platform::Key key, char character = '\0', bool shift = false) {
        platform::WindowEvent event;
        event.kind = platform::WindowEventKind::key_down;
        event.key = key;
        event.character = character;
        event.shift = shift;
        return event;
    }

    std::size_t poll_events(base::Span<platform::WindowEvent> out) override {
        const std::size_t count = std::min(out.size(), events_.size());
        std::copy_n(events_.begin(), count, out.begin());
        events_.erase(events_.begin(), events_.begin() + static_cast<std::ptrdiff_t>(count));
        return count;
    }
    void set_title(const char* title) override { title_ = title; }
    std::uint32_t width() const override { return surface_->width(); }
    std::uint32_t height() const override { return surface_->height(); }
    bool make_current() override { return surface_->make_current(); }
    void release_current() override { surface_->release_current(); }
    void* proc_address(const char* name) override { return surface_->proc_address(name); }
    base::SurfaceState present() override {
        ++presented_;
        on_present();
        return surface_->present();
    }
    std::uint32_t framebuffer() const override { return surface_->framebuffer(); }
    const char* backend_name() const override { return "scripted window"; }

private:
    std::unique_ptr<base::Surface> surface_;
    std::deque<platform::WindowEvent> events_;
    std::string title_;
    int presented_ = 0;
};

}  // namespace tedavis::test_support
