/// The reports of the board program: at start its device, inputs and budget table, at the end its counters.
#pragma once

#include <cstdio>

#include "target/display_application.hpp"

namespace tedavis::target {

void print_version(bool json, std::FILE* out);
/// Prints the report at start; to be called after DisplayApplication::start(). JSON: {"version", "board", "device", "size",
/// "frame_rate_hz", "gl", "screen": {"driver", "connector", "mode"} (only where the surface is one), "can", "terrain",
/// "terrain_fault", "scene", "switches", "budget": [{"name", "kind", "bytes", "in_use", "owner", "reason"}]}.
void print_start(DisplayApplication& application, bool json, std::FILE* out);
/// Prints the report at the end. JSON: {"end", "frames", "missed", "gl_calls_outside_device", "can": {"frames", "decoded",
/// "alien", "errors", "dropped"}, and where the surface is a screen "screen": {"driver", "connector", "mode", "flips",
/// "missed_flips", "late_flips", "hidden_frames", "unplugged", "taken_away", "paced_by": "vblank" or "timer", "atomic"}}.
void print_end(const RunReport& report, bool json, std::FILE* out);

}  // namespace tedavis::target
