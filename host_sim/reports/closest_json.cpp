#include "host_sim/reports/closest_json.hpp"

#include "host_sim/reports/clearance_json.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using ClosestJson = nlohmann::ordered_json;

ClosestJson closest_one_json(const StatedClosest& closest) {
    const TrackSample& sample = closest.point.sample;
    const auto text_or_null = [](const std::string& text) { return text.empty() ? ClosestJson() : ClosestJson(text); };
    const std::string sub = flight::sub_phase_name(sample.phase);
    return {{"time_s", closest.time_s},
            {"utc", text_or_null(closest.utc)},
            {"lat_deg", base::degrees(sample.own.place.latitude_rad)},
            {"lon_deg", base::degrees(sample.own.place.longitude_rad)},
            {"alt_msl_m", sample.own.height_msl_m},
            {"height_is_geometric", sample.own.is_geometric},
            {"height_above_terrain_m", sample.height_above_terrain_m},
            {"uncertainty", uncertainty_json(sample.uncertainty)},
            {"nearest", ground_place_json(closest.point.nearest)},
            {"phase", flight::scenario_name(sample.phase)},
            {"sub_phase", sub},
            {"alert", alert_level_text(closest.frame.alert)},
            {"design", closest.frame.design},
            {"frame", closest.frame.frame},
            {"frame_time_s", closest.frame.time_s},
            {"picture", text_or_null(closest.frame.picture)}};
}

}  // namespace

const char* alert_level_text(policy::TerrainAhead level) {
    static constexpr const char* kLevels[] = {"none", "caution", "warning"};
    return kLevels[static_cast<std::size_t>(level)];
}

std::string when_text(const StatedClosest& closest) {
    if (closest.utc.empty()) return decimal(closest.time_s, 1) + " s";
    return closest.utc.substr(closest.utc.find('T') + 1, 10) + " UTC";
}

nlohmann::ordered_json closest_json(const ClosestReport& report) {
    if (!report.is_searched) return {};
    ClosestJson json{{"sample_step_s", report.sample_step_s},
                     {"left_out_s", report.left_out_s},
                     {"unknown_s", report.unknown_s},
                     {"by_height", ClosestJson::array()},
                     {"assumes_heights", report.assumes_heights},
                     {"by_distance", ClosestJson::array()}};
    for (const StatedClosest& closest : report.by_height) json["by_height"].push_back(closest_one_json(closest));
    for (const StatedClosest& closest : report.by_distance) json["by_distance"].push_back(closest_one_json(closest));
    return json;
}

}  // namespace tedavis::host_sim
