/// Every flag of a frame's record that is not a signal's state: its name, its cause and its consequence. A plain table; pure.
///
/// A signal's state is flagged as `signal.state` by the rules of signal_rules.hpp. README.md shows the table; a test compares
/// both.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "render_core/base/span.hpp"

namespace tedavis::policy {

enum class RecordFlag : std::uint8_t {
    own_ship_missing,
    own_ship_stale,
    own_ship_lost,
    own_ship_invalid,
    own_ship_height_on_qnh,
    own_ship_height_not_geometric,
    horizontal_accuracy_above_limit,
    vertical_accuracy_above_limit,
    vertical_accuracy_assumed,
    attitude_unusual,
    minimum_below_ground,
    map_heading_up,
    map_north_up,
    terrain_missing,
    terrain_failed,
    terrain_failing,
    terrain_outside_database,
    terrain_ends,
    terrain_above_own_ship,
    terrain_ahead,
    obstacle_ahead,
    terrain_degraded,
    terrain_accuracy_assumed,
    terrain_coarse,
    terrain_too_coarse,
    terrain_over_budget,
    terrain_tau_raised,
    terrain_late,
    terrain_void,
    terrain_flat,
    terrain_no_image,
    terrain_not_traced,
    ground_data_missing,
    ground_data_no_date,
    ground_data_unit,
    adjacent_missing,
    adjacent_cut,
    adjacent_unit,
    data_missing,
    data_stale,
    data_out_of_date,
    database_out_of_date,
    traffic_cut,
    legend_cut,
    phase_switch_fault,
    phase_disagreement,
    utc_lost,
    deadline_missed,
    arithmetic_changed,
    count_
};
inline constexpr std::size_t kRecordFlagCount = static_cast<std::size_t>(RecordFlag::count_);

/// One sentence a cell.
struct FlagRow {
    RecordFlag flag;
    std::string_view name;  ///< as it stands in the record: "terrain.ahead"
    std::string_view cause, consequence;
};
/// All rows, in the order of the flags.
[[nodiscard]] base::Span<const FlagRow> flag_rows() noexcept;
/// `flag` must not be count_.
[[nodiscard]] std::string_view name_of(RecordFlag flag) noexcept;

}  // namespace tedavis::policy
