#include "target/event_log.hpp"

#include <unistd.h>

#include "render_core/base/fixed_string.hpp"

namespace tedavis::target {
namespace {

void write_to_stderr(void*, std::string_view line) {
    // A log that takes nothing must not stop the display.
    if (::write(STDERR_FILENO, line.data(), line.size()) < 0) return;
}

}  // namespace

EventLog::EventLog() : sink_(&write_to_stderr) {}

void EventLog::write(std::initializer_list<std::string_view> parts) const {
    base::FixedString<2046> text("tedavis-display: ");
    for (const std::string_view part : parts) text.append(part);
    base::FixedString<2047> line(text.view());
    line.append("\n");
    sink_(context_, line.view());
}

}  // namespace tedavis::target
