#include "host_sim/replay/pose_findings.hpp"

#include "host_sim/reports/geo_extent.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

bool lies_inside(const terrain::TerrainDatabase& database, double latitude_deg, double longitude_deg) {
    return database.lattice().point(base::radians(latitude_deg), earth::wrap_longitude(base::radians(longitude_deg))).inside;
}

std::string place_words(double latitude_deg, double longitude_deg) {
    return decimal(latitude_deg, 4) + "," + decimal(longitude_deg, 4);
}

Finding outside_finding(const AircraftPose& pose, const std::string& terrain, const terrain::TerrainDatabase& database) {
    std::string text = "the pose " + place_words(pose.latitude_deg, pose.longitude_deg) + " lies outside " + terrain +
                       ", which covers " + extent_of(database).words();
    const bool may_be_swapped = pose.longitude_deg >= -90 && pose.longitude_deg <= 90;
    if (may_be_swapped && lies_inside(database, pose.longitude_deg, pose.latitude_deg))
        text += "; with latitude and longitude exchanged it lies inside, so write " +
                place_words(pose.longitude_deg, pose.latitude_deg);
    return {"terrain.outside", text, 1};
}

}  // namespace

Findings pose_findings(const AircraftPose& pose, const display::FrameRecord& record, const std::string& terrain,
                       display::Display& display) {
    const terrain::TerrainDatabase* const database = display.planner().terrain_database();
    if (database == nullptr) return {};
    if (!lies_inside(*database, pose.latitude_deg, pose.longitude_deg)) return {outside_finding(pose, terrain, *database)};
    const base::Stamped<double> above = display.planner().height_above_terrain(record.own_ship, record.time);
    if (!above.received()) return {{"terrain.no_height", "the ground below the pose has no height in " + terrain + " (void)", 1}};
    constexpr double kRounding_m = 0.5;
    if (above.value_or(0) < -kRounding_m)
        return {{"terrain.above_own_ship",
                 "the pose lies " + decimal(-above.value_or(0), 0) + " m below the ground of " + terrain + ", which is " +
                     decimal(record.altitude_msl_m - above.value_or(0), 0) + " m high there",
                 1}};
    const bool is_traced = record.terrain.renderer.view() == "trace";
    if (record.terrain.triangles == 0 && !is_traced)
        return {{"terrain.not_in_view", "no terrain of " + terrain + " is in the picture of this pose", 1}};
    return {};
}

}  // namespace tedavis::host_sim
