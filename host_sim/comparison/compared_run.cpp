#include "host_sim/comparison/compared_run.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "host_sim/calendar_time.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "render_core/base/hash.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

using RunJson = nlohmann::ordered_json;
constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// Null where the record lacks it.
RunJson entry_at(const RunJson& record, const char* pointer) {
    const RunJson::json_pointer place(pointer);
    return record.contains(place) ? record.at(place) : RunJson();
}

double number_at(const RunJson& record, const char* pointer) {
    const RunJson entry = entry_at(record, pointer);
    return entry.is_number() ? entry.get<double>() : kNoValue;
}

std::string string_at(const RunJson& record, const char* pointer) {
    const RunJson entry = entry_at(record, pointer);
    return entry.is_string() ? entry.get<std::string>() : std::string();
}

int alert_at(const RunJson& record, const char* pointer) {
    const std::string level = string_at(record, pointer);
    return level == "warning" ? 2 : level == "caution" ? 1 : 0;
}

/// Features of all types of data together.
double data_drawn(const RunJson& record) {
    const RunJson data = entry_at(record, "/data");
    if (!data.is_object()) return kNoValue;
    double sum = 0;
    for (const auto& type : data.items()) {
        const double drawn = number_at(type.value(), "/drawn");
        sum += std::isfinite(drawn) ? drawn : 0;
    }
    return sum;
}

/// Regions are listed also where they keep the budget because data were decluttered.
double crowded_regions(const RunJson& record) {
    const double budget = number_at(record, "/clutter/budget");
    if (!std::isfinite(budget) || entry_at(record, "/clutter/is_measured") != true) return kNoValue;
    double count = 0;
    for (const RunJson& region : entry_at(record, "/clutter/regions")) count += number_at(region, "/clutter") > budget ? 1 : 0;
    return count;
}

bool has_flag(const RunJson& record, const char* name) {
    const RunJson flags = entry_at(record, "/flags");
    return flags.is_array() && std::find(flags.begin(), flags.end(), name) != flags.end();
}

void read_effects(const RunJson& record, ComparedFrame& frame) {
    const RunJson effects = entry_at(record, "/effects");
    frame.values[kEffectsDrawn] = kNoValue;
    if (!effects.is_array()) return;
    for (const RunJson& effect : effects)
        if (string_at(effect, "/state") == "run") frame.effects.push_back(string_at(effect, "/name"));
    frame.values[kEffectsDrawn] = static_cast<double>(frame.effects.size());
}

void read_values(const RunJson& record, ComparedFrame& frame) {
    frame.values[kAltitude] = number_at(record, "/own_ship/alt_msl_m");
    frame.values[kHeightAboveTerrain] = number_at(record, "/alerts/terrain/height_above_terrain_m");
    frame.values[kClearance] = number_at(record, "/clearance/nearest/distance_m");
    frame.values[kLabelsPlaced] = number_at(record, "/labels/placed");
    frame.values[kLabelsLeftOut] = number_at(record, "/labels/suppressed");
    frame.values[kDataDrawn] = data_drawn(record);
    frame.values[kCrowdedRegions] = crowded_regions(record);
    frame.values[kFrameTime] = number_at(record, "/ms/total");
    read_effects(record, frame);
}

void read_place(const RunJson& record, ComparedFrame& frame) {
    frame.latitude_deg = number_at(record, "/own_ship/lat_deg");
    frame.longitude_deg = number_at(record, "/own_ship/lon_deg");
    frame.has_place = string_at(record, "/own_ship/state") == "valid" && std::isfinite(frame.latitude_deg) &&
                      std::isfinite(frame.longitude_deg);
}

void read_compared_frame(const RunJson& record, ComparedFrame& frame) {
    const double utc_s = number_at(record, "/utc/time_s");
    if (std::isfinite(utc_s)) frame.utc_s = utc_s;
    frame.hash = string_at(record, "/hash");
    frame.terrain_alert = alert_at(record, "/alerts/terrain/level");
    frame.obstacle_alert = alert_at(record, "/alerts/obstacles/level");
    read_place(record, frame);
    frame.has_pressure_height = !has_flag(record, "own_ship.height_on_qnh") &&
                                std::isfinite(number_at(record, "/own_ship/alt_msl_m")) &&
                                record.contains(RunJson::json_pointer("/own_ship/alt_ellipsoid_m")) &&
                                entry_at(record, "/own_ship/alt_ellipsoid_m").is_null();
    read_values(record, frame);
    if (!std::filesystem::exists(frame.picture)) frame.picture.clear();
}

/// Logs may have gigabytes: of two that have the same size, begin and end alike, the middle is not read.
void read_log_content(ComparedRun& run) {
    constexpr std::uint64_t kSampleBytes = 64u << 10;
    std::error_code failure;
    const std::optional<std::string> path = file_of_run(run.folder, run.log);
    if (!path) return;
    const std::uint64_t size = std::filesystem::file_size(*path, failure);
    std::ifstream file(*path, std::ios::binary);
    if (failure || !file) return;
    std::vector<char> bytes(std::min(kSampleBytes, size));
    base::Fnv1a64 hash;
    for (const std::uint64_t offset : {std::uint64_t{0}, size - bytes.size()}) {
        file.seekg(static_cast<std::streamoff>(offset));
        if (!file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) return;
        hash.add(bytes.data(), bytes.size());
    }
    run.log_content = std::make_pair(size, hash.value());
}

/// An interrupted run may have no summary.
void read_names(ComparedRun& run) {
    const RunJson summary = summary_of_run(run.folder);
    if (summary.is_null()) return;
    run.log = string_at(summary, "/log");
    run.design = string_at(summary, "/design");
    run.device = string_at(summary, "/device");
    run.aircraft = string_at(summary, "/aircraft");
    run.palette = string_at(summary, "/palette");
    run.light = string_at(summary, "/light");
    run.terrain = string_at(summary, "/terrain");
    run.scene = string_at(summary, "/scene");
    run.size = string_at(summary, "/size");
    run.version = string_at(summary, "/version");
    const RunJson can_frames = entry_at(summary, "/can/frames");
    if (can_frames.is_number_unsigned()) run.can_frames = can_frames.get<std::uint64_t>();
    run.closest = entry_at(summary, "/closest");
    run.assumes_heights = entry_at(summary, "/assumes_heights") == true || entry_at(summary, "/closest/assumes_heights") == true;
}

}  // namespace

ComparedRun read_compared_run(const std::string& folder) {
    ComparedRun run;
    run.folder = folder;
    run.frames = frames_of_run<ComparedFrame>(folder, read_compared_frame);
    read_names(run);
    read_log_content(run);
    return run;
}

bool knows_picture(const ComparedFrame& frame) { return frame.hash.find_first_not_of('0') != std::string::npos; }

bool knows_phase(const ComparedFrame& frame) { return !frame.phase.empty() && frame.phase.rfind("unknown", 0) != 0; }

std::optional<double> utc_offset_s(const ComparedRun& run) {
    for (const ComparedFrame& frame : run.frames)
        if (frame.utc_s) return *frame.utc_s - frame.time_s;
    return std::nullopt;
}

std::string frame_time_words(const ComparedRun& run, double time_s) {
    const std::optional<double> offset_s = utc_offset_s(run);
    if (!offset_s) return decimal(time_s, 1) + " s";
    return utc_text(base::Time{} + base::Duration::from_seconds(time_s + *offset_s)).substr(11, 8) + " UTC";
}

double median_step_s(const ComparedRun& run) {
    std::vector<double> steps_s;
    for (std::size_t n = 1; n < run.frames.size(); ++n) steps_s.push_back(run.frames[n].time_s - run.frames[n - 1].time_s);
    if (steps_s.empty()) return 0;
    const auto middle = steps_s.begin() + static_cast<std::ptrdiff_t>(steps_s.size() / 2);
    std::nth_element(steps_s.begin(), middle, steps_s.end());
    return *middle;
}

double ground_distance_m(double latitude_a_deg, double longitude_a_deg, double latitude_b_deg, double longitude_b_deg) {
    const double north_rad = base::radians(latitude_b_deg - latitude_a_deg);
    const double east_rad = earth::wrap_longitude(base::radians(longitude_b_deg - longitude_a_deg)) *
                            std::cos(base::radians(0.5 * (latitude_a_deg + latitude_b_deg)));
    return std::hypot(north_rad, east_rad) * earth::kMeanRadius_m;
}

}  // namespace tedavis::host_sim
