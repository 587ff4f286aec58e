/// Results for the decision intervals of a flight (flight/decision_interval.hpp): labels and priorities, on which the next
/// interval depends. Compressed copies of every kEvery-th interval are stored, plain ones of the last kRecent, and the terrain
/// alert of all.
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
    /// The terrain alert of an interval that was given to keep() at any time; nothing if it is not known. It is known for all
    /// intervals if keep() was called for them in order.
    [[nodiscard]] std::optional<policy::TerrainAhead> alert(std::int64_t interval) const;
    /// The last interval at or before `interval` of which a copy is stored; nothing where there is none.
    [[nodiscard]] std::optional<std::int64_t> last_by(std::int64_t interval) const;
    /// Returns a memory with only the labels and priorities of a stored interval. Throws UserError where its copy is damaged.
    [[nodiscard]] display::PlannerMemory restore(std::int64_t interval) const;
    void clear();

    /// Packed copies, by interval.
    [[nodiscard]] const std::map<std::int64_t, std::string>& packed() const { return packed_; }

    /// The alerts of all intervals from `first_alert()` on, a byte each.
    [[nodiscard]] std::int64_t first_alert() const { return first_alert_; }
    [[nodiscard]] const std::string& alerts() const { return alerts_; }
    /// Takes the alerts of an earlier track.
    void take_alerts(std::int64_t first, std::string alerts);

    /// Takes a packed copy of an earlier track.
    void take(std::int64_t interval, std::string bytes) { packed_[interval] = std::move(bytes); }

    /// Size of a copy before compression, which may differ in another build of the program.
    [[nodiscard]] static std::size_t plain_bytes();

private:
    std::map<std::int64_t, std::string> packed_;
    std::map<std::int64_t, display::PlannerMemory> recent_;
    std::int64_t first_alert_ = 0;
    std::string alerts_;  ///< one byte per interval, so that those of a day take 173 kB
};

/// Returns the compressed copies and the alerts as the bytes of a file: native byte order, one checksum over all. `made_from` is
/// the identity of all that they depend on.
[[nodiscard]] std::string pack_intervals(const IntervalTrack& track, std::string_view made_from);
/// Nothing where `made_from` or the build differs, or the bytes are damaged.
[[nodiscard]] std::optional<IntervalTrack> unpack_intervals(std::string_view bytes, std::string_view made_from);

}  // namespace tedavis::host_sim
