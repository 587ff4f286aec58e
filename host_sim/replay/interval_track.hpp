/// What the display has decided for the intervals of a flight (flight/decision_interval.hpp): its labels and priorities, from
/// which the next interval is decided. Of every kEvery-th interval a packed copy is kept, of those decided last plain ones, and
/// of all whether the terrain alert is on.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "render_core/display/planner/planner_memory.hpp"

namespace tedavis::host_sim {

class IntervalTrack {
public:
    static constexpr std::int64_t kEvery = 16;
    static constexpr std::size_t kRecent = 16;

    void keep(std::int64_t interval, const display::PlannerMemory& decided);
    /// Whether the terrain alert is on in an interval that was kept at any time; nothing where none such is known. Intervals that
    /// were kept in order are known without a gap.
    [[nodiscard]] std::optional<policy::TerrainAhead> alert(std::int64_t interval) const;
    /// The last one at or before `interval` that is kept; nothing where there is none.
    [[nodiscard]] std::optional<std::int64_t> last_by(std::int64_t interval) const;
    /// Labels and priorities of an interval that is kept, and nothing else. Throws UserError where its copy is damaged.
    [[nodiscard]] display::PlannerMemory restore(std::int64_t interval) const;
    void clear();

    /// Packed copies, by interval.
    [[nodiscard]] const std::map<std::int64_t, std::string>& packed() const { return packed_; }

    /// The alerts of all intervals from `first_alert()` on, a byte each.
    [[nodiscard]] std::int64_t first_alert() const { return first_alert_; }
    [[nodiscard]] const std::string& alerts() const { return alerts_; }
    /// Takes those of an earlier track.
    void take_alerts(std::int64_t first, std::string alerts);

    /// Takes a packed copy of an earlier track.
    void take(std::int64_t interval, std::string bytes) { packed_[interval] = std::move(bytes); }

    /// Bytes of a copy before it is packed. Another build of the program may have others.
    [[nodiscard]] static std::size_t plain_bytes();

private:
    std::map<std::int64_t, std::string> packed_;
    std::map<std::int64_t, display::PlannerMemory> recent_;
    std::int64_t first_alert_ = 0;
    std::string alerts_;  ///< a byte an interval, that a look ahead over a day takes some 100 kB
};

/// The packed copies as a file: native byte order, one checksum over all of it. `made_from`: what they follow from.
[[nodiscard]] std::string pack_intervals(const IntervalTrack& track, std::string_view made_from);
/// Nothing where they were made from something else or by another build, or are damaged.
[[nodiscard]] std::optional<IntervalTrack> unpack_intervals(std::string_view bytes, std::string_view made_from);

}  // namespace tedavis::host_sim
