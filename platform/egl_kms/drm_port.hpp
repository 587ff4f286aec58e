/// Port: what a display needs from the kernel's graphics card (DRM) and from the buffers that GL draws into. Thin, so that tests
/// play cards that this machine does not have.
///
/// Thread  one. Memory  none of ours after creation.
#pragma once

#include <cstdint>

#include "platform/egl_kms/flip_clock.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::platform {

/// A buffer that GL has drawn and the screen may show.
struct ScanoutBuffer {
    void* token = nullptr;  ///< which buffer it is; null: none
    std::uint32_t width_px = 0, height_px = 0;
    std::uint32_t format = 0;  ///< DRM_FORMAT_*
    std::uint64_t modifier = 0;
    bool has_modifier = false;
    std::uint32_t planes = 0;
    std::uint32_t handles[4]{}, strides[4]{}, offsets[4]{};
};

/// The buffers behind the drawing surface.
class BufferQueue {
public:
    virtual ~BufferQueue() = default;
    /// The buffer that was completed last; it stays the screen's until release(). False where the driver gives none.
    [[nodiscard]] virtual bool lock_front(ScanoutBuffer& buffer) = 0;
    virtual void release(void* token) = 0;
    /// Calls `forget` before a buffer ends whose token may be used again.
    virtual void on_end_of_buffer(void (*forget)(void* self, void* token), void* self) = 0;
};

enum class DrmStatus : std::uint8_t {
    done,
    busy,        ///< the flip before is not done yet
    not_master,  ///< another program has the screen
    failed
};

/// What the console asks a program for that owns a terminal, when somebody switches terminals, or a seat manager in its place.
enum class TerminalRequest : std::uint8_t {
    none,
    release,
    acquire,
    lost  ///< the manager went away and has taken the card: only another start gets it back
};

/// One connector of one card in one mode.
class DrmPort {
public:
    virtual ~DrmPort() = default;
    [[nodiscard]] virtual bool become_master() = 0;
    virtual void drop_master() = 0;

    /// Makes a buffer known to the card; false where the card refuses it.
    [[nodiscard]] virtual bool add_framebuffer(const ScanoutBuffer& buffer, std::uint32_t& id) = 0;
    virtual void remove_framebuffer(std::uint32_t id) = 0;

    /// Sets the mode and shows the framebuffer; may block for a few frames.
    [[nodiscard]] virtual DrmStatus set_mode(std::uint32_t framebuffer) = 0;
    /// Shows the framebuffer from the next vertical blanking on, and says so by an event.
    [[nodiscard]] virtual DrmStatus queue_flip(std::uint32_t framebuffer) = 0;
    /// Waits at most `limit` (0: not at all) for a flip that was queued; false where none was done.
    [[nodiscard]] virtual bool wait_flip(base::Duration limit, FlipEvent& event) = 0;
    /// Switches the connector off, so that setting the mode again trains its link anew.
    virtual void turn_off() = 0;

    /// Without asking the screen itself, which would take long.
    [[nodiscard]] virtual bool is_connected() = 0;
    [[nodiscard]] virtual bool is_atomic() const = 0;
    /// Since the last call; none where the program owns no terminal. Waits for no console; what libseat waits for
    /// is in seat.hpp.
    [[nodiscard]] virtual TerminalRequest take_terminal_request() = 0;
    /// Tells the console that it is done; false where the console had not asked.
    [[nodiscard]] virtual bool answer_terminal(TerminalRequest request) = 0;
    /// Of the monotonic clock.
    [[nodiscard]] virtual base::Time now() = 0;
};

}  // namespace tedavis::platform
