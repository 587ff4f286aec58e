#include "host_sim/accuracy/knobs/seen_ground.hpp"

#include <glm/geometric.hpp>

#include "host_sim/tracing/ground_look.hpp"
#include "host_sim/tracing/shot_drawer.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/raytrace/surface/surface_height.hpp"

namespace tedavis::host_sim {
namespace {

raytrace::TraceSettings true_surface() {
    raytrace::TraceSettings settings;
    settings.surface.kind = raytrace::SurfaceKind::two_triangles;
    return settings;
}

template <class Height>
std::vector<SeenPlace> places_seen(const TracedGround& ground, const TracedShotPlan& plan) {
    base::SerialWorkers alone;
    const GroundLook look(ground, sun_at(plan.pose, plan.time));
    ShotDrawer<Height> drawer(ground, {true_surface()}, plan);
    drawer.build(ground, alone);
    static_cast<void>(drawer.draw(look.look(), {}, true, alone));
    const raytrace::HitPicture& hits = drawer.stages().hits();
    const std::uint32_t cells = ground.columns() - 1;
    std::vector<SeenPlace> places;
    for (std::uint32_t n = 0; n < plan.width * plan.height; ++n) {
        if (hits.cell[n] < 0) continue;
        const auto cell = static_cast<std::uint32_t>(hits.cell[n]);
        const std::uint32_t first_column = cell % cells, first_row = cell / cells;
        const double column = first_column + static_cast<double>(hits.u[n]), row = first_row + static_cast<double>(hits.v[n]);
        raytrace::SurfacePoint surface;
        if (!raytrace::find_surface(ground.grid<Height>(), true_surface().surface, column, row, surface)) continue;
        const earth::Ecef position = ground.space().position({column, row, surface.height});
        const earth::Geodetic place = earth::from_ecef(position);
        places.push_back({n % plan.width, n / plan.width, place.latitude_rad, place.longitude_rad, position});
    }
    return places;
}

}  // namespace

std::vector<SeenPose> seen_poses(const TracedGround& ground, const std::vector<AircraftPose>& poses, const SeenGrid& grid) {
    std::vector<SeenPose> seen;
    TracedShotPlan plan;
    plan.width = grid.across;
    plan.height = grid.down;
    plan.field_of_view_deg = grid.field_of_view_deg;
    for (const AircraftPose& pose : poses) {
        plan.pose = pose;
        const glm::dvec3 eye = view_of(ground, plan).eye;
        SeenPose one{pose, {}};
        for (const SeenPlace& place : seen_ground(ground, plan))
            if (glm::distance(place.position, eye) >= kNearestSeenPlace_m) one.places.push_back(place);
        if (!one.places.empty()) seen.push_back(std::move(one));
    }
    if (seen.empty())
        throw UserError("no pose of the flight shows ground of " + ground.path() + "; name the --terrain that it was flown over");
    return seen;
}

std::vector<AircraftPose> poses_of(const std::vector<SeenPose>& seen) {
    std::vector<AircraftPose> poses;
    for (const SeenPose& one : seen) poses.push_back(one.pose);
    return poses;
}

std::optional<glm::dvec2> pixel_at(const terrain::View& view, const earth::Ecef& place) {
    const glm::dvec3 way = place - view.eye;
    const double depth = glm::dot(way, view.forward);
    if (depth < view.near_m) return std::nullopt;
    return view.focal_px / depth * glm::dvec2(glm::dot(way, view.right), glm::dot(way, view.down));
}

std::vector<SeenPlace> seen_ground(const TracedGround& ground, const TracedShotPlan& plan) {
    return ground.is_whole() ? places_seen<std::int16_t>(ground, plan) : places_seen<float>(ground, plan);
}

}  // namespace tedavis::host_sim
