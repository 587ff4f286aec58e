#include "host_sim/tracing/trace_report.hpp"

#include <cstdio>

namespace tedavis::host_sim {
namespace {

std::string milliseconds(double ms) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f ms", ms);
    return text;
}

}  // namespace

std::string megabytes(std::uint64_t bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f MB", static_cast<double>(bytes) * 1e-6);
    return text;
}

std::string shot_line(const TracedGround& ground, const raytrace::TraceSettings& settings, const TracedShot& shot) {
    std::string line = describe(settings) + "; " + milliseconds(shot.picture_ms) + " a picture (after " +
                       milliseconds(shot.build_ms) + " of preparing), " + megabytes(ground.bytes() + shot.bytes()) +
                       ": heights " + megabytes(ground.bytes());
    for (const TracedShot::Item& item : shot.items) line += ", " + item.name + " " + megabytes(item.bytes);
    return line;
}

nlohmann::ordered_json shot_json(const TracedGround& ground, const raytrace::TraceSettings& settings, const TracedShot& shot,
                                 std::uint32_t workers) {
    nlohmann::ordered_json bytes = {{"heights", ground.bytes()}};
    for (const TracedShot::Item& item : shot.items) bytes[item.name] = item.bytes;
    bytes["all"] = ground.bytes() + shot.bytes();
    return {{"operators", describe(settings)},
            {"picture_ms", shot.picture_ms},
            {"prepare_ms", shot.build_ms},
            {"bytes", bytes},
            {"posts",
             {{"columns", ground.columns()},
              {"rows", ground.rows()},
              {"type", ground.is_whole() ? "int16" : "float32"},
              {"void", ground.void_posts()}}},
            {"kernel", shot.kernel},
            {"workers", workers},
            {"pieces", shot.pieces},
            {"stream_rounds", shot.rounds},
            {"ground_share", shot.ground_share}};
}

nlohmann::ordered_json pose_json(const AircraftPose& pose) {
    return {{"lat_deg", pose.latitude_deg},    {"lon_deg", pose.longitude_deg}, {"alt_msl_m", pose.altitude_msl_m},
            {"heading_deg", pose.heading_deg}, {"pitch_deg", pose.pitch_deg},   {"roll_deg", pose.roll_deg}};
}

}  // namespace tedavis::host_sim
