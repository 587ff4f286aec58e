/// The edges of a recorded panel as a switch source that can be read from any edge.
#pragma once

#include <cstddef>
#include <vector>

#include "bus/switches/switch_source.hpp"

namespace tedavis::host_sim {

class PlayedEdges final : public bus::SwitchSource {
public:
    /// `next` is the index of the next edge, which read() advances; the edges ascend in time. Both must outlive the source and
    /// may change.
    PlayedEdges(const std::vector<bus::SwitchEdge>& edges, std::size_t& next) : edges_(edges), next_(next) {}

    [[nodiscard]] std::size_t read(base::Time until, base::Span<bus::SwitchEdge> out) override;
    [[nodiscard]] bus::SourceHealth health() const override;
    [[nodiscard]] const bus::SwitchStatistics& statistics() const override { return statistics_; }

private:
    const std::vector<bus::SwitchEdge>& edges_;
    std::size_t& next_;
    bus::SwitchStatistics statistics_;
};

}  // namespace tedavis::host_sim
