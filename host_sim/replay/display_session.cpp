#include "host_sim/replay/display_session.hpp"

#include <string_view>

#include "host_sim/input_file.hpp"
#include "host_sim/replay/load_design.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"
#include "platform/surface_factory.hpp"
#include "platform/threads/thread_reader.hpp"
#include "platform/threads/thread_workers.hpp"
#include "render_core/base/hash.hpp"
#include "render_core/display/calibration_subject.hpp"
#include "render_core/effects/calibration.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/readback.hpp"

namespace tedavis::host_sim {
namespace {

effects::DeviceSettings load_device(const std::string& name) {
    const std::string path = resolve_config(name, "devices");
    auto device = effects::read_device_settings(read_file(path), path);
    if (!device.ok()) throw UserError(std::string(device.error().message.view()));
    return device.value();
}

/// The display starts with one sentence for all; memory, programs and their limits come from the device file.
std::string with_file(const std::string& sentence, const std::string& device, const PictureOptions& options) {
    if (const std::string_view fault = display::database_fault(sentence); !fault.empty())
        return options.terrain + ": " + std::string(fault);
    if (const std::string_view fault = display::scene_fault(sentence); !fault.empty())
        return options.scene + ": " + std::string(fault);
    return device + ": " + sentence;
}

SurfaceMaker headless_surface(GlChoice gl) {
    return [gl](const platform::SurfaceSettings& settings) {
        return platform::make_surface(gl == GlChoice::egl ? "egl" : "osmesa", settings);
    };
}

}  // namespace

DisplaySession::DisplaySession(const PictureOptions& options, bool generated_flight)
    : DisplaySession(options, generated_flight, headless_surface(options.gl)) {}

DisplaySession::DisplaySession(const PictureOptions& options, bool generated_flight, const SurfaceMaker& make_surface)
    : device_(load_device(options.device)) {
    MadePrograms programs;
    const bool has_compiler = gl::has_compiler(device_.capability);
    if (!has_compiler) programs = make_programs(options);
    open(options, generated_flight, make_surface, has_compiler ? nullptr : &programs);
}

bool DisplaySession::has_compiler(const PictureOptions& options) {
    return gl::has_compiler(load_device(options.device).capability);
}

MadePrograms DisplaySession::make_programs(const PictureOptions& options) {
    effects::DeviceSettings device = load_device(options.device);
    device.capability = gl::with_compiler(device.capability);
    MadePrograms programs;
    DisplaySession maker(device);
    maker.open(options, false, headless_surface(options.gl), &programs);
    return programs;
}

void DisplaySession::open(const PictureOptions& options, bool generated_flight, const SurfaceMaker& make_surface,
                          MadePrograms* programs) {
    device_.forbidden.add(options.forbidden);
    display::DisplaySettings settings;
    settings.device = device_;
    const std::unique_ptr<LoadedDesigns> designs = load_designs(options);
    settings.design = designs->design;
    settings.phases = &designs->phases;
    settings.width_px = options.size ? options.size->width : device_.width_px;
    settings.height_px = options.size ? options.size->height : device_.height_px;
    settings.generated_flight = generated_flight;
    settings.programs = programs;
    open_terrain(options.terrain);
    open_scene(options.scene);
    const auto lane = device_.capability.lane == effects::Lane::es2 ? platform::ContextLane::es2 : platform::ContextLane::es3;
    open_surface({settings.width_px, settings.height_px, lane}, make_surface);
    start_display(settings, options);
    pixels_.resize(std::size_t{settings.width_px} * settings.height_px * 4);
}

void DisplaySession::open_terrain(const std::string& path) {
    terrain_name_ = path;
    if (path.empty()) return;
    auto file = platform::open_file(path.c_str());
    if (!file.ok()) throw UserError(std::string(file.error().message.view()));
    terrain_file_ = std::move(file.value());
    const std::uint32_t tickets = display::TerrainPlanner::reader_tickets(device_);
    auto reader = platform::make_thread_reader(terrain_file_, {tickets, tickets, nullptr});
    if (!reader.ok()) throw UserError(std::string(reader.error().message.view()));
    terrain_reader_ = std::move(reader.value());
}

void DisplaySession::open_scene(const std::string& path) {
    if (path.empty()) return;
    auto file = platform::open_file(path.c_str());
    if (!file.ok()) throw UserError(std::string(file.error().message.view()));
    scene_file_ = std::move(file.value());
}

void DisplaySession::open_surface(const platform::SurfaceSettings& settings, const SurfaceMaker& make_surface) {
    auto surface = make_surface(settings);
    if (!surface.ok()) throw UserError(std::string(surface.error().message.view()));
    surface_ = std::move(surface.value());
    if (!surface_->make_current())
        throw UserError("the drawing surface cannot be made current; try another --gl, or another screen for --window");
}

base::Workers* DisplaySession::trace_workers(const display::DisplaySettings& settings) {
    if (!settings.asks_for_rays()) return nullptr;
    auto workers = platform::make_thread_workers({platform::usable_processors(), nullptr});
    if (!workers.ok()) throw UserError(std::string(workers.error().message.view()));
    workers_ = std::move(workers.value());
    return workers_.get();
}

void DisplaySession::start_display(const display::DisplaySettings& settings, const PictureOptions& options) {
    const std::string device = resolve_config(options.device, "devices");
    auto reservation = platform::reserve_memory(display::DisplayMemory::bytes_needed(device_.budget), platform::Residency::lazy);
    if (!reservation.ok()) throw UserError(device + ": " + std::string(reservation.error().message.view()));
    reservation_ = std::move(reservation.value());
    display_ = std::make_unique<display::Display>();
    display::TerrainInput terrain;
    if (!options.terrain.empty())
        terrain = {&terrain_file_, terrain_reader_.get(), terrain::ArrivalMode::exact, trace_workers(settings)};
    const base::Error error =
        display_->start(settings, reservation_.arena(), *surface_, terrain, options.scene.empty() ? nullptr : &scene_file_);
    display_->planner().force_effects(options.force_effects);
    if (!error) return hold_deadline(options);
    display_.reset();  // what has not started is not stopped
    throw UserError(with_file(std::string(error.message.view()), device, options));
}

void DisplaySession::hold_deadline(const PictureOptions& options) {
    effects::Calibration calibration;
    if (!options.costs.empty()) {
        const auto read =
            effects::read_calibration(read_file(options.costs), options.costs, display::calibration_subject(*display_));
        if (!read.ok()) throw UserError(std::string(read.error().message.view()));
        calibration = read.value();
    }
    display_->memory().budget.hold(options.deadline_ms.value_or(0), calibration.costs);
}

DisplaySession::~DisplaySession() {
    if (display_ && surface_->make_current()) {
        display_->gl().activate();
        display_->stop();
    }
    display_.reset();
    if (surface_) surface_->release_current();
}

std::string DisplaySession::gl_description() {
    return std::string(surface_->backend_name()) + ": " + std::string(display_->gl().driver_text().view());
}

void DisplaySession::make_current() {
    if (!surface_->make_current()) throw UserError("the drawing surface was lost; start the command again");
    display_->gl().activate();
}

void DisplaySession::draw() {
    display_->draw(*surface_);
    for (const display::Name& flag : display_->record().flags)
        terrain_faulty_ = terrain_faulty_ || flag.view() == "terrain.failing" || flag.view() == "terrain.failed";
    read_back();
}

void DisplaySession::draw_up_to(display::PictureLayer last) {
    display_->draw_up_to(*surface_, last);
    read_back();
}

void DisplaySession::read_back() {
    if (!gl::read_pixels(display_->gl(), width(), height(), {pixels_.data(), pixels_.size()}))
        throw UserError("--gl: the picture cannot be read back; try the other --gl");
}

void DisplaySession::present() {
    if (surface_->present() != base::SurfaceState::ready) throw UserError("the drawing surface was lost; start the replay again");
}

std::string DisplaySession::terrain_fault() const {
    if (!terrain_faulty_) return {};
    return terrain_name_ +
           ": a part of it cannot be used, so the terrain there is coarser or taken off the display; 'tedavis check " +
           terrain_name_ + "' finds the place, 'tedavis terrain build' makes it anew";
}

std::uint64_t DisplaySession::frame_hash() const {
    return base::frame_hash(pixels_.data(), surface_->width(), surface_->height(), true);
}

}  // namespace tedavis::host_sim
