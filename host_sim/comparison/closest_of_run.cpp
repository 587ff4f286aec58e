#include "host_sim/comparison/closest_of_run.hpp"

#include <cmath>

#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {
namespace {

using ClosestOfRunJson = nlohmann::ordered_json;

double number_of_point(const ClosestOfRunJson& point, const char* key) {
    return point.contains(key) && point[key].is_number() ? point[key].get<double>() : std::nan("");
}

std::string text_of_point(const ClosestOfRunJson& point, const char* key) {
    return point.contains(key) && point[key].is_string() ? point[key].get<std::string>() : std::string();
}

std::optional<RunClosest> closest_of_summary(const ClosestOfRunJson& closest) {
    const ClosestOfRunJson::json_pointer first("/by_height/0");
    if (!closest.is_object() || !closest.contains(first) || !closest.at(first).is_object()) return std::nullopt;
    const ClosestOfRunJson& point = closest.at(first);
    const std::string sub = text_of_point(point, "sub_phase");
    RunClosest found{number_of_point(point, "height_above_terrain_m"),
                     number_of_point(point, "time_s"),
                     number_of_point(point, "lat_deg"),
                     number_of_point(point, "lon_deg"),
                     text_of_point(point, "phase") + (sub.empty() ? "" : "." + sub),
                     true};
    if (!std::isfinite(found.height_m) || !std::isfinite(found.time_s)) return std::nullopt;
    found.left_out_s = std::fmax(number_of_point(closest, "left_out_s"), 0);
    found.unknown_s = std::fmax(number_of_point(closest, "unknown_s"), 0);
    return found;
}

}  // namespace

bool is_known_to_fly(const ComparedFrame& frame) {
    return knows_phase(frame) && frame.phase != "ground" && frame.phase != "takeoff.start" && frame.phase != "approach.landing";
}

std::optional<RunClosest> closest_of_run(const ComparedRun& run) {
    std::optional<RunClosest> found = closest_of_summary(run.closest);
    if (found) return found;
    for (const ComparedFrame& frame : run.frames) {
        const double height_m = frame.values[kHeightAboveTerrain];
        if (!is_known_to_fly(frame) || !std::isfinite(height_m) || (found && found->height_m <= height_m)) continue;
        found.emplace();
        found->height_m = height_m;
        found->time_s = frame.time_s;
        found->phase = frame.phase;
        if (frame.has_place) found->latitude_deg = frame.latitude_deg, found->longitude_deg = frame.longitude_deg;
    }
    return found;
}

std::string searched_words(const RunClosest& closest) {
    if (!closest.is_of_summary) return "its frames in flight, since its summary has no closest point";
    std::string without;
    if (closest.left_out_s > 0) without = decimal(closest.left_out_s, 0) + " s of take-off and landing";
    if (closest.unknown_s >= 0.5)
        without += (without.empty() ? "" : " and ") + decimal(closest.unknown_s, 0) + " s without a position or known ground";
    return "its whole run, between its frames too" + (without.empty() ? without : ", but for " + without);
}

}  // namespace tedavis::host_sim
