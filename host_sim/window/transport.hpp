/// Play, pause, seek, speed and single steps over the frames of a flight. Pure: time comes in as durations.
#pragma once

#include <cstdint>

#include "render_core/base/time.hpp"

namespace tedavis::host_sim {

/// Frames are counted in the order of the flight's time, 0 .. count - 1.
class Transport {
public:
    /// `count` at least 1, `step` positive. Playing begins at the first frame, or backwards at the last.
    Transport(std::uint64_t count, base::Duration step, bool backwards);

    /// At the end that playing runs towards, it starts again from the other one.
    void play_or_pause();
    void reverse() { backwards_ = !backwards_; }
    void faster();
    void slower();
    void normal_speed() { speed_power_ = 0; }
    /// Stays within the flight; playing goes on.
    void seek(base::Duration by);
    void to_start() { go_to(0); }
    void to_end() { go_to(count_ - 1); }
    /// One frame forward (1) or back (-1), and pauses.
    void step(int frames);
    /// `wall` has gone by; playing pauses at either end.
    void advance(base::Duration wall);

    [[nodiscard]] std::uint64_t frame() const { return frame_; }
    [[nodiscard]] bool playing() const { return playing_; }
    [[nodiscard]] bool backwards() const { return backwards_; }
    /// 1/16 .. 64, powers of two.
    [[nodiscard]] double speed() const;

private:
    void go_to(std::uint64_t frame);
    void move(std::int64_t frames);

    std::uint64_t count_;
    base::Duration step_;
    std::uint64_t frame_ = 0;
    base::Duration carry_;  ///< of flight time, less than a step
    int speed_power_ = 0;
    bool playing_ = true;
    bool backwards_ = false;
};

}  // namespace tedavis::host_sim
