#include "platform/egl_kms/seat.hpp"

#include <pthread.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>
#include <new>
#include <utility>

#include "platform/clock/monotonic_clock.hpp"

namespace tedavis::platform {
namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000, kNanosecondsPerWaitedMillisecond = 1'000'000;

timespec moment_of(base::Time time) {
    return {static_cast<time_t>(time.ns / kNanosecondsPerSecond), static_cast<long>(time.ns % kNanosecondsPerSecond)};
}

}  // namespace

Seat::State::~State() {
    if (device >= 0) port->close_device(device);
    if (descriptor >= 0) ::close(descriptor);  // libseat leaves that to us
    if (is_seat_open) port->close();
    sem_destroy(&is_done);
}

void Seat::State::on_enable() {
    is_enabled = true;
    owes_answer = false;
    request = TerminalRequest::acquire;
}

void Seat::State::on_disable() {
    is_enabled = false;
    owes_answer = true;
    request = TerminalRequest::release;
}

SeatAccess Seat::State::open_card() {
    is_seat_open = port->open(*this);
    if (!is_seat_open) return SeatAccess::no_seat;
    const base::Time end = monotonic_now() + limit;
    while (!is_enabled) {
        const std::int64_t left_ms = (end - monotonic_now()).ns / kNanosecondsPerWaitedMillisecond;
        if (left_ms <= 0 || !port->dispatch(static_cast<int>(left_ms))) return SeatAccess::not_enabled;
    }
    device = port->open_device(path.c_str(), descriptor);
    if (device < 0) reason = errno;
    // Being enabled for the first time asks for nothing.
    if (request == TerminalRequest::acquire) request = TerminalRequest::none;
    return device < 0 ? SeatAccess::no_device : SeatAccess::open;
}

void* Seat::open_card(void* self) {
    State* const state = static_cast<State*>(self);
    state->access = state->open_card();
    sem_post(&state->is_done);
    if (state->is_left.exchange(true)) delete state;
    return nullptr;
}

/// libseat waits for the manager without a limit, so that another thread has to do it. False where that goes on.
bool Seat::wait_for_opening(base::Duration limit) {
    pthread_t thread{};
    const timespec end = moment_of(monotonic_now() + limit);
    if (::pthread_create(&thread, nullptr, &Seat::open_card, state_.get()) != 0) return true;
    int fault = 0;
    do fault = ::sem_clockwait(&state_->is_done, CLOCK_MONOTONIC, &end) == 0 ? 0 : errno;
    while (fault == EINTR);
    if (fault == 0 || state_->is_left.exchange(true)) return ::pthread_join(thread, nullptr) == 0;
    ::pthread_detach(thread);
    return false;
}

SeatAccess Seat::open(std::unique_ptr<SeatPort> port, const char* path, base::Duration limit) {
    if (port == nullptr) return SeatAccess::no_seat;
    state_.reset(new (std::nothrow) State());
    if (state_ == nullptr) return SeatAccess::no_seat;
    state_->port = std::move(port);
    state_->path = path;
    state_->limit = limit;
    if (!wait_for_opening({2 * limit.ns})) {
        (void)state_.release();  // the thread destroys it
        return SeatAccess::no_answer;
    }
    const SeatAccess access = state_->access;
    if (state_->is_seat_open) manager_ = state_->port->manager();
    reason_ = state_->reason;
    if (access != SeatAccess::open) close();
    return access;
}

void Seat::close() { state_.reset(); }

TerminalRequest Seat::take_request() {
    if (state_ == nullptr) return TerminalRequest::none;
    if (!state_->is_lost) state_->is_lost = !state_->port->dispatch(0);
    if (state_->is_lost) return TerminalRequest::lost;
    const TerminalRequest request = state_->request;
    state_->request = TerminalRequest::none;
    return request;
}

bool Seat::answer(TerminalRequest request) {
    if (state_ == nullptr) return false;
    if (request == TerminalRequest::acquire) return state_->is_enabled;
    if (!state_->owes_answer) return false;
    state_->owes_answer = false;
    return state_->port->disable();
}

}  // namespace tedavis::platform
