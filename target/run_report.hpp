/// What the board program prints about itself: at start what it runs on and its budget table, at the end what it did.
#pragma once

#include <cstdio>

#include "target/display_application.hpp"

namespace tedavis::target {

void print_version(bool json, std::FILE* out);
/// After start(). JSON: {"version", "board", "device", "size", "frame_rate_hz", "gl", "can", "terrain", "terrain_fault", "scene",
/// "switches", "budget": [{"name", "kind", "bytes", "in_use", "owner", "reason"}]}.
void print_start(DisplayApplication& application, bool json, std::FILE* out);
/// JSON: {"end", "frames", "missed", "gl_calls_outside_device", "can": {"frames", "decoded", "alien", "errors", "dropped"}}.
void print_end(const RunReport& report, bool json, std::FILE* out);

}  // namespace tedavis::target
