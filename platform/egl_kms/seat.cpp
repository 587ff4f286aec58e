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
    release();
    sem_destroy(&is_done);
}

void Seat::State::release() {
    if (device >= 0) port->close_device(device);
    if (descriptor >= 0) ::close(descriptor);  // libseat leaves that to us
    if (is_seat_open) port->close();
    device = descriptor = -1;
    is_seat_open = false;
}

void Seat::State::on_enable() {
    was_told_to_enable = is_enabled = true;
    owes_answer = false;
    request = TerminalRequest::acquire;
}

void Seat::State::on_disable() {
    was_told_to_disable = owes_answer = true;
    is_enabled = false;
    request = TerminalRequest::release;
}

/// Some versions of libseat's seatd backend hand on the newest event first. seatd enables a seat only after the answer to being
/// disabled, so that of both at once being disabled is the newer one. logind does not wait for an answer.
bool Seat::State::dispatch(int wait_ms) {
    const bool is_there = port->dispatch(wait_ms);
    if (was_told_to_enable && was_told_to_disable && manager.view() != "logind") on_disable();
    was_told_to_enable = was_told_to_disable = false;
    return is_there;
}

SeatAccess Seat::State::try_to_open_card() {
    is_seat_open = port->open(*this);
    if (!is_seat_open) return SeatAccess::no_seat;
    manager = port->manager();
    const base::Time end = monotonic_now() + enabling;
    while (!is_enabled) {
        const std::int64_t left_ms = (end - monotonic_now()).ns / kNanosecondsPerWaitedMillisecond;
        if (left_ms <= 0) return SeatAccess::not_enabled;
        if (!dispatch(static_cast<int>(left_ms))) return SeatAccess::no_answer;
    }
    device = port->open_device(path.c_str(), descriptor);
    if (device < 0) reason = errno;
    // Being enabled for the first time asks for nothing.
    if (request == TerminalRequest::acquire) request = TerminalRequest::none;
    return device < 0 ? SeatAccess::no_device : SeatAccess::open;
}

SeatAccess Seat::State::open_card() {
    const SeatAccess tried = try_to_open_card();
    if (tried != SeatAccess::open) release();
    return tried;
}

void* Seat::open_card(void* self) {
    State* const state = static_cast<State*>(self);
    state->access = state->open_card();
    finish(state);
    return nullptr;
}

void* Seat::give_back(void* self) {
    State* const state = static_cast<State*>(self);
    state->release();
    finish(state);
    return nullptr;
}

void Seat::finish(State* state) {
    sem_post(&state->is_done);
    if (state->is_left.exchange(true)) delete state;
}

/// libseat waits for the manager without a limit, so that another thread has to do it. Returns false where that thread goes on.
bool Seat::wait_for(void* (*work)(void*), base::Duration limit) {
    pthread_t thread{};
    const timespec end = moment_of(monotonic_now() + limit);
    while (::sem_trywait(&state_->is_done) == 0) {
    }  // the work before
    state_->is_left = false;
    if (::pthread_create(&thread, nullptr, work, state_.get()) != 0) return true;
    int fault = 0;
    do fault = ::sem_clockwait(&state_->is_done, CLOCK_MONOTONIC, &end) == 0 ? 0 : errno;
    while (fault == EINTR);
    if (fault == 0 || state_->is_left.exchange(true)) return ::pthread_join(thread, nullptr) == 0;
    ::pthread_detach(thread);
    return false;
}

SeatAccess Seat::open(std::unique_ptr<SeatPort> port, const char* path, const SeatLimits& limits) {
    if (port == nullptr) return SeatAccess::no_seat;
    state_.reset(new (std::nothrow) State());
    if (state_ == nullptr) return SeatAccess::no_seat;
    state_->port = std::move(port);
    state_->path = path;
    state_->enabling = limits.enabling;
    answering_ = limits.answering;
    if (!wait_for(&Seat::open_card, limits.enabling + limits.answering)) {
        (void)state_.release();  // the thread destroys it
        return SeatAccess::no_answer;
    }
    const SeatAccess access = state_->access;
    manager_ = state_->manager;
    reason_ = state_->reason;
    if (access != SeatAccess::open) state_.reset();  // its thread has given back what was open
    return access;
}

void Seat::close() {
    if (state_ == nullptr) return;
    if (wait_for(&Seat::give_back, answering_))
        state_.reset();
    else
        (void)state_.release();  // the thread destroys it
}

TerminalRequest Seat::take_request() {
    if (state_ == nullptr) return TerminalRequest::none;
    if (!state_->is_lost) state_->is_lost = !state_->dispatch(0);
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
