#include "host_sim/replay/display_session.hpp"

#include <string_view>

#include "host_sim/input_file.hpp"
#include "host_sim/replay/load_design.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/hash.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/readback.hpp"

namespace tedavis::host_sim {
namespace {

/// `maker` must stay until the display is started.
platform::SurfaceSource surface_of(const SurfaceMaker& maker) {
    const auto make = [](const void* self, const platform::SurfaceSettings& settings) {
        return (*static_cast<const SurfaceMaker*>(self))(settings);
    };
    return {"", make, &maker};
}

platform::SurfaceSource headless_surface(GlChoice gl) { return {gl == GlChoice::egl ? "egl" : "osmesa"}; }

}  // namespace

effects::DeviceSettings load_device(const PictureOptions& options) {
    const std::string path = resolve_config(options.device, "devices");
    auto device = effects::read_device_settings(read_file(path), path);
    if (!device.ok()) throw UserError(std::string(device.error().message.view()));
    device.value().forbidden.add(options.forbidden);
    return device.value();
}

design::AircraftSettings load_aircraft(const std::string& name) {
    if (name.empty()) return {};
    const std::string path = resolve_config(name, "aircraft");
    const auto aircraft = design::load_aircraft(read_file(path), path);
    if (!aircraft.ok()) throw UserError(std::string(aircraft.error().message.view()));
    return aircraft.value();
}

design::SymbologyPalettes load_symbology_palettes(const PictureOptions& options) {
    if (options.palette.empty()) return design::standard_symbology_palettes();
    const std::string path = resolve_config(options.palette, "palettes/symbology");
    const auto palettes = design::load_symbology_palettes(read_file(path), path);
    if (!palettes.ok()) throw UserError(std::string(palettes.error().message.view()));
    return palettes.value();
}

platform::DisplayHostSettings host_settings(const PictureOptions& options, const effects::DeviceSettings& device) {
    platform::DisplayHostSettings settings;
    settings.display.device = device;
    settings.display.width_px = options.size ? options.size->width : device.width_px;
    settings.display.height_px = options.size ? options.size->height : device.height_px;
    settings.display.symbology = load_symbology_palettes(options);
    settings.display.light = options.light;
    settings.display.legend = options.legend;
    settings.display.database_dates.period = options.valid_period;
    settings.surface = headless_surface(options.gl);
    settings.terrain.path = options.terrain.c_str();
    settings.scene.path = options.drawn_scene().c_str();
    return settings;
}

/// Memory, programs and their limits come from the device file.
std::string host_fault_text(const platform::HostFault& fault, const PictureOptions& options) {
    using platform::HostPart;
    std::string message(fault.error.message.view());
    if (fault.part == HostPart::context)
        return "the drawing surface cannot be made current; try another --gl, or another screen for --window";
    if (fault.part == HostPart::memory || fault.part == HostPart::display)
        return resolve_config(options.device, "devices") + ": " + message;
    return message;
}

DisplaySession::DisplaySession(const PictureOptions& options, bool generated_flight)
    : DisplaySession(options, generated_flight, headless_surface(options.gl)) {}

DisplaySession::DisplaySession(const PictureOptions& options, bool generated_flight, const SurfaceMaker& make_surface)
    : DisplaySession(options, generated_flight, surface_of(make_surface)) {}

DisplaySession::DisplaySession(const PictureOptions& options, bool generated_flight, const platform::SurfaceSource& surface)
    : device_(load_device(options)) {
    MadePrograms programs;
    const bool has_compiler = gl::has_compiler(device_.capability);
    if (!has_compiler) programs = make_programs(options);
    open(options, generated_flight, surface, has_compiler ? nullptr : &programs);
}

bool DisplaySession::has_compiler(const PictureOptions& options) { return gl::has_compiler(load_device(options).capability); }

MadePrograms DisplaySession::make_programs(const PictureOptions& options) {
    effects::DeviceSettings device = load_device(options);
    device.capability = gl::with_compiler(device.capability);
    MadePrograms programs;
    DisplaySession maker(device);
    maker.open(options, false, headless_surface(options.gl), &programs);
    return programs;
}

void DisplaySession::open(const PictureOptions& options, bool generated_flight, const platform::SurfaceSource& surface,
                          MadePrograms* programs) {
    terrain_name_ = options.terrain;
    const std::unique_ptr<LoadedDesigns> designs = load_designs(options);
    platform::DisplayHostSettings settings = host_settings(options, device_);
    settings.display.design = designs->design;
    settings.display.phases = &designs->phases;
    settings.display.aircraft = load_aircraft(options.aircraft);
    settings.display.generated_flight = generated_flight;
    settings.display.programs = programs;
    settings.surface = surface;
    start(settings, options);
    pixels_.resize(std::size_t{width()} * height() * 4);
}

void DisplaySession::start(const platform::DisplayHostSettings& settings, const PictureOptions& options) {
    if (const platform::HostFault fault = host_.start(settings)) throw UserError(host_fault_text(fault, options));
    display().planner().force_effects(options.force_effects);
    const std::string costs = options.costs.empty() ? std::string() : read_file(options.costs);
    const base::Error error = host_.hold_deadline(options.deadline_ms.value_or(0), {options.costs, costs});
    if (error) throw UserError(std::string(error.message.view()));
}

std::string DisplaySession::gl_description() {
    return std::string(host_.surface().backend_name()) + ": " + std::string(display().gl().driver_text().view());
}

void DisplaySession::make_current() {
    if (!host_.make_current()) throw UserError("the drawing surface was lost; start the command again");
}

void DisplaySession::draw() {
    display().draw(host_.surface());
    for (const display::Name& flag : display().record().flags)
        terrain_faulty_ = terrain_faulty_ || flag.view() == "terrain.failing" || flag.view() == "terrain.failed";
    read_back();
}

void DisplaySession::draw_up_to(display::PictureLayer last) {
    display().draw_up_to(host_.surface(), last);
    read_back();
}

void DisplaySession::read_back() {
    if (!gl::read_pixels(display().gl(), width(), height(), {pixels_.data(), pixels_.size()}))
        throw UserError("--gl: the picture cannot be read back; try the other --gl");
}

void DisplaySession::present() {
    if (host_.surface().present() != base::SurfaceState::ready)
        throw UserError("the drawing surface was lost; start the replay again");
}

std::string DisplaySession::terrain_fault() const {
    if (!terrain_faulty_) return {};
    return terrain_name_ +
           ": a part of it cannot be used, so the terrain there is coarser or taken off the display; 'tedavis check " +
           terrain_name_ + "' finds the place, 'tedavis terrain build' makes it anew";
}

std::uint64_t DisplaySession::frame_hash() const { return base::frame_hash(pixels_.data(), width(), height(), true); }

}  // namespace tedavis::host_sim
