/// Port: a source of CAN frames, such as a socket, a log or a test.
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
    std::uint64_t dropped = 0;  ///< frames that the kernel or the recorder reports as lost
    std::uint64_t reopened = 0;
};

class CanSource {
public:
    virtual ~CanSource() = default;
    /// Fills `out` from the front with frames received at or before `until`, in order of reception; returns how many. 0 means
    /// that none are pending. Never blocks, never allocates.
    [[nodiscard]] virtual std::size_t read(base::Time until, base::Span<CanFrame> out) = 0;
    [[nodiscard]] virtual SourceHealth health() const = 0;
    [[nodiscard]] virtual const SourceStatistics& statistics() const = 0;
};

}  // namespace tedavis::bus
