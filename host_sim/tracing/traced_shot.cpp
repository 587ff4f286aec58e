#include "host_sim/tracing/traced_shot.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "host_sim/tracing/ground_look.hpp"
#include "host_sim/tracing/paged_drawer.hpp"
#include "host_sim/tracing/shot_drawer.hpp"
#include "render_core/base/units.hpp"
#include "render_core/raytrace/picture/trace_presets.hpp"

namespace tedavis::host_sim {
namespace {

using raytrace::TraceSettings;
using Clock = std::chrono::steady_clock;

constexpr double kLong_ms = 2000;  // a picture that takes longer is drawn once

double milliseconds_since(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// `rounds` is how often it is drawn at most.
template <class Drawer>
TracedShot draw_by(Drawer& drawer, const TracedGround& ground, const TracedShotPlan& plan, std::uint32_t rounds,
                   base::Workers& workers) {
    TracedShot shot;
    const auto begin = Clock::now();
    drawer.build(ground, workers);
    shot.build_ms = milliseconds_since(begin);
    const SunChoice sun = sun_at(plan.pose, plan.time);
    shot.is_sun_too_low = sun.is_too_low;
    const GroundLook look(ground, sun, plan.data);
    std::vector<double> times;
    while (times.size() < rounds && (times.empty() || times.front() < kLong_ms)) {
        const auto drawn = Clock::now();
        shot.rounds = drawer.draw(look.look(), {}, plan.is_direct, workers);
        times.push_back(milliseconds_since(drawn));
    }
    std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
    shot.picture_ms = times[times.size() / 2];
    drawer.tell(shot);
    return shot;
}

template <class Height>
TracedShot draw_in_memory(const TracedGround& ground, const TraceSettings& settings, const TracedShotPlan& plan,
                          base::Workers& workers) {
    ShotDrawer<Height> drawer(ground, {settings}, plan);
    return draw_by(drawer, ground, plan, plan.rounds, workers);
}

/// Once, so that its time includes all reading.
TracedShot draw_paged(const TracedGround& ground, const TraceSettings& settings, const TracedShotPlan& plan,
                      base::Workers& workers) {
    PagedDrawer drawer(ground, settings, plan, workers);
    return draw_by(drawer, ground, plan, 1, workers);
}

}  // namespace

terrain::View view_of(const TracedGround& ground, const TracedShotPlan& plan) {
    const AircraftPose& pose = plan.pose;
    const double latitude = base::radians(pose.latitude_deg), longitude = base::radians(pose.longitude_deg);
    const glm::dmat3 body = earth::body_axes(latitude, longitude, base::radians(pose.heading_deg), base::radians(pose.pitch_deg),
                                             base::radians(pose.roll_deg));
    const earth::MslHeight height{pose.altitude_msl_m};
    terrain::View view;
    view.eye =
        earth::to_ecef({latitude, longitude, earth::to_ellipsoid(height, ground.database().undulation(latitude, longitude))});
    view.forward = body[0];
    view.right = body[1];
    view.down = body[2];
    view.width = plan.width;
    view.height = plan.height;
    view.focal_px = 0.5 * plan.width / std::tan(base::radians(0.5 * plan.field_of_view_deg));
    return view;
}

const char* to_string(TracePreset preset) noexcept {
    switch (preset) {
        case TracePreset::time: return "time";
        case TracePreset::quality: return "quality";
        case TracePreset::memory: break;
    }
    return "memory";
}

const char* to_string(raytrace::SearchKind kind) noexcept {
    switch (kind) {
        case raytrace::SearchKind::exact: return "exact";
        case raytrace::SearchKind::cells: return "cells";
        case raytrace::SearchKind::ray: return "ray";
        case raytrace::SearchKind::cones: break;
    }
    return "cones";
}

TraceSettings settings_of(TracePreset preset) {
    switch (preset) {
        case TracePreset::time: return raytrace::time_preset();
        case TracePreset::quality: return raytrace::quality_preset();
        case TracePreset::memory: break;
    }
    return raytrace::memory_preset();
}

std::string describe(const TraceSettings& settings) {
    using namespace raytrace;
    std::string text;
    switch (settings.surface.kind) {
        case SurfaceKind::two_triangles: text = "two triangles a cell"; break;
        case SurfaceKind::bilinear: text = "bilinear patches"; break;
        case SurfaceKind::bicubic: text = "bicubic patches"; break;
        case SurfaceKind::approximate_bicubic: text = "bicubic patches in small bilinear ones"; break;
    }
    if (settings.antialiasing == Antialiasing::average_mipmap) text += ", averaged slopes";
    if (settings.antialiasing == Antialiasing::supersampling)
        text += ", up to " + std::to_string(settings.rays_along * settings.rays_along) + " rays a pixel";
    if (settings.shading == Shading::lambert) text += ", Lambert";
    if (settings.shading == Shading::phong) text += ", Phong";
    if (settings.ambient == Ambient::sky_view) text += ", sky view";
    if (settings.ambient == Ambient::apertures) text += ", apertures";
    if (settings.has_shadows) text += ", cast shadows";
    if (settings.mirrors > 0) text += ", mirrors";
    if (!settings.search.is_exact())
        text += std::string(", search by ") + to_string(settings.search.kind) + " (" + std::to_string(settings.search.steps) +
                " steps, " + std::to_string(settings.search.halvings) + " halvings)";
    return text;
}

std::uint64_t TracedShot::bytes() const {
    std::uint64_t sum = 0;
    for (const Item& item : items) sum += item.bytes;
    return sum;
}

TracedShot draw_traced_shot(const TracedGround& ground, const TraceSettings& settings, const TracedShotPlan& plan,
                            base::Workers& workers) {
    if (ground.is_paged()) return draw_paged(ground, settings, plan, workers);
    return ground.is_whole() ? draw_in_memory<std::int16_t>(ground, settings, plan, workers)
                             : draw_in_memory<float>(ground, settings, plan, workers);
}

}  // namespace tedavis::host_sim
