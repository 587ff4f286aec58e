#include "host_sim/reports/run_summary.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "host_sim/reports/line_chart.hpp"
#include "host_sim/version.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

Json memory_json(const base::BudgetTable& memory) {
    Json lines = Json::array();
    for (const base::BudgetLine& line : memory.lines()) {
        lines.push_back({{"name", std::string(line.name.view())},
                         {"owner", std::string(line.owner.view())},
                         {"reason", std::string(line.reason.view())},
                         {"kind", line.kind == base::MemoryKind::cpu ? "cpu" : "gpu"},
                         {"bytes", line.bytes},
                         {"in_use", line.use.in_use},
                         {"high_water", line.use.high_water},
                         {"refused", line.use.refused}});
    }
    return lines;
}

Json governor_json(const DeadlineSummary& deadline) {
    const auto& apart_s = deadline.least_s_between_changes;
    return {{"deadline_ms", deadline.deadline_ms},
            {"frames", deadline.frames},
            {"within_modelled", deadline.within_modelled},
            {"within_measured", deadline.within_measured},
            {"changes", deadline.changes},
            {"least_s_between_changes", apart_s ? Json(*apart_s) : Json()},
            {"frames_at_quality_level", deadline.frames_at_quality_level}};
}

Json traffic_json(const bus::TrafficCounts& traffic) {
    return {{"reports", traffic.reports}, {"incomplete", traffic.incomplete}, {"repeated", traffic.repeated},
            {"refused", traffic.refused}, {"outdated", traffic.outdated},     {"no_room", traffic.no_room}};
}

Json hindrances_json(const TerrainAlertCounts& alerts) {
    Json json = Json::object();
    for (std::size_t n = 1; n < kAlertHindranceCount; ++n)
        if (alerts.frames_by[n] > 0)
            json[name_of(static_cast<AlertHindrance>(n))] = {{"frames", alerts.frames_by[n]}, {"hours", alerts.hours_by[n]}};
    return json;
}

Json terrain_alerts_json(const TerrainAlertCounts& alerts) {
    return {{"hours", alerts.hours},
            {"possible_hours", alerts.possible_hours()},
            {"frames", alerts.frames()},
            {"possible_frames", alerts.possible_frames()},
            {"impossible", hindrances_json(alerts)},
            {"seconds_caution", alerts.seconds_caution},
            {"seconds_warning", alerts.seconds_warning},
            {"count", alerts.count},
            {"false_count", alerts.false_count},
            {"false_per_hour", alerts.hours > 0 ? Json(alerts.false_per_hour()) : Json()},
            {"warnings", alerts.warnings},
            {"false_warnings", alerts.false_warnings}};
}

Json ghost_json(const ShownGhost& ghost) {
    return {{"log", ghost.log},
            {"name", ghost.name},
            {"align", std::string(name_of(ghost.align))},
            {"shift_s", ghost.shift_s ? Json(*ghost.shift_s) : Json()},
            {"from_s", ghost.places.front().time_s},
            {"to_s", ghost.places.back().time_s}};
}

}  // namespace

FrameTimes frame_times(std::vector<double> total_ms) {
    if (total_ms.empty()) return {};
    std::sort(total_ms.begin(), total_ms.end());
    const std::size_t count = total_ms.size(), middle = count / 2;
    const double median = count % 2 == 1 ? total_ms[middle] : 0.5 * (total_ms[middle - 1] + total_ms[middle]);
    const auto rank = static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(count)));
    return {median, total_ms[rank - 1]};
}

std::string error_text(const RunSummary& summary) {
    if (summary.terrain_frames == 0) return "no terrain drawn";
    return "worst terrain error " + decimal(summary.worst_error_px, 2) + " px";
}

std::string start_error_text(const RunSummary& summary) {
    if (!(summary.worst_start_error_px > 0)) return {};
    return "; while its first chunks arrived, " + decimal(summary.worst_start_error_px, 2) + " px";
}

std::string run_summary_json(const RunSummary& summary, const base::BudgetTable& memory) {
    Json json;
    json["frames"] = summary.frames;
    json["fps_median"] = summary.fps_median;
    json["ms_p99"] = summary.ms_p99;
    json["heap_allocations_after_start"] = summary.heap_allocations_after_start;
    json["terrain_frames"] = summary.terrain_frames;
    json["frames_over_void"] = summary.frames_over_void;
    json["worst_error_px"] = summary.worst_error_px;
    json["worst_start_error_px"] = summary.worst_start_error_px;
    json["terrain_alerts"] = terrain_alerts_json(summary.terrain_alerts);
    json["assumes_heights"] = summary.closest.assumes_heights;
    json["closest"] = closest_json(summary.closest);
    json["gl_calls_outside_device"] = summary.gl_calls_outside_device;
    json["device"] = summary.device;
    json["design"] = summary.design;
    json["aircraft"] = summary.aircraft;
    json["palette"] = summary.palette;
    json["light"] = summary.light;
    json["terrain"] = summary.terrain;
    json["scene"] = summary.scene;
    json["log"] = summary.log;
    json["switches"] = summary.switches;
    json["video"] = summary.video;
    json["size"] = std::to_string(summary.width) + "x" + std::to_string(summary.height);
    json["costs"] = summary.costs;
    json["governor"] = governor_json(summary.deadline);
    json["gl"] = summary.gl;
    json["version"] = version();
    json["can"] = {{"frames", summary.can.frames},
                   {"decoded", summary.can.decoded},
                   {"alien", summary.can.alien},
                   {"errors", summary.can.errors},
                   {"dropped", summary.can.dropped},
                   {"broken_lines", summary.can.broken_lines},
                   {"other_lines", summary.can.other_lines},
                   {"traffic", traffic_json(summary.can.traffic)}};
    json["effects"] = Json::array();
    for (const EffectCount& effect : summary.effects) json["effects"].push_back(effect_count_json(effect));
    for (const ShownGhost& ghost : summary.ghosts) json["ghosts"].push_back(ghost_json(ghost));
    if (summary.has_accuracy_overlay) json["accuracy_overlay"] = true;
    json["interrupted"] = summary.interrupted;
    json["warnings"] = findings_json(summary.warnings);
    json["notes"] = summary.notes;
    json["memory"] = memory_json(memory);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tedavis::host_sim
