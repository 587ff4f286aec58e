#include "host_sim/replay/played_edges.hpp"

namespace tedavis::host_sim {

std::size_t PlayedEdges::read(base::Time until, base::Span<bus::SwitchEdge> out) {
    std::size_t count = 0;
    for (; count < out.size() && next_ < edges_.size() && edges_[next_].time <= until; ++next_) out[count++] = edges_[next_];
    statistics_.edges += count;
    return count;
}

bus::SourceHealth PlayedEdges::health() const {
    return next_ < edges_.size() ? bus::SourceHealth::running : bus::SourceHealth::ended;
}

}  // namespace tedavis::host_sim
