/// Port: a source of switch edges, such as GPIO lines, a recorded switch log or keys of the simulator.
#pragma once

#include <cstdint>

#include "bus/frame/can_source.hpp"
#include "bus/switches/switch_edge.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::bus {

struct SwitchStatistics {
    std::uint64_t edges = 0;          ///< edges returned, including levels at start and re-read levels
    std::uint64_t malformed = 0;      ///< lines of a log that are no edges
    std::uint64_t unknown_lines = 0;  ///< edges of lines that the switch config does not name
    std::uint64_t rereads = 0;        ///< number of times that levels were read again
    std::uint64_t overruns = 0;       ///< number of times that edges are known to have been lost
};

class SwitchSource {
public:
    virtual ~SwitchSource() = default;
    /// Fills `out` from the front with edges at or before `until`, in order of time; returns how many. A full `out` means that
    /// more may be pending. The first edge of each line is its level at start. After lost edges the levels are read again and
    /// returned as edges. Never blocks, never allocates.
    [[nodiscard]] virtual std::size_t read(base::Time until, base::Span<SwitchEdge> out) = 0;
    [[nodiscard]] virtual SourceHealth health() const = 0;
    [[nodiscard]] virtual const SwitchStatistics& statistics() const = 0;
};

}  // namespace tedavis::bus
