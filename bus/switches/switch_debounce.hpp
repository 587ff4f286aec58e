/// Software debounce: a new level becomes effective once the line has kept it for the stable time. It is always on, because
/// GPIO lines of the old kernel interface have no debounce.
///
/// The levels at `now` depend only on the edges at or before `now`, not on how often levels() is called or in what portions
/// edges are added. The first level of a line is effective at once.
///
/// Thread  one. Memory  inside the object; trivially copyable, so it can be saved. Failure  none.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "bus/switches/switch_edge.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::bus {

class SwitchDebounce {
public:
    explicit SwitchDebounce(base::Duration stable) : stable_(stable) {}

    /// Edges in the order of the source. An edge earlier than its line's previous one counts as simultaneous with it; a
    /// level that is already there is ignored; a line beyond kMaxSwitchLines is ignored.
    void add(const SwitchEdge& edge);
    /// Returns the debounced levels; `now` must not lie before the newest edge added.
    [[nodiscard]] SwitchLevels levels(base::Time now) const;

    /// True where each of these lines (a bit each) has kept its level at `now`; no level of theirs is about to become effective.
    [[nodiscard]] bool are_settled(std::uint32_t lines, base::Time now) const;

    struct Change {
        base::Time at;
        bool waiting = false;
    };
    /// Returns when the next level becomes effective if no edge arrives before; `waiting` is false where none is pending.
    /// Levels that were effective at `after` are excluded.
    [[nodiscard]] Change next_change(base::Time after) const;

private:
    struct Line {
        base::Time since;  // of the raw level
        bool raw = false;
        bool stable = false;  // the level in effect until the raw level is
        bool known = false;
    };
    std::array<Line, kMaxSwitchLines> lines_{};
    base::Duration stable_;
};
static_assert(std::is_trivially_copyable_v<SwitchDebounce>);

}  // namespace tedavis::bus
