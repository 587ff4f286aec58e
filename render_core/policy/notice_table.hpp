/// Every notice of the display: its text and level, why it is shown, what is removed, and what to do. A plain table; pure.
///
/// README.md shows the table; a test compares both.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "render_core/base/span.hpp"
#include "render_core/policy/display_decisions.hpp"
#include "render_core/policy/flag_table.hpp"

namespace tedavis::policy {

/// The most urgent first. A notice whose level depends on the state has an id for each level.
enum class NoticeId : std::uint8_t {
    terrain_failed,
    below_terrain_flying,
    terrain_ahead_warning,
    obstacle_ahead_warning,
    terrain_ahead_caution,
    obstacle_ahead_caution,
    position_stale,
    no_position,
    no_terrain_data,
    outside_database,
    below_terrain_parked,
    terrain_degraded,
    terrain_coarse,
    terrain_off,
    map_north_up,
    minimums,
    phase_switch_fault,
    phase_disagreement,
    database_expired,
    database_not_yet_valid,
    data_out_of_date,
    data_stale,
    analysis_overlay,
    traffic_incomplete,
    database_ends,
    no_terrain_image,
    orthographic_view,
    flat_ground,
    graphics_reduced,
    generated_flight,
    not_for_navigation,
    count_
};
inline constexpr std::size_t kNoticeCount = static_cast<std::size_t>(NoticeId::count_);

/// One sentence a cell.
struct NoticeRow {
    NoticeId id;
    NoticeLevel level;
    std::string_view text;  ///< upper case ASCII
    RecordFlag flag;        ///< raised in every frame with the notice; count_: none, or one that names a signal
    std::string_view cause, removed, action;
};
/// All rows, in the order of the ids.
[[nodiscard]] base::Span<const NoticeRow> notice_rows() noexcept;
/// `id` must not be count_.
[[nodiscard]] const NoticeRow& notice_row(NoticeId id) noexcept;

}  // namespace tedavis::policy
