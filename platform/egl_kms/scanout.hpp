/// Brings finished frames to a screen: sets the mode, queues flips, waits for them within bounds, keeps account of the buffers,
/// and goes on where the screen is unplugged, another program takes it, or a flip does not come.
///
/// A frame that cannot be shown is dropped and counted, and its flip is not waited for longer than kFlipLimit: the display goes
/// on planning and drawing. (Setting a mode may take longer.) When the screen is there again, the next frame sets the mode anew.
///
/// A screen that is plugged and ours and confirms nothing shows an old picture. After kStuckAfter the report says so, and the
/// mode is set anew; after kGiveUpAfter show() fails, so that the program is started again. show() also
/// fails where the seat manager ended and took the card away.
///
/// Thread   one. Memory  inside: two buffers at most are held at a time, framebuffers of four are known.
/// Failure  show() returns false where the driver gives no buffer and where the screen is given up; all else is in the report.
#pragma once

#include <cstdint>

#include "platform/egl_kms/drm_port.hpp"
#include "platform/egl_kms/flip_clock.hpp"
#include "platform/egl_kms/screen_settings.hpp"
#include "render_core/base/fixed_vector.hpp"

namespace tedavis::platform {

/// A flip takes one frame of the screen; after this time it is not waited for any longer.
inline constexpr base::Duration kFlipLimit = base::Duration::milliseconds(100);
/// How often, at most, the connector is looked at, and what failed is tried again.
inline constexpr base::Duration kScreenCheckInterval = base::Duration::seconds(1);
inline constexpr base::Duration kStuckAfter = base::Duration::seconds(3);
inline constexpr base::Duration kGiveUpAfter = base::Duration::seconds(8);

class Scanout {
public:
    /// All must outlive the object. The program is the card's master. `refresh_mhz`: of the mode, thousandths of a hertz.
    Scanout(DrmPort& drm, BufferQueue& buffers, ScreenReport& report, std::uint32_t refresh_mhz);
    Scanout(const Scanout&) = delete;
    Scanout& operator=(const Scanout&) = delete;

    /// The mode shows something already: the first frame need not set it.
    void mode_is_set() { needs_mode_ = false; }

    /// Shows the frame that GL has completed.
    [[nodiscard]] bool show();
    /// Waits for the last flip. The buffers are still the screen's; let_go() returns them once it shows something else.
    void stop();
    void let_go();

private:
    struct Framebuffer {
        void* token = nullptr;
        std::uint32_t id = 0;
    };

    void serve_terminal();
    void check_screen(base::Time now);
    void check_connector();
    void lose_master();
    void collect(base::Duration limit);
    void show(const ScanoutBuffer& front, base::Time now);
    void set_mode(const ScanoutBuffer& front, std::uint32_t framebuffer, base::Time now);
    void flip(const ScanoutBuffer& front, std::uint32_t framebuffer, base::Time now);
    void miss(const ScanoutBuffer& front);
    void confirm(base::Time now);
    void judge_standstill(base::Time now);
    [[nodiscard]] bool is_visible() const { return report_.is_plugged && report_.is_master; }
    /// 0 where the card refuses the buffer.
    [[nodiscard]] std::uint32_t framebuffer_of(const ScanoutBuffer& buffer);
    void forget(void* token);

    DrmPort& drm_;
    BufferQueue& buffers_;
    ScreenReport& report_;
    FlipClock clock_;
    base::FixedVector<Framebuffer, 4> framebuffers_;
    void* shown_ = nullptr;    // the screen reads it
    void* pending_ = nullptr;  // its flip is queued
    base::Time queued_at_;     // of the flip that is pending
    base::Time confirmed_at_;  // the last frame of which the screen said so, or the last one that could not be seen
    base::Time checked_at_;
    base::Time failed_at_;  // last try to set the mode
    bool has_begun_ = false, has_checked_ = false, has_failed_ = false;
    bool has_missed_ = false;  // since the screen confirmed a frame
    bool needs_mode_ = true;
    bool is_lost_ = false;      // for good: the manager that opened the card is gone
    bool is_released_ = false;  // another terminal has the screen, and the console will say when it is ours again
};

}  // namespace tedavis::platform
