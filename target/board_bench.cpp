#include "target/board_bench.hpp"

#include <cstdio>

#include "platform/files/file_byte_source.hpp"
#include "platform/runtime/cost_bench.hpp"
#include "render_core/base/units.hpp"
#include "render_core/display/planner/glyph_elements.hpp"
#include "render_core/display/preroll.hpp"
#include "render_core/effects/design_effects.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/readback.hpp"
#include "target/board_display.hpp"

namespace tedavis::target {
namespace {

using effects::Effect;
using effects::Overhead;
using platform::BenchNote;
using platform::BenchPicture;

constexpr double kHeading_deg = 140, kPitch_deg = -14;
constexpr base::Duration kBetweenLines = base::Duration::seconds(5);

/// Where heights are looked for, as shares of the database's width and height.
struct Share {
    double across, down;
};
constexpr Share kPlaces[] = {{0.5, 0.5}, {0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}};

flight::StatedPose pose_at(const terrain::FileHeader& header, const Share& share) {
    flight::StatedPose pose;
    pose.latitude_rad = base::radians(header.north_deg - share.down * (header.rows - 1) * header.step_lat_deg);
    pose.longitude_rad = base::radians(header.west_deg + share.across * (header.columns - 1) * header.step_lon_deg);
    pose.altitude_msl_m = header.max_height_m + BoardBench::kHeightAboveGround_m;
    pose.heading_rad = base::radians(kHeading_deg);
    pose.pitch_rad = base::radians(kPitch_deg);
    return pose;
}

/// Of a display that is current; missing where the terrain has no heights there.
base::Stamped<double> height_above_ground(display::Display& display, const terrain::TerrainDatabase& terrain,
                                          const flight::StatedPose& pose, base::Time time) {
    const earth::GeoidUndulation undulation = terrain.undulation(pose.latitude_rad, pose.longitude_rad);
    const flight::AircraftState state = flight::posed_state(pose, undulation, time);
    display::settle(display, {state, {}, time});
    return display.planner().height_above_terrain(state.own_ship, time);
}

}  // namespace

BoardBench::BoardBench(const BoardSettings& settings, const BoardClocks& clocks, const StopSignal& stop, const EventLog& log)
    : settings_(settings), clocks_(clocks), stop_(stop), log_(log) {
    if (settings_.scene.empty()) return;
    const auto scene = platform::open_file(settings_.scene.c_str());
    has_scene_ = scene.ok();
    if (!has_scene_) log_.write({scene.error().message.view(), "; costs are measured without spatial data"});
}

base::Error BoardBench::find_place(platform::BenchPlace& place) {
    if (!gl::has_compiler(settings_.device.capability))
        return base::make_error("--calibrate: device '", settings_.device.name.view(),
                                "' has no compiler for programs with and without each effect; measure its costs with `tedavis "
                                "calibrate` on a desk with the same driver");
    const auto picture = std::make_unique<BenchPicture>();
    own_picture(*picture);
    std::unique_ptr<platform::DisplayHost> host;
    if (base::Error error = open(*picture, host)) return error;
    display::Display& display = host->display();
    const terrain::TerrainDatabase* const terrain = display.planner().terrain_database();
    if (terrain == nullptr)
        return base::make_error("--calibrate: the board file names no terrain to measure over; add [terrain] with a database");
    for (const Share& share : kPlaces) {
        place.pose = pose_at(terrain->header(), share);
        const base::Stamped<double> height = height_above_ground(display, *terrain, place.pose, place.time);
        if (!height.received()) continue;
        place.pose.altitude_msl_m -= height.value_or(0) - kHeightAboveGround_m;
        return {};
    }
    return base::make_error(
        settings_.terrain.view(),
        ": has no heights in its middle, and none round it, so no costs can be measured over it; name another "
        "database in [terrain]");
}

void BoardBench::own_picture(BenchPicture& picture) const { quality_picture(0, picture); }

void BoardBench::quality_picture(std::size_t n, BenchPicture& picture) const {
    const design::DesignSettings& design = n == 0 ? settings_.design : settings_.phases.at(n);
    picture.design = effects::design_on(settings_.device, design);
    picture.name = picture.design.name.view();
    picture.has_terrain = true;
    picture.has_scene = has_scene_;
}

BenchNote BoardBench::picture_with(Effect effect, BenchPicture& picture) const {
    for (std::size_t n = 0; n < quality_pictures(); ++n) {
        quality_picture(n, picture);
        if (platform::asks_for(picture.design, effect)) return {};
    }
    own_picture(picture);
    picture.design = effects::with_effect(picture.design, effect);
    return platform::asks_for(picture.design, effect) ? BenchNote() : BenchNote("no design of this board asks for it");
}

BenchNote BoardBench::picture_with(Overhead overhead, BenchPicture& picture) const {
    own_picture(picture);
    if (!has_scene_) return "the board has no spatial data";
    if (overhead != Overhead::glyphs) return {};
    const design::DataElementList all = picture.design.data.elements;
    picture.design.data.elements.clear();
    for (const design::DataElement& element : all)
        if (display::is_glyph_technique(element.technique))
            static_cast<void>(picture.design.data.elements.try_push_back(element));
    return {};
}

base::Error BoardBench::open(const BenchPicture& picture, std::unique_ptr<platform::DisplayHost>& host) {
    platform::DisplayHostSettings of_host = off_screen_host_settings(settings_);
    of_host.display.design = picture.design;
    of_host.display.phases = nullptr;
    of_host.display.expects_scene = false;
    if (!picture.has_terrain) of_host.terrain.path = "";
    if (picture.has_scene && has_scene_) of_host.scene.path = settings_.scene.c_str();
    of_host.terrain_fault = platform::TerrainFaultPolicy::refuse;
    of_host.arrival = terrain::ArrivalMode::exact;
    of_host.residency = platform::Residency::lazy;
    host = std::make_unique<platform::DisplayHost>();
    return start_board_host(settings_, of_host, *host).error;
}

/// One pixel is read, for which the driver must have drawn all of them.
bool BoardBench::draw(platform::DisplayHost& host) {
    std::uint8_t pixel[4] = {};
    host.display().draw(host.surface());
    return host.surface().present() == base::SurfaceState::ready && gl::read_pixels(host.display().gl(), 1, 1, pixel);
}

void BoardBench::progress(std::size_t done, std::size_t total) {
    const base::Time time = now();
    if (done == 0) begun_ = last_line_ = time;
    if (done == 0 || done == total || time - last_line_ < kBetweenLines) return;
    last_line_ = time;
    const double left_s = (time - begun_).to_seconds() / static_cast<double>(done) * static_cast<double>(total - done);
    char line[96];
    std::snprintf(line, sizeof line, "costs: %zu of %zu steps are measured, about %.0f s are left", done, total, left_s);
    log_.write({line});
}

}  // namespace tedavis::target
