/// Writes the picture that was just drawn to a PNG file: the last one of a run of N frames, and the next one after SIGUSR1.
///
/// While an object was started with a path, SIGUSR1 asks for a picture; only one object may exist at a time. The file appears
/// whole, in the place of an earlier one. Memory  allocated by start(). Failure  start() returns one sentence; later faults are
/// one line in the log, and the run goes on.
#pragma once

#include <signal.h>

#include <cstdint>
#include <memory>

#include "render_core/base/error.hpp"
#include "render_core/gl/gl.hpp"
#include "target/event_log.hpp"

namespace tedavis::target {

class Snapshot {
public:
    explicit Snapshot(const EventLog& log) : log_(log) {}
    ~Snapshot();
    Snapshot(const Snapshot&) = delete;
    Snapshot& operator=(const Snapshot&) = delete;

    /// Takes memory for a picture of this size and tries whether the file can be written. May be called once.
    [[nodiscard]] base::Error start(const char* path, std::uint32_t width_px, std::uint32_t height_px);
    [[nodiscard]] bool is_started() const { return path_ != nullptr; }
    /// True once after each SIGUSR1.
    [[nodiscard]] bool take_request();
    /// Reads the bound framebuffer, which is as large as start() was told, and writes the file: this frame takes longer, and its
    /// time is not that of the display.
    void take(gl::Gl& gl);

private:
    const EventLog& log_;
    const char* path_ = nullptr;
    std::uint32_t width_px_ = 0, height_px_ = 0;
    std::size_t pixel_bytes_ = 0, file_bytes_ = 0;
    std::unique_ptr<std::uint8_t[]> pixels_, file_;
    struct sigaction previous_ {};
};

}  // namespace tedavis::target
