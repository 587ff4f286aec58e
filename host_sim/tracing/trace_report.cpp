#include "host_sim/tracing/trace_report.hpp"

#include <cstdio>

namespace tedavis::host_sim {
namespace {

std::string milliseconds(double ms) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f ms", ms);
    return text;
}

/// Of heights with their bounds as they were held: in memory, or in chunks.
std::uint64_t heights_bytes(const TracedGround& ground, const TracedShot& shot) {
    return shot.paged ? shot.paged->held_bytes : ground.bytes();
}

nlohmann::ordered_json paging_json(const PagedUse& use) {
    return {{"memory_bytes", use.memory_bytes},
            {"held_bytes", use.held_bytes},
            {"read_bytes", use.read_bytes},
            {"chunks", use.chunks},
            {"slots", use.slots},
            {"chunks_read", use.chunks_read},
            {"passes", use.passes}};
}

}  // namespace

std::string megabytes(std::uint64_t bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f MB", static_cast<double>(bytes) * 1e-6);
    return text;
}

std::string megabytes_up(std::uint64_t bytes) {
    const std::uint64_t tenths = (bytes + 99'999) / 100'000;
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

std::string shot_line(const TracedGround& ground, const std::string& operators, const TracedShot& shot) {
    const std::uint64_t heights = heights_bytes(ground, shot);
    std::string line = operators + "; " + milliseconds(shot.picture_ms) + " a picture (after " + milliseconds(shot.build_ms) +
                       " of preparing), " + megabytes(heights + shot.bytes()) + ": heights " + megabytes(heights);
    for (const TracedShot::Item& item : shot.items) line += ", " + item.name + " " + megabytes(item.bytes);
    if (!shot.paged) return line;
    return line + "; paged: " + std::to_string(shot.paged->chunks_read) + " chunks read (" + megabytes(shot.paged->read_bytes) +
           ") of " + std::to_string(shot.paged->chunks) + ", " + std::to_string(shot.paged->slots) + " in memory at a time";
}

nlohmann::ordered_json shot_json(const TracedGround& ground, const std::string& operators, const TracedShot& shot,
                                 std::uint32_t workers) {
    const std::uint64_t heights = heights_bytes(ground, shot);
    nlohmann::ordered_json bytes = {{"heights", heights}};
    for (const TracedShot::Item& item : shot.items) bytes[item.name] = item.bytes;
    bytes["all"] = heights + shot.bytes();
    nlohmann::ordered_json posts = {
        {"columns", ground.columns()}, {"rows", ground.rows()}, {"type", ground.is_whole() ? "int16" : "float32"}};
    if (!shot.paged) posts["void"] = ground.void_posts();
    nlohmann::ordered_json json = {{"operators", operators},
                                   {"picture_ms", shot.picture_ms},
                                   {"prepare_ms", shot.build_ms},
                                   {"bytes", bytes},
                                   {"posts", posts},
                                   {"kernel", shot.kernel},
                                   {"workers", workers},
                                   {"pieces", shot.pieces},
                                   {"stream_rounds", shot.rounds},
                                   {"ground_share", shot.ground_share},
                                   {"paged", shot.paged.has_value()}};
    if (shot.paged) json["paging"] = paging_json(*shot.paged);
    return json;
}

std::string choice_line(const TracedGround& ground, const ChosenShot& chosen) {
    const ChosenFrame& last = chosen.frames.back();
    std::string line = "chosen by region";
    for (std::size_t n = 0; n < chosen.levels.size(); ++n)
        line += std::string(n == 0 ? ": " : "; ") + std::to_string(last.regions[n]) + " " + chosen.levels[n].operators;
    char error[32];
    std::snprintf(error, sizeof error, "%.4f", last.error);
    return shot_line(ground, line + "; error " + error, chosen.shot);
}

nlohmann::ordered_json choice_json(const ChosenShot& chosen, const ChoicePlan& plan) {
    nlohmann::ordered_json json, levels = nlohmann::ordered_json::array(), frames = levels;
    for (const ChoiceLevel& level : chosen.levels)
        levels.push_back({{"operators", level.operators}, {"picture_ms", level.picture_ms}, {"error", level.error}});
    for (const ChosenFrame& frame : chosen.frames)
        frames.push_back({{"picture_ms", frame.picture_ms},
                          {"expected_ms", frame.expected_ms},
                          {"error", frame.error},
                          {"regions", frame.regions}});
    if (plan.deadline_ms > 0) json["deadline_ms"] = plan.deadline_ms;
    if (plan.most_error > 0) json["most_error"] = plan.most_error;
    json["levels"] = levels;
    json["frames"] = frames;
    return json;
}

nlohmann::ordered_json pose_json(const AircraftPose& pose) {
    return {{"lat_deg", pose.latitude_deg},    {"lon_deg", pose.longitude_deg}, {"alt_msl_m", pose.altitude_msl_m},
            {"heading_deg", pose.heading_deg}, {"pitch_deg", pose.pitch_deg},   {"roll_deg", pose.roll_deg}};
}

}  // namespace tedavis::host_sim
