#include "host_sim/evaluation/flight_run.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include "host_sim/reports/run_records.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Json& json, const char* key) {
    return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : std::string();
}

double record_number(const Json& json, const char* key) {
    return json.contains(key) && json[key].is_number() ? json[key].get<double>() : 0.0;
}

Json object_of(const Json& json, const char* key) {
    return json.is_object() && json.contains(key) && json[key].is_object() ? json[key] : Json::object();
}

/// A record that does not say what its design states takes its own weights for that.
MainWeights main_weights(const Json& record) {
    MainWeights weights;
    const Json presentation = object_of(record, "presentation"), all = object_of(presentation, "weights");
    for (std::size_t n = 0; n < weights.size(); ++n) {
        const Json stated = object_of(all, kMainAspectNames[n]);
        weights[n].weight = record_number(object_of(presentation, kMainAspectNames[n]), "weight");
        weights[n].stated = stated.contains("stated") ? record_number(stated, "stated") : weights[n].weight;
    }
    return weights;
}

std::string prioritized_aspect(const MainWeights& weights) {
    std::string best;
    double highest = 0;
    for (std::size_t n = 0; n < weights.size(); ++n) {
        if (weights[n].weight == highest) best.clear();
        if (weights[n].weight > highest) best = kMainAspectNames[n], highest = weights[n].weight;
    }
    return best;
}

FrameObstacle frame_obstacle(const Json& json) {
    FrameObstacle obstacle{text_of(json, "name"), text_of(json, "state"), record_number(json, "ahead_s"), {}};
    const Json box = json.value("box", Json::array());
    for (std::size_t n = 0; n < obstacle.box.size() && n < box.size(); ++n)
        obstacle.box[n] = box[n].is_number() ? box[n].get<double>() : 0.0;
    return obstacle;
}

std::optional<std::vector<FrameObstacle>> frame_obstacles(const Json& record) {
    if (!record.contains("obstacles") || !record["obstacles"].is_array()) return std::nullopt;
    std::vector<FrameObstacle> all;
    for (const Json& one : record["obstacles"])
        if (one.is_object()) all.push_back(frame_obstacle(one));
    return all;
}

void read_from_record(const Json& record, FlightFrame& frame) {
    frame.phase_source = text_of(record, "phase_source");
    frame.weights = main_weights(record);
    frame.prioritized = prioritized_aspect(frame.weights);
    frame.layers = layer_names(record);
    if (record.contains("presentation") && record["presentation"].is_object())
        frame.design = text_of(record["presentation"], "design");
    frame.light = text_of(record, "symbology_light");
    frame.has_accuracy_overlay = record.contains("accuracy_overlay") && record["accuracy_overlay"] == true;
    frame.has_scene = record_number(record, "scene_revision") > 0;
    frame.obstacles = frame_obstacles(record);
}

void read_flight_frame(const Json& record, FlightFrame& frame) {
    read_from_record(record, frame);
    if (!std::filesystem::exists(frame.picture))
        throw UserError(frame.picture + ": the run has no picture of this frame; replay it again with --frames png");
}

void read_summary(FlightRun& run) {
    const Json summary = summary_of_run(run.folder);
    if (!summary.is_object()) return;
    run.log = text_of(summary, "log");
    run.design = text_of(summary, "design");
    run.device = text_of(summary, "device");
    run.size = text_of(summary, "size");
    run.palette = text_of(summary, "palette");
    run.light = text_of(summary, "light");
}

}  // namespace

std::vector<std::string> first_aspects(const MainWeights& weights) {
    constexpr double kEqual = 1e-9;
    AspectWeight highest;
    for (const AspectWeight& one : weights) highest.weight = std::max(highest.weight, one.weight);
    const auto has_highest = [&](const AspectWeight& one) { return one.weight > highest.weight - kEqual; };
    for (const AspectWeight& one : weights)
        if (has_highest(one)) highest.stated = std::max(highest.stated, one.stated);
    std::vector<std::string> names;
    for (std::size_t n = 0; n < weights.size(); ++n)
        if (highest.weight > 0 && has_highest(weights[n]) && weights[n].stated > highest.stated - kEqual)
            names.emplace_back(kMainAspectNames[n]);
    return names;
}

std::vector<std::string> layer_names(const Json& record) {
    std::vector<std::string> names;
    if (!record.contains("layers") || !record["layers"].is_array()) return names;
    for (const Json& name : record["layers"]) names.push_back(name.is_string() ? name.get<std::string>() : std::string());
    return names;
}

FlightFrame flight_frame_of(const Json& record) {
    FlightFrame frame;
    frame.phase = phase_of_record(record);
    read_from_record(record, frame);
    return frame;
}

bool is_folder(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::is_directory(path, ignored);
}

FlightRun read_flight_run(const std::string& folder) {
    FlightRun run;
    run.folder = folder;
    run.frames = frames_of_run<FlightFrame>(folder, read_flight_frame);
    read_summary(run);
    for (FlightFrame& frame : run.frames)
        if (frame.light.empty()) frame.light = run.light;
    return run;
}

std::vector<Json> records_of(const FlightRun& run, const std::vector<std::uint64_t>& frames) {
    std::vector<Json> found(frames.size());
    RunRecords records(run.folder);
    while (const std::optional<Json> record = records.next()) {
        const auto frame = (*record)["frame"].get<std::uint64_t>();
        for (std::size_t n = 0; n < frames.size(); ++n)
            if (frames[n] == frame) found[n] = *record;
    }
    return found;
}

std::vector<FlightPhaseSpan> phase_spans(const std::vector<FlightFrame>& frames) {
    std::vector<FlightPhaseSpan> spans;
    for (std::size_t n = 0; n < frames.size(); ++n) {
        if (spans.empty() || spans.back().phase != frames[n].phase) spans.push_back({frames[n].phase, n, n});
        spans.back().end = n + 1;
    }
    return spans;
}

}  // namespace tedavis::host_sim
