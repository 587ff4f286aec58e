/// The graphics card as a seat manager hands it out. The manager makes the program the card's master and takes that away when
/// another terminal or session is shown, and gives it back afterwards.
///
/// Thread   one; open() and close() have a second one, which outlives them where the manager does not answer in time.
/// Memory   allocates in open() and close(); libseat allocates in each call.
/// Waiting  open() and close() as long as the limits say. All else does not wait with the seatd backend of libseat 0.7. The one
///          of libseat 0.8 waits in answer() until the manager answers, and the one for logind in take_request() for D-Bus.
#pragma once

#include <semaphore.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string_view>

#include "platform/egl_kms/drm_port.hpp"
#include "platform/egl_kms/seat_port.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::platform {

enum class SeatAccess : std::uint8_t {
    open,
    no_seat,      ///< no manager gives a seat
    not_enabled,  ///< the seat is another terminal's or session's now
    no_device,    ///< the manager does not open this file; reason() says why
    no_answer     ///< the manager stands still, or ended during the start
};

struct SeatLimits {
    base::Duration enabling = base::Duration::seconds(3);   ///< how long it waits until the seat is this program's
    base::Duration answering = base::Duration::seconds(3);  ///< how much longer it waits for a manager that does not answer
};

class Seat {
public:
    Seat() = default;
    ~Seat() { close(); }
    Seat(const Seat&) = delete;
    Seat& operator=(const Seat&) = delete;

    /// Opens a seat of `port`, and the card on it. Waits no longer than both limits together. May be called once; without a port
    /// there is no seat.
    [[nodiscard]] SeatAccess open(std::unique_ptr<SeatPort> port, const char* path, const SeatLimits& limits);
    /// Gives the card and the seat back. Waits no longer than `answering` of the limits.
    void close();

    [[nodiscard]] bool is_open() const { return state_ != nullptr; }
    /// Of the card; -1 before open(). It ends with close().
    [[nodiscard]] int descriptor() const { return state_ != nullptr ? state_->descriptor : -1; }
    /// "seatd"; empty where no seat was opened.
    [[nodiscard]] std::string_view manager() const { return manager_.view(); }
    /// Of `no_device`: an errno.
    [[nodiscard]] int reason() const { return reason_; }
    /// Whether the screen is this program's now, as far as the manager has said.
    [[nodiscard]] bool is_enabled() const { return state_ != nullptr && state_->is_enabled; }

    /// The newest request since the last call; `lost` in each call after the manager went away.
    [[nodiscard]] TerminalRequest take_request();
    /// Without an answer to `release` seatd does not give the screen to others. False where the manager had not asked.
    [[nodiscard]] bool answer(TerminalRequest request);

private:
    /// It belongs to the second thread as well, which goes on where the manager does not answer.
    struct State final : SeatListener {
        State() { sem_init(&is_done, 0, 0); }
        ~State();
        State(const State&) = delete;
        State& operator=(const State&) = delete;
        void on_enable() override;
        void on_disable() override;
        [[nodiscard]] SeatAccess open_card();
        [[nodiscard]] SeatAccess try_to_open_card();
        [[nodiscard]] bool dispatch(int wait_ms);
        /// Gives back what is open.
        void release();

        std::unique_ptr<SeatPort> port;
        base::FixedString<255> path;
        base::FixedString<31> manager;
        base::Duration enabling;
        SeatAccess access = SeatAccess::no_seat;
        TerminalRequest request = TerminalRequest::none;
        bool is_seat_open = false, is_enabled = false, owes_answer = false, is_lost = false;
        bool was_told_to_enable = false, was_told_to_disable = false;  // since the end of the last dispatch()
        int device = -1, descriptor = -1, reason = 0;
        sem_t is_done{};
        std::atomic<bool> is_left{false};  // One of the two threads has left it; the other one destroys it.
    };
    static void* open_card(void* state);
    static void* give_back(void* state);
    static void finish(State* state);
    [[nodiscard]] bool wait_for(void* (*work)(void*), base::Duration limit);

    std::unique_ptr<State> state_;
    base::FixedString<31> manager_;
    base::Duration answering_;
    int reason_ = 0;
};

}  // namespace tedavis::platform
