/// One connector of a graphics card in one mode, through the kernel's DRM: atomic commits where the card takes them, else the
/// older calls.
///
/// open() makes the program the card's DRM master; drop_master() and become_master() give this up and take it back. restore()
/// shows again what was on the screen before open(); the destructor does not. With a seat manager (seatd, logind) the manager
/// opens the card and decides who is master, and its requests to release and acquire the screen replace those of the virtual
/// terminal. If the manager ends and this program stays master, the requests of the virtual terminal count again.
///
/// Thread  one; with a seat, open() and the destructor use a second one (seat.hpp). Memory  libdrm's and libseat's, and one
/// buffer of the card. Failure  one sentence at open(), states afterwards.
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
    /// Shows what was on the screen before open(). Does nothing if this program is not DRM master; turns the output off if
    /// nothing was shown or it cannot be shown again.
    void restore();

    /// The error text for a set_mode() that returned `status`. Call it at once: it reads errno. Sets is_held() for `not_master`,
    /// and then takes the newest request of the seat manager; otherwise clears is_held().
    [[nodiscard]] base::Error refused_mode(DrmStatus status);

    /// Whether open() or show_black() failed because another program or terminal has the screen, or because the seat manager does
    /// not answer.
    [[nodiscard]] bool is_held() const { return is_held_; }
    [[nodiscard]] int descriptor() const { return card_; }
    /// Which manager opened the card, such as "seatd"; empty: this program itself.
    [[nodiscard]] std::string_view seat_manager() const { return seat_.is_open() ? seat_.manager() : std::string_view(); }
    /// The errno with which the seat manager refused to open the card's file; 0: it did not refuse.
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
    /// User data of the page flip queued last. Completion events with another value belong to older flips and are ignored.
    std::uint32_t cookie_ = 0;
    TerminalSwitch terminal_;
    Seat seat_;
    ManagerEnd manager_end_ = ManagerEnd::none;
    bool is_given_up_ = false;  // drop_master() gave the screen up without a seat manager; false again with become_master()
};

}  // namespace tedavis::platform

#endif
