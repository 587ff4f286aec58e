/// The reports of the board program: at start its device, inputs and budget table, at the end its counters.
#pragma once

#include <cstdio>

#include "target/display_application.hpp"

namespace tedavis::target {

/// The self-test of the start, which held.
struct StartTest {
    std::size_t checks = 0;  ///< 0: there was none
    base::Duration took;
};

void print_version(bool json, std::FILE* out);
/// Prints the report at start; to be called after DisplayApplication::start(). JSON: {"version", "board", "device", "size",
/// "frame_rate_hz", "gl", "screen": {"driver", "connector", "mode"} (only where the surface is one), "can", "terrain",
/// "terrain_fault", "scene", "switches", "pack": {"folder",
/// "title", "files", "signed", "valid_from", "valid_until"} (only where the board starts from one), "self_test": {"holds",
/// "checks", "ms"} (where there was one), "budget": [{"name", "kind", "bytes", "in_use", "owner", "reason"}]}.
void print_start(DisplayApplication& application, bool json, std::FILE* out, const StartTest& test = {});
/// Prints the report at the end. JSON: {"end", "frames", "missed", "gl_calls_outside_device", "first_picture_s" (seconds from
/// the start of the process to the first picture with a valid own-ship position and all of its terrain, else null), "warm_s"
/// (from there until every design had been drawn once behind the pictures, else null), "can":
/// {"frames", "decoded", "alien", "errors", "dropped"}, and where the surface is a screen "screen": {"driver", "connector",
/// "mode", "flips", "missed_flips", "late_flips", "hidden_frames", "unplugged", "taken_away", "paced_by": "vblank" or "timer",
/// "atomic"}}.
void print_end(const RunReport& report, bool json, std::FILE* out);

}  // namespace tedavis::target
