/// Where frames come from: a socket, a log, a test. All alike to the rest of the bus.
#pragma once

#include <cstdint>

#include "bus/frame/can_frame.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::bus {

enum class SourceHealth : std::uint8_t { running, idle, link_down, bus_off, ended, failed };

struct SourceStatistics {
    std::uint64_t frames = 0;
    std::uint64_t malformed = 0;  ///< lines or records that are not frames
    std::uint64_t error_frames = 0;
    std::uint64_t dropped = 0;  ///< frames that kernel or recorder reports as lost
    std::uint64_t reopened = 0;
};

class CanSource {
public:
    virtual ~CanSource() = default;
    /// Fills `out` from the front with frames received at or before `until`, in order of reception; returns how many.
    /// 0 means none are waiting. Never blocks, never allocates.
    [[nodiscard]] virtual std::size_t read(base::Time until, base::Span<CanFrame> out) = 0;
    [[nodiscard]] virtual SourceHealth health() const = 0;
    [[nodiscard]] virtual const SourceStatistics& statistics() const = 0;
};

}  // namespace tedavis::bus
