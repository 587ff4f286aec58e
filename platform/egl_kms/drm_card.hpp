/// One connector of a graphics card in one mode, through the kernel's DRM: atomic commits where the card takes them, else the
/// older calls.
///
/// The program is the card's master from open() on. At the end the console is shown again as it was before. With a seat manager
/// the card is opened through it: the manager decides who is master, and what it asks for takes the place of what the console
/// asks for. Where the manager ends and leaves the card, the console is asked again.
///
/// Thread  one. Memory  libdrm's and libseat's, and one buffer of the card. Failure  one sentence at open(), states afterwards.
#pragma once

#if defined(TEDAVIS_HAVE_KMS)

#include <xf86drmMode.h>

#include <memory>
#include <string_view>

#include "platform/egl_kms/atomic_output.hpp"
#include "platform/egl_kms/drm_port.hpp"
#include "platform/egl_kms/screen_choice.hpp"
#include "platform/egl_kms/seat.hpp"
#include "platform/egl_kms/terminal_switch.hpp"
#include "render_core/base/error.hpp"

namespace tedavis::platform {

class DrmCard final : public DrmPort {
public:
    DrmCard() = default;
    /// Waits for a manager no longer than `answering` of open()'s limits.
    ~DrmCard() override;
    DrmCard(const DrmCard&) = delete;
    DrmCard& operator=(const DrmCard&) = delete;

    /// May be called once. Nothing on the screen changes yet. With a `seat` the card is opened through it, where it gives one;
    /// null: by this program itself. Waits no longer than the `limits` together.
    [[nodiscard]] base::Error open(const ScreenCard& card, const ScreenChoice& choice, std::unique_ptr<SeatPort> seat = nullptr,
                                   const SeatLimits& limits = {});
    /// Sets the mode and shows black.
    [[nodiscard]] base::Error show_black();
    /// Shows what was shown before open().
    void restore();

    /// The sentence for a mode that was not set; after `not_master` is_held() is true.
    [[nodiscard]] base::Error refused_mode(DrmStatus status);

    /// Whether open() or show_black() failed since another program has the screen.
    [[nodiscard]] bool is_held() const { return is_held_; }
    [[nodiscard]] int descriptor() const { return card_; }
    /// Which manager opened the card, such as "seatd"; empty: this program itself.
    [[nodiscard]] std::string_view seat_manager() const { return seat_.is_open() ? seat_.manager() : std::string_view(); }
    /// An errno: why the manager did not open the file that it was asked for; 0: another reason, or it did.
    [[nodiscard]] int seat_fault() const { return seat_.reason(); }
    [[nodiscard]] ManagerEnd manager_end() const { return manager_end_; }
    /// How a buffer of XRGB8888 may lie in memory; empty: the driver decides.
    [[nodiscard]] const FormatModifiers& modifiers() const { return modifiers_; }

    bool become_master() override;
    void drop_master() override;
    bool add_framebuffer(const ScanoutBuffer& buffer, std::uint32_t& id) override;
    void remove_framebuffer(std::uint32_t id) override;
    DrmStatus set_mode(std::uint32_t framebuffer) override;
    DrmStatus queue_flip(std::uint32_t framebuffer) override;
    bool wait_flip(base::Duration limit, FlipEvent& event) override;
    void turn_off() override;
    bool is_connected() override;
    bool is_atomic() const override { return is_atomic_; }
    TerminalRequest take_terminal_request() override;
    bool answer_terminal(TerminalRequest request) override {
        return is_managed() ? seat_.answer(request) : terminal_.answer(request);
    }
    base::Time now() override;

private:
    [[nodiscard]] base::Error open_file(const char* path, std::unique_ptr<SeatPort> seat, const SeatLimits& limits);
    /// Whether a manager decides who is master.
    [[nodiscard]] bool is_managed() const { return seat_.is_open() && manager_end_ == ManagerEnd::none; }
    [[nodiscard]] TerminalRequest take_request_without_manager();
    [[nodiscard]] base::Error held_error() const;
    [[nodiscard]] bool find_mode(const ScreenChoice& choice);
    [[nodiscard]] bool make_black();
    [[nodiscard]] bool set_mode_without_atomic(std::uint32_t framebuffer);
    [[nodiscard]] bool queue_flip_without_atomic(std::uint32_t framebuffer, std::uint32_t cookie);
    [[nodiscard]] bool read_events(FlipEvent& event);

    base::FixedString<300> name_;
    base::FixedString<255> path_;
    bool is_held_ = false;
    int card_ = -1;
    std::uint32_t connector_ = 0, crtc_ = 0;
    drmModeModeInfo mode_{};
    drmModeCrtc* before_ = nullptr;
    std::uint32_t black_handle_ = 0, black_ = 0;
    AtomicOutput atomic_;
    FormatModifiers modifiers_;
    bool is_atomic_ = false;
    std::uint32_t cookie_ = 0;  // of the flip that was queued last: events of older ones are not its
    TerminalSwitch terminal_;
    Seat seat_;
    ManagerEnd manager_end_ = ManagerEnd::none;
    bool is_given_up_ = false;  // without a manager, until the console gives the screen back
};

}  // namespace tedavis::platform

#endif
