#include "host_sim/reports/frame_record_json.hpp"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "host_sim/reports/clearance_json.hpp"
#include "render_core/base/units.hpp"
#include "render_core/display/planner/picture_layer.hpp"
#include "render_core/earth/geodetic.hpp"
#include "render_core/policy/element_texts.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

std::string text(std::string_view view) { return std::string(view); }

const char* own_ship_state(base::SignalState state) {
    if (state == base::SignalState::valid) return "valid";
    return state == base::SignalState::stale ? "stale" : "lost";
}

Json own_ship_json(const display::FrameRecord& record) {
    const earth::Geodetic& position = record.own_ship.position;
    const bool is_known = record.own_ship.state == base::SignalState::valid || record.own_ship.state == base::SignalState::stale;
    const auto where_known = [](bool known, double value) { return known ? Json(value) : Json(); };
    return {{"lat_deg", where_known(is_known, base::degrees(position.latitude_rad))},
            {"lon_deg", where_known(is_known, base::degrees(position.longitude_rad))},
            {"alt_msl_m", where_known(is_known, record.altitude_msl_m)},
            {"alt_ellipsoid_m", where_known(is_known && record.own_ship.height_is_geometric, position.height.m)},
            {"heading_deg", base::degrees(record.heading_rad)},
            {"pitch_deg", base::degrees(record.pitch_rad)},
            {"roll_deg", base::degrees(record.roll_rad)},
            {"state", own_ship_state(record.own_ship.state)}};
}

Json signals_json(const display::FrameRecord& record) {
    Json json = Json::object();
    for (std::size_t i = 0; i < flight::kSignalCount; ++i)
        json[flight::to_string(static_cast<flight::Signal>(i))] = base::to_string(record.signals[i]);
    return json;
}

Json elements_json(const display::FrameRecord& record) {
    Json json = Json::object();
    for (std::size_t i = 0; i < policy::kElementCount; ++i)
        json[text(policy::name_of(static_cast<policy::Element>(i)))] = policy::name_of(record.elements[i]);
    return json;
}

Json data_json(const display::FrameRecord& record) {
    Json json = Json::object();
    for (const display::DataRecord& type : record.data)
        json[text(type.type.view())] = {
            {"drawn", type.drawn}, {"aggregated", type.aggregated}, {"hidden", type.hidden}, {"out_of_view", type.out_of_view}};
    return json;
}

Json effects_json(const display::FrameRecord& record) {
    static constexpr const char* kStates[] = {"run", "replaced", "skipped"};
    Json json = Json::array();
    for (const display::EffectRecord& effect : record.effects) {
        json.push_back({{"name", text(effect.name.view())},
                        {"state", kStates[static_cast<std::size_t>(effect.state)]},
                        {"reason", text(effect.reason.view())},
                        {"replaced_by", text(effect.replaced_by.view())},
                        {"bound", effect.bound},
                        {"draws", effect.draws},
                        {"passes", effect.passes},
                        {"bytes", effect.bytes}});
    }
    return json;
}

Json given_up_json(const effects::EffectSet& given_up) {
    Json names = Json::array();
    for (std::size_t n = 0; n < effects::kEffectCount; ++n)
        if (given_up.has(static_cast<effects::Effect>(n))) names.push_back(effects::row_of(static_cast<effects::Effect>(n)).name);
    return names;
}

Json governor_json(const display::GovernorRecord& governor) {
    return {{"deadline_ms", governor.deadline_ms},     {"predicted_ms", governor.predicted_ms},
            {"quality_level", governor.quality_level}, {"changed", governor.changed},
            {"why", text(governor.why.view())},        {"tau_factor", governor.tau_factor},
            {"detail_factor", governor.detail_factor}, {"given_up", given_up_json(governor.given_up)}};
}

Json weights_json(const display::FrameRecord& record) {
    Json json = Json::object();
    for (const display::WeightRecord& one : record.weights)
        json[text(one.aspect.view())] = {{"weight", one.weight}, {"stated", one.stated}};
    return json;
}

/// Regions above the budget, or in which data are decluttered.
Json crowded_json(const display::ClutterRecord& clutter) {
    using scene::DetailRegions;
    Json json = Json::array();
    for (std::size_t n = 0; n < clutter.left.factor.size(); ++n) {
        const auto whole = static_cast<double>(clutter.measured.whole.measure[n]);
        if (whole <= clutter.budget && clutter.left.factor[n] >= 1) continue;
        Json region{{"column", n % DetailRegions::kAcross}, {"row", n / DetailRegions::kAcross}, {"clutter", whole}};
        region["least"] = clutter.measured.least.is_known ? Json(clutter.measured.least.measure[n]) : Json();
        region["reached"] = clutter.reached.is_known ? Json(clutter.reached.measure[n]) : Json();
        region["detail"] = clutter.left.factor[n];
        json.push_back(std::move(region));
    }
    return json;
}

/// Null without a budget.
Json clutter_json(const display::FrameRecord& record) {
    const display::ClutterRecord& clutter = record.clutter;
    if (clutter.budget >= 1) return {};
    Json json{{"budget", clutter.budget}, {"is_measured", clutter.measured.whole.is_known}};
    json["regions"] = clutter.measured.whole.is_known ? crowded_json(clutter) : Json::array();
    json["decluttered_roles"] = Json::array();
    for (std::size_t n = 0; n < static_cast<std::size_t>(scene::LayerRole::count); ++n)
        if ((clutter.roles >> n & 1u) != 0) json["decluttered_roles"].push_back(scene::name_of(static_cast<scene::LayerRole>(n)));
    return json;
}

Json focus_json(const display::FocusRecord& focus) {
    Json json{{"name", text(focus.name.view())},
              {"shape", text(focus.shape.view())},
              {"shown", focus.is_shown},
              {"reason", text(focus.reason.view())},
              {"in_focus", focus.in_focus},
              {"intermediate", focus.intermediate},
              {"context", focus.context},
              {"sight", text(focus.sight.view())},
              {"cue", focus.has_cue},
              {"distance_m", focus.distance_m}};
    if (focus.is_shown) {
        json["latitude_deg"] = base::degrees(focus.latitude_rad);
        json["longitude_deg"] = base::degrees(focus.longitude_rad);
        json["radius_m"] = focus.radius_m;
        json["points"] = focus.points;
    }
    json["interval"] = focus.low <= focus.high ? Json{focus.low, focus.high} : Json();
    json["values"] = Json::array();
    for (const display::FocusValuesRecord& values : focus.values)
        json["values"].push_back({{"layer", text(values.layer.view())},
                                  {"attribute", text(values.attribute.view())},
                                  {"count", values.count},
                                  {"interval", values.count > 0 ? Json{values.low, values.high} : Json()}});
    return json;
}

Json aspect_json(const display::AspectRecord& aspect) {
    return {{"technique", text(aspect.technique.view())}, {"detail", aspect.detail}, {"weight", aspect.weight}};
}

Json light_json(const policy::TerrainLight& light) {
    static constexpr const char* kSources[] = {"fixed", "sun", "fixed_no_date", "fixed_sun_too_low"};
    return {{"source", kSources[static_cast<std::size_t>(light.source)]},
            {"azimuth_deg", base::degrees(light.azimuth_rad)},
            {"elevation_deg", base::degrees(light.elevation_rad)}};
}

Json bands_json(const design::BandWidening& bands) {
    return {{"lowered_m", bands.lowered_m},
            {"position_sigma_m", bands.position_sigma_m},
            {"terrain_sigma_m", bands.terrain_sigma_m},
            {"position_assumed", bands.position_assumed},
            {"terrain_assumed", bands.terrain_assumed}};
}

Json utc_json(const flight::FlightTime& time) {
    return {{"time_s", time.is_date ? Json(static_cast<double>(time.utc.ns) / 1e9) : Json()}, {"confirmed", time.is_confirmed}};
}

/// Of each focus that is asked to be larger: by how much it is, or why it is not.
Json distortion_json(const display::DistortionRecords& records) {
    Json json = Json::array();
    for (const display::DistortionRecord& record : records) {
        const bool is_shown = record.state == display::DistortionState::shown;
        json.push_back({{"focus", text(record.focus.view())},
                        {"state", is_shown ? "shown" : "withheld"},
                        {"reason", display::reason_of(record.state)},
                        {"factor", std::ldexp(1.0, static_cast<int>(record.power))},
                        {"ring_factor", is_shown ? std::ldexp(1.0, -static_cast<int>(record.compression)) : 0},
                        {"lat_deg", base::degrees(record.middle.latitude_rad)},
                        {"lon_deg", base::degrees(record.middle.longitude_rad)},
                        {"radius_m", record.radius_m},
                        {"reach_m", record.reach_m}});
    }
    return json;
}

/// On the way, the soonest first, as they stand in the picture.
Json obstacles_json(const display::ObstaclePlaces& obstacles) {
    Json json = Json::array();
    for (const display::ObstaclePlace& one : obstacles) {
        const bool has_box = !one.box.empty();
        json.push_back({{"name", text(one.name.view())},
                        {"feature", one.feature},
                        {"state", text(display::kObstacleStateNames[static_cast<std::size_t>(one.state)])},
                        {"ahead_s", one.ahead_s},
                        {"box", has_box ? Json{one.box.x, one.box.y, one.box.right(), one.box.bottom()} : Json()}});
    }
    return json;
}

Json flags_json(const display::FrameRecord& record) {
    Json json = Json::array();
    for (const display::Name& flag : record.flags) json.push_back(text(flag.view()));
    return json;
}

Json terrain_json(const display::TerrainRecord& terrain) {
    Json json{{"tau_px", terrain.tau_px},
              {"tau_reached_px", terrain.tau_reached_px},
              {"limit", text(terrain.limit.view())},
              {"worst_error_px", terrain.worst_error_px},
              {"worst_chunk", text(terrain.worst_chunk.view())},
              {"triangles", terrain.triangles},
              {"chunks", terrain.chunks},
              {"pending", terrain.pending},
              {"renderer", text(terrain.renderer.view())},
              {"renderer_reason", text(terrain.renderer_reason.view())}};
    if (terrain.rays_ms > 0) json["renderer_ms"] = {{"raster", terrain.triangles_ms}, {"trace", terrain.rays_ms}};
    return json;
}

const char* level_text(policy::TerrainAhead level) {
    static constexpr const char* kLevels[] = {"none", "caution", "warning"};
    return kLevels[static_cast<std::size_t>(level)];
}

/// Along which track ground counts, how far beside it, and from which height on; null while nothing is colored.
Json alert_zone_json(const policy::TerrainAlertZone& zone) {
    if (zone.alert == policy::TerrainAhead::none) return {};
    return {{"level", level_text(zone.alert)},
            {"ground_speed_mps", zone.speed_mps()},
            {"track_deg", base::degrees(earth::wrap_heading(std::atan2(zone.east_mps, zone.north_mps)))},
            {"turn_deg_s", base::degrees(zone.turn_radps)},
            {"until_s", zone.until_s},
            {"width_m", {zone.radius_at(0), zone.radius_at(zone.until_s)}},
            {"floor_msl_m", {zone.floor_at(0), zone.floor_at(zone.until_s)}}};
}

Json terrain_alert_json(const display::FrameRecord& record) {
    const display::AlertRecord& alerts = record.alerts;
    const bool has_height = std::isfinite(alerts.height_above_terrain_m);
    return {{"level", level_text(alerts.terrain)},
            {"watching", alerts.is_watching},
            {"clearance_m", alerts.clearance_m},
            {"height_above_terrain_m", has_height ? Json(alerts.height_above_terrain_m) : Json()},
            {"zone", alert_zone_json(record.alert_zone)}};
}

/// Layers by their number in the scene, from 0. Straight ahead of a turn the time counts twice; the soonest by that first.
Json obstacle_alert_json(const display::AlertRecord& alerts) {
    Json json = {{"level", level_text(alerts.obstacle)}, {"count", alerts.obstacles.count()}, {"ahead", Json::array()}};
    for (const policy::AlertedObstacle& one : alerts.obstacles.all())
        json["ahead"].push_back({{"layer", one.layer},
                                 {"feature", one.feature},
                                 {"level", level_text(one.level())},
                                 {"seconds", one.seconds()},
                                 {"straight_ahead", one.is_straight_ahead()}});
    return json;
}

Json stale_json(const display::FrameRecord& record) {
    Json json = Json::array();
    for (const display::StaleRecord& stale : record.stale)
        json.push_back({{"layer", text(stale.layer.view())}, {"age_s", stale.age_s}});
    return json;
}

}  // namespace

std::string hash_text(std::uint64_t hash) {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
    return digits;
}

std::string frame_record_json(const FrameResult& result, base::Time origin) {
    const display::FrameRecord& record = result.record;
    Json json;
    json["frame"] = record.frame;
    json["time_s"] = static_cast<double>((record.time - origin).ns) / 1e9;  // a quotient: 7.5, not 7.500000000000001
    json["utc"] = utc_json(record.flight_time);
    json["hash"] = hash_text(result.hash);
    json["phase"] = flight::scenario_name(record.phase.phase);
    json["sub_phase"] = flight::sub_phase_name(record.phase.phase);
    json["phase_source"] = flight::to_string(record.phase.source);
    json["own_ship"] = own_ship_json(record);
    json["signals"] = signals_json(record);
    json["elements"] = elements_json(record);
    json["flags"] = flags_json(record);
    json["view"] = {{"mode", text(design::kViewModeNames[static_cast<std::size_t>(record.view.mode)])},
                    {"transition", record.view.transition}};
    json["distortion"] = distortion_json(record.distortion);
    json["light"] = light_json(record.light);
    json["symbology_light"] = text(design::kSymbologyLightNames[static_cast<std::size_t>(record.symbology_light)]);
    json["warning_bands"] = bands_json(record.bands);
    json["terrain"] = terrain_json(record.terrain);
    json["alerts"] = {{"terrain", terrain_alert_json(record)}, {"obstacles", obstacle_alert_json(record.alerts)}};
    json["clearance"] = clearance_json(result.clearance);
    if (result.has_layers) {
        json["layers"] = display::kPictureLayerNames;
        json["obstacles"] = obstacles_json(result.obstacles);
    }
    if (result.has_accuracy_overlay) json["accuracy_overlay"] = true;
    if (const std::optional<MeasuredError>& error = result.measured_error)
        json["measured_error"] = {{"mean_px", error->mean_px}, {"max_px", error->max_px}, {"places", error->places}};
    json["scene_revision"] = record.scene_revision;
    json["data"] = data_json(record);
    json["stale"] = stale_json(record);
    json["labels"] = {{"placed", record.labels.placed},
                      {"suppressed", record.labels.suppressed},
                      {"changed", record.labels.changed},
                      {"decluttered", record.labels.decluttered}};
    json["legend"] = {
        {"show", text(name_of(record.legend.show))}, {"entries", record.legend.entries}, {"left_out", record.legend.left_out}};
    json["foci"] = Json::array();
    for (const display::FocusRecord& focus : record.foci) json["foci"].push_back(focus_json(focus));
    json["bytes"] = {{"cpu", record.bytes.cpu},
                     {"gpu", record.bytes.gpu},
                     {"cpu_budget", record.bytes.cpu_budget},
                     {"gpu_budget", record.bytes.gpu_budget},
                     {"uploaded", record.bytes.uploaded}};
    json["governor"] = governor_json(record.governor);
    json["effects"] = effects_json(record);
    json["presentation"] = {{"design", text(record.design.view())},
                            {"earlier_share", record.earlier_share},
                            {"terrain", aspect_json(record.terrain_aspect)},
                            {"data", aspect_json(record.data_aspect)},
                            {"uncertainty", aspect_json(record.uncertainty_aspect)},
                            {"weights", weights_json(record)}};
    json["clutter"] = clutter_json(record);
    json["ms"] = {{"plan", result.timing.plan_ms}, {"draw", result.timing.draw_ms}, {"total", result.timing.total_ms}};
    json["latency_ms"] = result.latency_ms;
    if (result.warnings) json["warnings"] = findings_json(*result.warnings);
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tedavis::host_sim
