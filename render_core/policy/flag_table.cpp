#include "render_core/policy/flag_table.hpp"

#include "render_core/base/check.hpp"
#include "render_core/policy/display_decisions.hpp"

namespace tedavis::policy {
namespace {

/// In the order of the flags.
constexpr FlagRow kFlagRows[] = {
    {RecordFlag::own_ship_missing, "own_ship.missing", "No position has been received yet.", "The terrain is removed."},
    {RecordFlag::own_ship_stale, "own_ship.stale", "The last position is older than the limit of fresh positions.",
     "The terrain is removed, and the map shows the last position in amber."},
    {RecordFlag::own_ship_lost, "own_ship.lost", "The last position is older than the limit of stale positions.",
     "The terrain is removed, and a red cross replaces the map's symbols."},
    {RecordFlag::own_ship_invalid, "own_ship.invalid", "The sender states that the position or the height is not valid.",
     "The terrain is removed, and a red cross replaces the map's symbols."},
    {RecordFlag::own_ship_height_on_qnh, "own_ship.height_on_qnh",
     "The height comes from the altimeter with a valid setting, not from the GPS receiver.", "The warning colors are removed."},
    {RecordFlag::own_ship_height_not_geometric, "own_ship.height_not_geometric",
     "The height comes from the altimeter without a valid setting.",
     "The terrain is shown as degraded, and the warning colors are removed."},
    {RecordFlag::horizontal_accuracy_above_limit, "horizontal_accuracy.above_limit",
     "The horizontal accuracy is worse than the design allows.",
     "The terrain is shown as degraded, and the warning colors are removed."},
    {RecordFlag::vertical_accuracy_above_limit, "vertical_accuracy.above_limit",
     "The vertical accuracy is worse than the design allows.",
     "The terrain is shown as degraded, and the warning colors are removed."},
    {RecordFlag::vertical_accuracy_assumed, "vertical_accuracy.assumed", "The bus does not state the vertical accuracy.",
     "The warning colors are widened by the accuracy that the design assumes."},
    {RecordFlag::attitude_unusual, "attitude.unusual",
     "Pitch or bank exceeds the design's limits, or has not come back 5 degrees within them.",
     "The recovery picture with chevrons replaces everything that is not needed to recover."},
    {RecordFlag::minimum_below_ground, "minimum_altitude.below_ground",
     "The minimum altitude lies below the ground under the own ship.", "A red cross replaces the minimum altitude."},
    {RecordFlag::map_heading_up, "map.heading_up", "The map is track up, and the track is not valid.",
     "The heading is at the top of the map."},
    {RecordFlag::map_north_up, "map.north_up", "The map is track up, and neither track nor heading is valid.",
     "North is at the top of the map."},
    {RecordFlag::terrain_missing, "terrain.missing", "No terrain database was given.", "The terrain is removed."},
    {RecordFlag::terrain_failed, "terrain.failed", "The terrain database cannot be read, or has failed its checks.",
     "The terrain is removed."},
    {RecordFlag::terrain_failing, "terrain.failing", "Parts of the terrain database cannot be read.",
     "Coarser terrain is drawn in their place."},
    {RecordFlag::terrain_outside_database, "terrain.outside_database",
     "The own ship is outside the area of the terrain database.", "The terrain is removed."},
    {RecordFlag::terrain_ends, "terrain.ends", "The predicted track leaves the area of the terrain database within 60 s.",
     "A notice is shown; beyond its edge there is no terrain alert."},
    {RecordFlag::terrain_above_own_ship, "terrain.above_own_ship", "The own ship's height is below the database's surface.",
     "The terrain is removed."},
    {RecordFlag::terrain_ahead, "terrain.ahead", "The predicted track comes too close to terrain within 60 s.",
     "A notice is shown, and the terrain has warning colors if they may be shown."},
    {RecordFlag::obstacle_ahead, "obstacle.ahead", "The predicted track comes too close to an obstacle within 60 s.",
     "A notice is shown, and the obstacles that are in the way have its color."},
    {RecordFlag::terrain_degraded, "terrain.degraded", "The position or the height is not reliable.",
     "The terrain stays, and its warning colors are removed."},
    {RecordFlag::terrain_accuracy_assumed, "terrain.accuracy_assumed",
     "The terrain database does not state its vertical accuracy.",
     "The warning colors are widened by the accuracy that the design assumes."},
    {RecordFlag::terrain_coarse, "terrain.coarse", "Budgets leave the terrain with a larger error than the design allows.",
     "The terrain stays and is said to be coarse."},
    {RecordFlag::terrain_too_coarse, "terrain.too_coarse", "The chunks in memory would show a wrong picture.",
     "The terrain is removed until finer chunks have arrived."},
    {RecordFlag::terrain_over_budget, "terrain.over_budget", "The coarsest terrain exceeds the device's budgets.",
     "The terrain is removed."},
    {RecordFlag::terrain_tau_raised, "terrain.tau_raised", "The terrain's error on the screen is larger than intended.",
     "The record states the error that was reached."},
    {RecordFlag::terrain_late, "terrain.late", "The terrain file answers too slowly.",
     "Coarser terrain is drawn until the finer chunks have arrived."},
    {RecordFlag::terrain_void, "terrain.void", "The ground in view has places without heights.",
     "These places have the color of unknown ground."},
    {RecordFlag::terrain_flat, "terrain.flat", "The design draws the ground without relief.", "The ground is a plane."},
    {RecordFlag::terrain_no_image, "terrain.no_image", "The database or the device does not have the image over the terrain.",
     "The terrain is shown without the image."},
    {RecordFlag::terrain_not_traced, "terrain.not_traced", "A requirement of ray tracing is not met.",
     "The terrain is drawn as triangles, and the record states the reason."},
    {RecordFlag::ground_data_missing, "ground_data.missing", "The data that the design shows on the ground are not available.",
     "The ground is shown without these data."},
    {RecordFlag::ground_data_no_date, "ground_data.no_date", "The flight's time is not a date.",
     "The data on the ground are those of the first time that they state."},
    {RecordFlag::ground_data_unit, "ground_data.unit", "The palette and the data on the ground have different units.",
     "The palette's colors do not fit the values."},
    {RecordFlag::adjacent_missing, "adjacent.missing", "The data of the maps beside the picture are not available.",
     "The maps beside the picture are removed."},
    {RecordFlag::adjacent_cut, "adjacent.cut", "There is no room for the maps beside the picture.",
     "The maps beside the picture are removed."},
    {RecordFlag::adjacent_unit, "adjacent.unit", "The palette and the data of the maps beside the picture have different units.",
     "The palette's colors do not fit the values."},
    {RecordFlag::data_missing, "data.missing", "Data that the design shows are not available now.",
     "These data are removed, and the record's effects state the reason."},
    {RecordFlag::data_stale, "data.stale", "Data that the design shows are older than their limit.",
     "The data stay, and the whole legend shows their age in amber."},
    {RecordFlag::data_out_of_date, "data.out_of_date", "Data that the design shows are not valid at this time.",
     "These data are removed."},
    {RecordFlag::database_out_of_date, "database.out_of_date", "The databases may not be used on this day.",
     "The databases stay on the display, and a notice is shown."},
    {RecordFlag::traffic_cut, "traffic.cut", "More aircraft are received than the display can hold.",
     "Some of these aircraft are not shown."},
    {RecordFlag::legend_cut, "legend.cut", "There is no room for all entries of the legend.",
     "The last entries are removed, and an amber number counts them; on a small screen the key stands in their place."},
    {RecordFlag::phase_switch_fault, "phase.switch_fault", "The phase switches have an impossible pattern.",
     "The last valid phase is kept."},
    {RecordFlag::phase_disagreement, "phase.disagreement", "Two sources state different flight phases.",
     "The phase of the source of higher authority is shown."},
    {RecordFlag::utc_lost, "utc.lost", "The bus no longer states the time.",
     "The time continues by the source's clock, and every age is unknown."},
    {RecordFlag::deadline_missed, "deadline.missed", "The frame costs more time than its deadline allows.",
     "The frame comes late."},
    {RecordFlag::arithmetic_changed, "arithmetic.changed", "Another part of the process changed how numbers are computed.",
     "The usual state is set again before the frame is planned."},
};
static_assert(sizeof kFlagRows / sizeof kFlagRows[0] == kRecordFlagCount);
constexpr bool flag_rows_in_order() {
    for (std::size_t i = 0; i < kRecordFlagCount; ++i)
        if (kFlagRows[i].flag != static_cast<RecordFlag>(i)) return false;
    return true;
}
static_assert(flag_rows_in_order());

}  // namespace

base::Span<const FlagRow> flag_rows() noexcept { return base::Span<const FlagRow>(kFlagRows); }

std::string_view name_of(RecordFlag flag) noexcept {
    const auto index = static_cast<std::size_t>(flag);
    TEDAVIS_CHECK(index < kRecordFlagCount);
    return kFlagRows[index].name;
}

}  // namespace tedavis::policy
