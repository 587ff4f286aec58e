#include "bus/switches/switch_debounce.hpp"

namespace tedavis::bus {

void SwitchDebounce::add(const SwitchEdge& edge) {
    if (edge.line >= kMaxSwitchLines) return;
    Line& line = lines_[edge.line];
    if (!line.known) {
        line = {edge.time, edge.level, edge.level, true};
        return;
    }
    if (edge.level == line.raw) return;
    const base::Time at = edge.time < line.since ? line.since : edge.time;
    if (at - line.since >= stable_) line.stable = line.raw;
    line.raw = edge.level;
    line.since = at;
}

SwitchLevels SwitchDebounce::levels(base::Time now) const {
    SwitchLevels levels;
    for (std::size_t i = 0; i < kMaxSwitchLines; ++i) {
        const Line& line = lines_[i];
        if (!line.known) continue;
        levels.known |= std::uint32_t{1} << i;
        const bool level = now - line.since >= stable_ ? line.raw : line.stable;
        levels.high |= static_cast<std::uint32_t>(level) << i;
    }
    return levels;
}

bool SwitchDebounce::are_settled(std::uint32_t lines, base::Time now) const {
    for (std::size_t i = 0; i < kMaxSwitchLines; ++i) {
        const Line& line = lines_[i];
        if ((lines >> i & 1u) != 0 && line.raw != line.stable && now - line.since < stable_) return false;
    }
    return true;
}

SwitchDebounce::Change SwitchDebounce::next_change(base::Time after) const {
    Change next;
    for (const Line& line : lines_) {
        if (!line.known || line.raw == line.stable) continue;
        const base::Time at = line.since + stable_;
        if (at > after && (!next.waiting || at < next.at)) next = {at, true};
    }
    return next;
}

}  // namespace tedavis::bus
