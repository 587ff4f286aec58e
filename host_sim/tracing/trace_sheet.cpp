#include "host_sim/tracing/trace_sheet.hpp"

namespace tedavis::host_sim {
namespace {

using raytrace::TraceSettings;

template <class Change>
TraceSheet::Picture changed(const char* title, const char* file, const Change& change) {
    TraceSheet::Picture picture;
    picture.title = title;
    picture.file = file;
    picture.settings = settings_of(TracePreset::time);
    change(picture.settings);
    return picture;
}

TraceSheet::Group presets() {
    TraceSheet::Group group{"Presets", {}};
    for (const TracePreset preset : kTracePresets) {
        TraceSheet::Picture picture;
        picture.title = to_string(preset);
        picture.file = picture.title + ".png";
        picture.settings = settings_of(preset);
        group.pictures.push_back(picture);
    }
    return group;
}

TraceSheet::Group surfaces() {
    using raytrace::SurfaceKind;
    return {"Surfaces",
            {changed("bilinear", "bilinear.png", [](TraceSettings& s) { s.surface.kind = SurfaceKind::bilinear; }),
             changed("bicubic", "bicubic.png", [](TraceSettings& s) { s.surface.kind = SurfaceKind::bicubic; }),
             changed("bicubic, stored 4 x as fine", "stored.png",
                     [](TraceSettings& s) {
                         s.surface.kind = SurfaceKind::approximate_bicubic;
                         s.surface.subdivisions = 4;
                         s.is_surface_stored = true;
                     }),
             changed("with noise", "noise.png", [](TraceSettings& s) {
                 s.surface.kind = SurfaceKind::bilinear;
                 s.surface.micro.kind = raytrace::MicroKind::noise;
                 s.surface.micro.noise.amplitude = 6;
                 s.surface.micro.noise.frequency = 1.5;
             })}};
}

TraceSheet::Group lights() {
    using namespace raytrace;
    return {
        "Light and antialiasing",
        {changed("Phong", "phong.png", [](TraceSettings& s) { s.shading = Shading::phong; }),
         changed("sky view", "sky_view.png", [](TraceSettings& s) { s.ambient = Ambient::sky_view; }),
         changed("ambient apertures", "apertures.png", [](TraceSettings& s) { s.ambient = Ambient::apertures; }),
         changed("cast shadows", "shadows.png", [](TraceSettings& s) { s.has_shadows = true; }),
         changed("8 paths of 2 bounces", "paths.png",
                 [](TraceSettings& s) {
                     s.paths = 8;
                     s.bounces = 2;
                 }),
         changed("averaged slopes", "averages.png", [](TraceSettings& s) { s.antialiasing = Antialiasing::average_mipmap; }),
         changed("supersampling", "supersampling.png", [](TraceSettings& s) { s.antialiasing = Antialiasing::supersampling; })}};
}

}  // namespace

TraceSheet plan_trace_sheet() {
    TraceSheet sheet;
    sheet.groups = {presets(), surfaces(), lights()};
    return sheet;
}

void draw_trace_sheet(TraceSheet& sheet, const TracedGround& ground, const TracedShotPlan& plan, base::Workers& workers,
                      const std::function<void(std::size_t done, std::size_t all)>& drawn) {
    std::size_t all = 0, done = 0;
    for (const TraceSheet::Group& group : sheet.groups) all += group.pictures.size();
    for (TraceSheet::Group& group : sheet.groups)
        for (TraceSheet::Picture& picture : group.pictures) {
            picture.shot = draw_traced_shot(ground, picture.settings, plan, workers);
            drawn(++done, all);
        }
    const TracedShot best = sheet.groups.front().pictures.back().shot;
    for (TraceSheet::Group& group : sheet.groups)
        for (TraceSheet::Picture& picture : group.pictures)
            picture.from_quality = picture_difference(view_of(picture.shot.pixels), view_of(best.pixels));
}

}  // namespace tedavis::host_sim
