/// The state machine of the live window: converts events and time to the user's requests. Pure: no clock, no screen, no files, so
/// that tests run a session event by event.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "host_sim/options/accuracy_shown.hpp"
#include "host_sim/window/free_camera.hpp"
#include "host_sim/window/transport.hpp"
#include "host_sim/window/window_keys.hpp"
#include "platform/window/window_events.hpp"
#include "render_core/design/symbology_palette.hpp"
#include "render_core/flight/legend_show.hpp"

namespace tedavis::host_sim {

enum class CameraMode : std::uint8_t { cockpit, free, tour };

class WindowController {
public:
    /// `patterns` is the number of patterns of the switch panel. With a tour the camera begins on it.
    WindowController(const Transport& transport, std::uint32_t patterns, bool has_tour);

    void handle(const platform::WindowEvent& event);
    /// Advances playback and the free camera by the elapsed time `wall`.
    void advance(base::Duration wall);
    /// States the pose of the current picture, from which a free camera starts, and its focal length in pixels, by which the
    /// mouse turns the camera as far as the picture moves.
    void record_picture(const CameraPose& pose, double focal_px);

    /// States which parts of the overlay are shown; keys turn them on and off.
    void set_accuracy(const AccuracyShown& shown) { accuracy_ = shown; }

    /// States the light of the symbology; a key changes it.
    void set_light(design::SymbologyLight light) { light_ = light; }

    [[nodiscard]] bool closed() const { return closed_; }
    [[nodiscard]] const Transport& transport() const { return transport_; }
    [[nodiscard]] CameraMode camera_mode() const { return mode_; }
    [[nodiscard]] const FreeCamera& camera() const { return camera_; }
    [[nodiscard]] const AccuracyShown& accuracy() const { return accuracy_; }
    [[nodiscard]] design::SymbologyLight light() const { return light_; }
    /// States the legend that is shown unless the user requests another one.
    void set_legend(flight::LegendShow shown) { legend_ = shown; }
    /// The legend that the user has requested; nothing before the first request.
    [[nodiscard]] std::optional<flight::LegendShow> asked_legend() const { return asked_legend_; }
    /// Returns the pattern that was selected since the last call; nothing: none was.
    [[nodiscard]] std::optional<std::uint32_t> take_pattern();
    /// True where the list of keys was requested since the last call.
    [[nodiscard]] bool take_help();
    /// True where a picture of the shown frame was requested since the last call.
    [[nodiscard]] bool take_screenshot();
    /// Whether the list of keys, and the line with time and phase, are drawn over the picture.
    [[nodiscard]] bool shows_help() const { return shows_help_; }
    [[nodiscard]] bool shows_head_up() const { return shows_head_up_; }

private:
    void press(const platform::WindowEvent& event);
    [[nodiscard]] bool press_transport(WindowAction action);
    void press_once(const KeyMeaning& meaning);
    void press_shown(WindowAction action);
    void select(std::uint32_t pattern);
    void ask_next_legend();
    void set_held(WindowAction action, bool held);
    void toggle(CameraMode mode);
    void toggle_light();

    Transport transport_;
    std::uint32_t patterns_;
    bool has_tour_;
    bool closed_ = false, help_ = false, screenshot_ = false;
    bool shows_help_ = false, shows_head_up_ = true;
    CameraMode mode_ = CameraMode::cockpit;
    FreeCamera camera_;
    AccuracyShown accuracy_;
    design::SymbologyLight light_ = design::SymbologyLight::day;
    flight::LegendShow legend_ = flight::LegendShow::key;
    std::optional<flight::LegendShow> asked_legend_;
    CameraPose pose_;
    double focal_px_ = 1;
    std::uint32_t held_ = 0;  ///< one bit per action fly_...
    std::optional<std::uint32_t> pattern_, wanted_pattern_;
};

}  // namespace tedavis::host_sim
