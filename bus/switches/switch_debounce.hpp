/// Software debounce: a new level counts once the line has kept it for the stable time. GPIO lines of the old kernel
/// interface have no debounce, so this one is always on.
///
/// The levels at `now` are a function of the edges at or before `now` and nothing else: how often anybody asks, and in
/// what portions the edges are added, makes no difference. The first level ever seen of a line counts at once.
///
/// Thread  one. Memory  inside the object; trivially copyable, so it can be saved. Failure  none.
#pragma once

#include <array>
#include <cstddef>
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
    /// For a `now` not before the newest edge added.
    [[nodiscard]] SwitchLevels levels(base::Time now) const;

    struct Change {
        base::Time at;
        bool waiting = false;
    };
    /// When the next level will count if no edge comes before; not waiting: never. `after` excludes what counted by then.
    [[nodiscard]] Change next_change(base::Time after) const;

private:
    struct Line {
        base::Time since;  // of the raw level
        bool raw = false;
        bool stable = false;  // what counted before the raw level does
        bool known = false;
    };
    std::array<Line, kMaxSwitchLines> lines_{};
    base::Duration stable_;
};
static_assert(std::is_trivially_copyable_v<SwitchDebounce>);

}  // namespace tedavis::bus
