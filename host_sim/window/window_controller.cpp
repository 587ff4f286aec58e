#include "host_sim/window/window_controller.hpp"

namespace tedavis::host_sim {
namespace {

using platform::WindowEvent;
using platform::WindowEventKind;

constexpr base::Duration kSeek = base::Duration::seconds(5), kFarSeek = base::Duration::seconds(60);

/// Of an action that lasts while its key is held.
constexpr std::uint32_t bit_of(WindowAction action) {
    return std::uint32_t{1} << (static_cast<unsigned>(action) - static_cast<unsigned>(WindowAction::fly_forward));
}

base::Duration negative(base::Duration duration) { return {-duration.ns}; }

}  // namespace

WindowController::WindowController(const Transport& transport, std::uint32_t patterns, bool has_tour)
    : transport_(transport), patterns_(patterns), has_tour_(has_tour), mode_(has_tour ? CameraMode::tour : CameraMode::cockpit) {}

void WindowController::handle(const WindowEvent& event) {
    switch (event.kind) {
        case WindowEventKind::closed: closed_ = true; break;
        case WindowEventKind::key_down: press(event); break;
        case WindowEventKind::key_up: set_held(meaning_of_key(event).action, false); break;
        case WindowEventKind::mouse_move:
            if (event.button == platform::MouseButton::left && mode_ == CameraMode::free)
                camera_.look(-event.dx_px / focal_px_, event.dy_px / focal_px_);
            break;
        case WindowEventKind::mouse_wheel:
            if (mode_ == CameraMode::free) camera_.change_speed(event.dy_px);
            break;
        case WindowEventKind::mouse_down:
        case WindowEventKind::mouse_up: break;
    }
}

void WindowController::press(const WindowEvent& event) {
    const KeyMeaning meaning = meaning_of_key(event);
    set_held(meaning.action, true);
    const bool goes_on_while_held = press_transport(meaning.action);
    if (!goes_on_while_held && !event.repeat) press_once(meaning);
}

bool WindowController::press_transport(WindowAction action) {
    switch (action) {
        case WindowAction::step_forward: transport_.step(1); return true;
        case WindowAction::step_back: transport_.step(-1); return true;
        case WindowAction::seek_forward: transport_.seek(kSeek); return true;
        case WindowAction::seek_back: transport_.seek(negative(kSeek)); return true;
        case WindowAction::seek_far_forward: transport_.seek(kFarSeek); return true;
        case WindowAction::seek_far_back: transport_.seek(negative(kFarSeek)); return true;
        case WindowAction::to_start: transport_.to_start(); return true;
        case WindowAction::to_end: transport_.to_end(); return true;
        case WindowAction::faster: transport_.faster(); return true;
        case WindowAction::slower: transport_.slower(); return true;
        case WindowAction::normal_speed: transport_.normal_speed(); return true;
        default: return false;
    }
}

void WindowController::press_once(const KeyMeaning& meaning) {
    switch (meaning.action) {
        case WindowAction::close: closed_ = true; break;
        case WindowAction::play_or_pause: transport_.play_or_pause(); break;
        case WindowAction::reverse: transport_.reverse(); break;
        case WindowAction::switch_pattern: select(meaning.pattern); break;
        case WindowAction::next_pattern: select(pattern_ ? (*pattern_ + 1) % patterns_ : 0); break;
        case WindowAction::previous_pattern: select(pattern_.value_or(0) == 0 ? patterns_ - 1 : *pattern_ - 1); break;
        case WindowAction::next_legend: ask_next_legend(); break;
        case WindowAction::free_camera: toggle(CameraMode::free); break;
        case WindowAction::tour:
            if (has_tour_) toggle(CameraMode::tour);
            break;
        default: press_shown(meaning.action); break;
    }
}

/// What lies over the picture, and the picture itself. Where nobody flies the camera back, its key is free.
void WindowController::press_shown(WindowAction action) {
    switch (action) {
        case WindowAction::show_accuracy: accuracy_.figures = !accuracy_.figures; break;
        case WindowAction::error_map: accuracy_.error_map = !accuracy_.error_map; break;
        case WindowAction::light: toggle_light(); break;
        case WindowAction::head_up: shows_head_up_ = !shows_head_up_; break;
        case WindowAction::help:
            shows_help_ = !shows_help_;
            help_ = help_ || shows_help_;
            break;
        case WindowAction::fly_back: screenshot_ = screenshot_ || mode_ != CameraMode::free; break;
        case WindowAction::screenshot: screenshot_ = true; break;
        default: break;
    }
}

void WindowController::select(std::uint32_t pattern) {
    if (pattern >= patterns_) return;
    pattern_ = wanted_pattern_ = pattern;
}

/// Key, whole, none, and the key again.
void WindowController::ask_next_legend() {
    using flight::LegendShow;
    const LegendShow now = asked_legend_.value_or(legend_);
    asked_legend_ = now == LegendShow::key ? LegendShow::whole : now == LegendShow::whole ? LegendShow::none : LegendShow::key;
}

void WindowController::toggle(CameraMode mode) {
    mode_ = mode_ == mode ? CameraMode::cockpit : mode;
    if (mode_ == CameraMode::free) camera_.place(pose_);
}

void WindowController::toggle_light() {
    light_ = light_ == design::SymbologyLight::day ? design::SymbologyLight::night : design::SymbologyLight::day;
}

void WindowController::set_held(WindowAction action, bool held) {
    if (action < WindowAction::fly_forward || action > WindowAction::fly_down) return;
    held_ = held ? held_ | bit_of(action) : held_ & ~bit_of(action);
}

void WindowController::advance(base::Duration wall) {
    transport_.advance(wall);
    if (mode_ != CameraMode::free) return;
    const auto held = [this](WindowAction action) { return (held_ & bit_of(action)) != 0 ? 1 : 0; };
    camera_.fly(
        {held(WindowAction::fly_forward) - held(WindowAction::fly_back),
         held(WindowAction::fly_right) - held(WindowAction::fly_left), held(WindowAction::fly_up) - held(WindowAction::fly_down)},
        wall);
}

void WindowController::record_picture(const CameraPose& pose, double focal_px) {
    pose_ = pose;
    focal_px_ = focal_px;
}

std::optional<std::uint32_t> WindowController::take_pattern() {
    const auto wanted = wanted_pattern_;
    wanted_pattern_.reset();
    return wanted;
}

bool WindowController::take_screenshot() {
    const bool wanted = screenshot_;
    screenshot_ = false;
    return wanted;
}

bool WindowController::take_help() {
    const bool wanted = help_;
    help_ = false;
    return wanted;
}

}  // namespace tedavis::host_sim
