/// Writes events on the board, one line each, to stderr (systemd's journal stores and stamps them).
///
/// Thread  one. Memory  none; never allocates. Lines longer than the buffer are cut.
#pragma once

#include <initializer_list>
#include <string_view>

namespace tedavis::target {

class EventLog {
public:
    /// Receives whole lines, the newline included.
    using Sink = void (*)(void* context, std::string_view line);

    EventLog();  ///< to stderr
    EventLog(Sink sink, void* context) : sink_(sink), context_(context) {}

    /// Writes "tedavis-display: " and the parts.
    void write(std::initializer_list<std::string_view> parts) const;

private:
    Sink sink_;
    void* context_ = nullptr;
};

}  // namespace tedavis::target
