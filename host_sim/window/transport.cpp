#include "host_sim/window/transport.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::host_sim {
namespace {

constexpr int kFastestPower = 6, kSlowestPower = -4;
/// A machine that stood still for longer must not leap through the flight.
constexpr base::Duration kLongestTurn = base::Duration::milliseconds(500);

}  // namespace

Transport::Transport(std::uint64_t count, base::Duration step, bool backwards)
    : count_(count), step_(step), frame_(backwards ? count - 1 : 0), backwards_(backwards) {}

double Transport::speed() const { return std::ldexp(1.0, speed_power_); }

void Transport::faster() { speed_power_ = std::min(speed_power_ + 1, kFastestPower); }
void Transport::slower() { speed_power_ = std::max(speed_power_ - 1, kSlowestPower); }

void Transport::play_or_pause() {
    playing_ = !playing_;
    if (!playing_) return;
    const std::uint64_t end = backwards_ ? 0 : count_ - 1;
    if (frame_ == end) go_to(count_ - 1 - end);
}

void Transport::go_to(std::uint64_t frame) {
    frame_ = frame;
    carry_ = {};
}

void Transport::move(std::int64_t frames) {
    const auto last = static_cast<std::int64_t>(count_ - 1);
    frame_ = static_cast<std::uint64_t>(std::clamp<std::int64_t>(static_cast<std::int64_t>(frame_) + frames, 0, last));
}

void Transport::seek(base::Duration by) {
    const std::int64_t whole = by.ns / step_.ns;
    // A step longer than the jump would make the key dead.
    move(whole != 0 ? whole : (by.ns < 0 ? -1 : 1));
    carry_ = {};
}

void Transport::step(int frames) {
    playing_ = false;
    move(frames);
    carry_ = {};
}

void Transport::advance(base::Duration wall) {
    if (!playing_) return;
    const std::int64_t turn = std::min(wall, kLongestTurn).ns;
    carry_.ns += speed_power_ >= 0 ? turn << speed_power_ : turn >> -speed_power_;
    const std::int64_t frames = carry_.ns / step_.ns;
    carry_.ns %= step_.ns;
    move(backwards_ ? -frames : frames);
    if (frame_ != (backwards_ ? 0 : count_ - 1)) return;
    playing_ = false;
    carry_ = {};
}

}  // namespace tedavis::host_sim
