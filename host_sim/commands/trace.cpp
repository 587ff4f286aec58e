#include "host_sim/commands/trace.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/own_ground.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/temporary_folder.hpp"
#include "host_sim/tracing/require_pageable.hpp"
#include "host_sim/tracing/trace_report.hpp"
#include "host_sim/user_error.hpp"
#include "platform/threads/thread_workers.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kMaxMemory_mb = 1e12;  // more counts as this

void add_faults_note(const TracedGround& ground, const TracedShotPlan& plan, const TracedShot& shot, Console& console) {
    const glm::dvec3 eye = ground.space().place(view_of(ground, plan).eye);
    const std::optional<double> height_m = ground.height_near(eye);
    if (height_m && eye.z * ground.space().step_m() < *height_m)
        console.note("note: the eye is below the ground, and sees it from below; name a higher --pose");
    if (shot.is_sun_too_low)
        console.note("note: the sun is lower than 3 degrees then; the picture is lit from the north-west, 45 degrees high");
    if (ground.void_posts() > 0)
        console.note("note: " + std::to_string(ground.void_posts()) + " posts have no height; nothing is drawn there");
    if (shot.ground_share == 0) console.note("note: no ray meets the terrain; name another --pose");
}

std::string beside(const std::string& picture) { return std::filesystem::path(picture).replace_extension(".json").string(); }

void leave(const TraceOptions& options, const TracedShotPlan& plan, const TracedGround& ground, const TracedShot& shot,
           const nlohmann::ordered_json& json, const std::string& line, Console& console) {
    write_png(options.output, view_of(shot.pixels));
    write_file_atomically(beside(options.output), json_text(json) + "\n");
    add_faults_note(ground, plan, shot, console);
    console.result(options.output + ": " + line, json_text(json));
}

void add_data(const TracedData* data, nlohmann::ordered_json& json) {
    if (data == nullptr) return;
    json["data"] = {{"quantity", data->name()},
                    {"unit", data->unit()},
                    {"lowest", data->lowest()},
                    {"highest", data->highest()},
                    {"share", data->share()}};
}

std::string data_line(const TracedData* data) {
    if (data == nullptr) return "";
    char range[64];
    std::snprintf(range, sizeof range, "%.3g to %.3g ", data->lowest(), data->highest());
    return "; ground colored by " + data->name() + ", " + range + data->unit();
}

int trace_chosen(const TraceOptions& options, const TracedShotPlan& plan, const TracedGround& ground, base::Workers& workers,
                 Console& console) {
    const ChosenShot chosen = draw_chosen_shot(ground, plan, *options.choice, workers);
    nlohmann::ordered_json json = {{"picture", options.output}, {"preset", "chosen"}, {"pose", pose_json(plan.pose)}};
    json.update(shot_json(ground, "chosen by region", chosen.shot, workers.concurrency()));
    add_data(plan.data, json);
    json["choice"] = choice_json(chosen, *options.choice);
    if (!chosen.frames.back().keeps_deadline)
        console.note("note: even the cheapest settings take longer than the deadline; the picture has them everywhere");
    leave(options, plan, ground, chosen.shot, json, choice_line(ground, chosen) + data_line(plan.data), console);
    return 0;
}

/// Of the preset, with the search that the user chose.
raytrace::TraceSettings chosen_settings(const TraceOptions& options) {
    raytrace::TraceSettings settings = settings_of(options.preset);
    settings.search = options.search;
    if (settings.search.kind == raytrace::SearchKind::cones && settings.surface.kind != raytrace::SurfaceKind::bilinear)
        throw UserError(std::string("--search cones: stands over a bilinear surface, which --preset ") +
                        to_string(options.preset) + " has not; use --preset memory or another search");
    return settings;
}

nlohmann::ordered_json search_json(const raytrace::SearchSettings& search) {
    nlohmann::ordered_json json = {{"name", to_string(search.kind)}};
    if (search.is_exact()) return json;
    json["steps"] = search.steps;
    json["halvings"] = search.halvings;
    return json;
}

GroundMemory memory_of(const TraceOptions& options) {
    GroundMemory memory;
    memory.settings = options.choice ? choice_levels() : std::vector{chosen_settings(options)};
    if (options.memory_mb) memory.bytes = static_cast<std::uint64_t>(std::min(*options.memory_mb, kMaxMemory_mb) * 1e6);
    return memory;
}

}  // namespace

std::string database_of(const TraceTerrain& terrain, const std::string& folder, Console& console) {
    if (!terrain.database.empty() && !terrain.heights.empty())
        throw UserError("--terrain and --heights name two terrains; give one of them");
    if (!terrain.database.empty()) return terrain.database;
    return build_own_terrain({terrain.heights.empty() ? shipped_root() + kOwnRaster : terrain.heights, false}, folder, console);
}

AircraftPose usual_pose(const TracedGround& ground) {
    const glm::dvec3 over(0.5 * (ground.columns() - 1), 0.85 * (ground.rows() - 1), 0);
    const earth::Geodetic place = earth::from_ecef(ground.space().position(over));
    AircraftPose pose;
    pose.latitude_deg = base::degrees(place.latitude_rad);
    pose.longitude_deg = base::degrees(place.longitude_rad);
    pose.altitude_msl_m = ground.lowest_m() + 1.15 * (ground.highest_m() - ground.lowest_m()) + 150;
    pose.pitch_deg = -12;
    return pose;
}

std::unique_ptr<base::Workers> trace_workers(std::uint32_t count) {
    auto workers = platform::make_thread_workers({count == 0 ? platform::usable_processors() : count, nullptr});
    if (!workers.ok()) throw UserError(std::string(workers.error().message.view()));
    return std::move(workers.value());
}

int run_trace(const TraceOptions& options, Console& console) {
    const TemporaryFolder temporary;
    const std::unique_ptr<base::Workers> workers = trace_workers(options.workers);
    const TracedGround ground(database_of(options.terrain, temporary.path(), console), *workers, memory_of(options));
    require_pageable(ground, options.choice ? "settings by region" : std::string("--preset ") + to_string(options.preset),
                     ground.memory().settings);
    TracedShotPlan plan = options.plan;
    plan.pose = options.pose.value_or(usual_pose(ground));
    std::optional<TracedData> data;
    if (!options.scene.empty()) plan.data = &data.emplace(ground, options.scene, options.data, plan.time);
    if (data.has_value() && data->share() == 0)
        console.note("note: " + options.scene + " has no values of " + data->name() + " over this terrain");
    if (options.choice.has_value()) return trace_chosen(options, plan, ground, *workers, console);
    const raytrace::TraceSettings settings = chosen_settings(options);
    const TracedShot shot = draw_traced_shot(ground, settings, plan, *workers);
    nlohmann::ordered_json json = {{"picture", options.output},
                                   {"preset", to_string(options.preset)},
                                   {"search", search_json(options.search)},
                                   {"pose", pose_json(plan.pose)}};
    json.update(shot_json(ground, describe(settings), shot, workers->concurrency()));
    add_data(plan.data, json);
    leave(options, plan, ground, shot, json,
          std::string("preset ") + to_string(options.preset) + ": " + shot_line(ground, describe(settings), shot) +
              data_line(plan.data),
          console);
    return 0;
}

}  // namespace tedavis::host_sim
