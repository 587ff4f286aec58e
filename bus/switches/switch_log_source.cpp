#include "bus/switches/switch_log_source.hpp"

namespace tedavis::bus {

void SwitchLogSource::count(const SwitchLogLine& line) {
    if (line.kind == SwitchLineKind::comment) return;
    ++(line.kind == SwitchLineKind::unknown_line ? statistics_.unknown_lines : statistics_.malformed);
    if (!reports_.full()) static_cast<void>(reports_.try_push_back({line_number_, line.fault}));
}

bool SwitchLogSource::fetch() {
    while (!next_waits_ && at_ < text_.size()) {
        const std::size_t newline = text_.find('\n', at_);
        const std::size_t end = newline == std::string_view::npos ? text_.size() : newline;
        SwitchLogLine line = parse_switch_log_line(text_.substr(at_, end - at_), config_);
        at_ = newline == std::string_view::npos ? end : end + 1;
        ++line_number_;
        if (line.kind == SwitchLineKind::edge && line.edge.time < newest_)
            line = {SwitchLineKind::malformed, SwitchLineFault::time_runs_back, {}};
        if (line.kind != SwitchLineKind::edge) {
            count(line);
            continue;
        }
        next_ = line.edge;
        newest_ = line.edge.time;
        next_waits_ = true;
    }
    return next_waits_;
}

std::size_t SwitchLogSource::read(base::Time until, base::Span<SwitchEdge> out) {
    std::size_t count = 0;
    while (count < out.size() && fetch() && next_.time <= until) {
        out[count++] = next_;
        next_waits_ = false;
    }
    statistics_.edges += count;
    return count;
}

SourceHealth SwitchLogSource::health() const {
    return next_waits_ || at_ < text_.size() ? SourceHealth::running : SourceHealth::ended;
}

}  // namespace tedavis::bus
