#include "host_sim/reports/alert_hindrance.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>

namespace tedavis::host_sim {
namespace {

bool has_any_flag(const display::FrameRecord& record, std::initializer_list<std::string_view> names) {
    return std::any_of(record.flags.begin(), record.flags.end(), [&](const display::Name& flag) {
        return std::find(names.begin(), names.end(), flag.view()) != names.end();
    });
}

/// `terrain.degraded` alone is not enough: it is not raised where the terrain is removed for another reason.
bool is_degraded(const display::FrameRecord& record) {
    return has_any_flag(record, {"terrain.degraded", "own_ship.height_not_geometric", "horizontal_accuracy.above_limit",
                                 "horizontal_accuracy.stale", "horizontal_accuracy.lost", "horizontal_accuracy.invalid",
                                 "vertical_accuracy.above_limit", "vertical_accuracy.stale", "vertical_accuracy.lost",
                                 "vertical_accuracy.invalid"});
}

}  // namespace

AlertHindrance hindrance_of(const display::FrameRecord& record) {
    if (record.alerts.terrain != policy::TerrainAhead::none) return AlertHindrance::none;
    if (has_any_flag(record, {"terrain.missing"})) return AlertHindrance::no_terrain;
    if (has_any_flag(record, {"terrain.failed"})) return AlertHindrance::terrain_failed;
    if (record.own_ship.state != base::SignalState::valid) return AlertHindrance::no_position;
    if (has_any_flag(record, {"terrain.outside_database"})) return AlertHindrance::outside;
    if (has_any_flag(record, {"terrain.above_own_ship"})) return AlertHindrance::below_surface;
    if (is_degraded(record)) return AlertHindrance::degraded;
    return std::isnan(record.alerts.height_above_terrain_m) ? AlertHindrance::unknown_ground : AlertHindrance::none;
}

const char* name_of(AlertHindrance hindrance) {
    static constexpr const char* kNames[] = {"none",    "no_terrain",    "terrain_failed", "no_position",
                                             "outside", "below_surface", "degraded",       "unknown_ground"};
    static_assert(sizeof kNames / sizeof kNames[0] == kAlertHindranceCount);
    return kNames[static_cast<std::size_t>(hindrance)];
}

const char* words_of(AlertHindrance hindrance) {
    static constexpr const char* kWords[] = {"nothing hindered it",
                                             "there was no terrain",
                                             "the terrain could not be read",
                                             "the position was not known",
                                             "the aircraft was outside the terrain database",
                                             "the height was below the surface of the terrain",
                                             "the position or the height was not reliable (TERRAIN DEGRADED)",
                                             "the height of the ground below was not known"};
    static_assert(sizeof kWords / sizeof kWords[0] == kAlertHindranceCount);
    return kWords[static_cast<std::size_t>(hindrance)];
}

}  // namespace tedavis::host_sim
