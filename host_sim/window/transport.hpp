/// Playback control over the frames of a flight: play, pause, seek, speed and single steps. It reads no clock: the caller passes
/// the elapsed time.
#pragma once

#include <cstdint>

#include "render_core/base/time.hpp"

namespace tedavis::host_sim {

/// Frames are numbered in the order of the flight's time, 0 .. count - 1.
class Transport {
public:
    /// `count`, the number of frames, is at least 1; `step`, the flight time between two frames, is above 0. Playback begins at
    /// the first frame, or backwards at the last.
    Transport(std::uint64_t count, base::Duration step, bool backwards);

    /// Toggles playback. Where playback has reached its last frame, it starts again from the other end.
    void play_or_pause();
    void reverse() { backwards_ = !backwards_; }
    void faster();
    void slower();
    void normal_speed() { speed_power_ = 0; }
    /// Moves by a flight time, at least by one frame and not beyond the ends of the flight; playback continues.
    void seek(base::Duration by);
    void to_start() { go_to(0); }
    void to_end() { go_to(count_ - 1); }
    /// Pauses and moves by `frames`: 1 for one frame forward, -1 for one frame back.
    void step(int frames);
    /// Plays for the elapsed time `wall`, at most half a second of it, at the current speed; pauses at the end.
    void advance(base::Duration wall);

    [[nodiscard]] std::uint64_t frame() const { return frame_; }
    [[nodiscard]] bool playing() const { return playing_; }
    [[nodiscard]] bool backwards() const { return backwards_; }
    /// Returns the factor of the playback speed, a power of two in 1/16 .. 64.
    [[nodiscard]] double speed() const;

private:
    void go_to(std::uint64_t frame);
    void move(std::int64_t frames);

    std::uint64_t count_;
    base::Duration step_;
    std::uint64_t frame_ = 0;
    base::Duration carry_;  ///< flight time played since `frame_`, less than a step
    int speed_power_ = 0;
    bool playing_ = true;
    bool backwards_ = false;
};

}  // namespace tedavis::host_sim
