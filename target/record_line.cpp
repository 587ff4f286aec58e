#include "target/record_line.hpp"

#include <cmath>
#include <limits>

#include "render_core/base/units.hpp"

namespace tedavis::target {
namespace {

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();  // null in JSON

double milliseconds_of(base::Duration duration) { return static_cast<double>(duration.ns) / 1e6; }

void add_phase(const flight::PhaseStatus& status, JsonLine& line) {
    line.text("phase", flight::scenario_name(status.phase)).text("sub_phase", flight::sub_phase_name(status.phase));
    line.text("phase_source", flight::to_string(status.source));
    line.boolean("switch_fault", status.switch_fault).boolean("disagreement", status.disagreement);
}

/// Where a position is stale it is still shown; where it is lost it is not.
void add_own_ship(const display::FrameRecord& record, JsonLine& line) {
    const base::SignalState state = record.own_ship.state;
    const bool is_stale = state == base::SignalState::stale, is_known = is_stale || state == base::SignalState::valid;
    const auto where_known = [is_known](double value) { return is_known ? value : kNotKnown; };
    line.open_object("own_ship");
    line.number("lat_deg", where_known(base::degrees(record.own_ship.position.latitude_rad)));
    line.number("lon_deg", where_known(base::degrees(record.own_ship.position.longitude_rad)));
    line.number("alt_msl_m", where_known(record.altitude_msl_m));
    line.number("heading_deg", base::degrees(record.heading_rad)).number("pitch_deg", base::degrees(record.pitch_rad));
    line.number("roll_deg", base::degrees(record.roll_rad));
    line.text("state", is_stale ? "stale" : is_known ? "valid" : "lost").close_object();
}

void add_signals(const display::FrameRecord& record, JsonLine& line) {
    line.open_object("signals");
    for (std::size_t n = 0; n < flight::kSignalCount; ++n)
        line.text(flight::to_string(static_cast<flight::Signal>(n)), base::to_string(record.signals[n]));
    line.close_object();
    line.open_list("flags");
    for (const display::Name& flag : record.flags) line.text({}, flag.view());
    line.close_list();
}

/// Those that there are.
void add_values(const std::array<double, flight::kSignalCount>& values, JsonLine& line) {
    line.open_object("values");
    for (std::size_t n = 0; n < flight::kSignalCount; ++n)
        if (std::isfinite(values[n])) line.number(flight::to_string(static_cast<flight::Signal>(n)), values[n]);
    line.close_object();
}

void add_terrain(const display::TerrainRecord& terrain, JsonLine& line) {
    line.open_object("terrain").number("tau_px", terrain.tau_px).number("tau_reached_px", terrain.tau_reached_px);
    line.text("limit", terrain.limit.view()).number("worst_error_px", terrain.worst_error_px);
    line.number("triangles", std::uint64_t{terrain.triangles}).number("pending", std::uint64_t{terrain.pending});
    line.text("renderer", terrain.renderer.view()).text("renderer_reason", terrain.renderer_reason.view());
    if (terrain.rays_ms > 0)
        line.open_object("renderer_ms").number("raster", terrain.triangles_ms).number("trace", terrain.rays_ms).close_object();
    line.close_object();
}

void add_alerts(const display::AlertRecord& alerts, JsonLine& line) {
    static constexpr const char* kLevels[] = {"none", "caution", "warning"};
    const auto level = [](policy::TerrainAhead ahead) { return kLevels[static_cast<std::size_t>(ahead)]; };
    line.open_object("alerts")
        .open_object("terrain")
        .text("level", level(alerts.terrain))
        .boolean("watching", alerts.is_watching);
    line.number("clearance_m", alerts.clearance_m).number("height_above_terrain_m", alerts.height_above_terrain_m).close_object();
    line.open_object("obstacles").text("level", level(alerts.obstacle));
    line.number("count", std::uint64_t{alerts.obstacles.count()}).close_object().close_object();
}

void add_effects(const display::FrameRecord& record, JsonLine& line) {
    static constexpr const char* kStates[] = {"run", "replaced", "skipped"};
    line.open_list("effects");
    for (const display::EffectRecord& effect : record.effects) {
        line.open_object().text("name", effect.name.view()).text("state", kStates[static_cast<std::size_t>(effect.state)]);
        line.text("reason", effect.reason.view()).text("replaced_by", effect.replaced_by.view()).close_object();
    }
    line.close_list();
}

void add_delivery(const FrameDelivery& delivery, JsonLine& line) {
    line.boolean("warm", delivery.is_warm).boolean("on_screen", delivery.is_on_screen);
    line.number("can_to_screen_ms", delivery.can_to_screen ? milliseconds_of(*delivery.can_to_screen) : kNotKnown);
    line.open_object("ms").number("total", milliseconds_of(delivery.took)).close_object();
}

}  // namespace

std::array<double, flight::kSignalCount> values_of(const flight::AircraftState& state) {
    std::array<double, flight::kSignalCount> values{};
    for (std::size_t n = 0; n < flight::kSignalCount; ++n) values[n] = state[static_cast<flight::Signal>(n)].value_or(kNotKnown);
    return values;
}

void write_record(const display::FrameRecord& record, const FrameDelivery& delivery, JsonLine& line) {
    line.clear();
    line.open_object().number("frame", record.frame).number("time_s", (record.time - delivery.run_begun).to_seconds());
    line.number("monotonic_s", (record.time - base::Time{}).to_seconds());
    const flight::FlightTime& time = record.flight_time;
    line.open_object("utc").number("time_s", time.is_date ? (time.utc - base::Time{}).to_seconds() : kNotKnown);
    line.boolean("confirmed", time.is_confirmed).close_object();
    add_phase(record.phase, line);
    add_own_ship(record, line);
    add_signals(record, line);
    add_values(delivery.values, line);
    add_terrain(record.terrain, line);
    add_alerts(record.alerts, line);
    line.number("scene_revision", record.scene_revision);
    add_effects(record, line);
    line.open_object("presentation").text("design", record.design.view()).close_object();
    add_delivery(delivery, line);
    line.close_object();
}

}  // namespace tedavis::target
