/// Which screen a board asks for, and how the display on it fares: plain values.
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "platform/egl_kms/screen_mode.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::platform {

enum class FlipPacing : std::uint8_t {
    timer,  ///< flips come at once: only the program's own timer paces the frames
    vblank  ///< flips come with the screen's vertical blanking
};

/// Whether the seat manager that opened the card ended during the run.
enum class ManagerEnd : std::uint8_t {
    none,
    left_the_card,  ///< as a crashed one does: the display goes on, and the program itself answers the console
    took_the_card,  ///< as an orderly end does: only another start gets the screen back
    kept_the_card   ///< it left the card, and only the end of the run can give the screen to another terminal
};

/// What the screen has done since the start.
struct ScreenReport {
    base::FixedString<31> driver, connector;
    ModeText mode;
    base::FixedString<31> seat_manager;  ///< which opened the card, such as "seatd"; empty: this program itself
    base::FixedString<255> seat_note;    ///< why no manager opened it, where none did; empty: a manager did, or there is none
    std::uint32_t refresh_mhz = 0;       ///< thousandths of a hertz; 0: not known
    std::uint64_t flips = 0;             ///< frames that the screen confirmed
    std::uint64_t missed_flips = 0;      ///< frames whose flip was refused or did not come in time
    std::uint64_t late_flips = 0;        ///< flips that came more than one and a half periods after they were queued
    std::uint64_t hidden_frames = 0;     ///< frames drawn while the screen was unplugged or another program had it
    std::uint64_t unplugged = 0;         ///< how often
    std::uint64_t taken_away = 0;        ///< how often another program or console got the screen
    base::Duration waited;               ///< of the last frame, for the screen: no work of ours
    std::optional<base::Time> shown_at;  ///< since when the screen shows the last frame; nothing: it does not yet
    FlipPacing paced_by = FlipPacing::timer;
    ManagerEnd manager_end = ManagerEnd::none;
    bool is_atomic = false;
    bool is_plugged = true;
    bool is_master = true;
    bool is_stuck = false;  ///< the screen has confirmed no frame for kStuckAfter: it shows an old picture
    bool may_come = false;  ///< the surface could not be made since the screen is missing or taken: trying again may succeed
};
static_assert(std::is_trivially_copyable_v<ScreenReport>);

/// The section [screen] of a board file. Empty texts stand for the first one that serves.
struct ScreenSettings {
    base::FixedString<31> driver;     ///< of the card, such as "virtio_gpu"
    base::FixedString<255> path;      ///< of the card, in place of its driver's name
    base::FixedString<31> connector;  ///< such as "HDMI-A-1"
    ScreenModeWish mode;
    ScreenReport* report = nullptr;  ///< where the surface reports; null: nowhere; must outlive the surface
};
static_assert(std::is_trivially_copyable_v<ScreenSettings>);

}  // namespace tedavis::platform
