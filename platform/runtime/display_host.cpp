#include "platform/runtime/display_host.hpp"

#include <utility>

#include "platform/surface_factory.hpp"
#include "platform/threads/thread_reader.hpp"
#include "platform/threads/thread_workers.hpp"
#include "render_core/display/calibration_subject.hpp"
#include "render_core/effects/calibration.hpp"
#include "render_core/gl/program.hpp"

namespace tedavis::platform {
namespace {

HostFault fault_of(HostPart part, const base::Error& error) { return {error ? part : HostPart::none, error}; }

/// A fault of a database's bytes; one that came without a path keeps the display's sentence.
HostFault database_fault(HostPart part, const DatabaseSource& source, std::string_view fault, const base::Error& message) {
    return {part, source.bytes != nullptr ? message : base::make_error(source.path, ": ", fault)};
}

base::Error open_database(const DatabaseSource& source, FileByteSource& file, base::ByteSource*& bytes) {
    bytes = source.bytes;
    if (bytes != nullptr || !source.exists()) return {};
    auto opened = open_file(source.path);
    if (!opened.ok()) return opened.error();
    file = std::move(opened.value());
    bytes = &file;
    return {};
}

}  // namespace

DisplayHost::~DisplayHost() {
    if (display_ && make_current()) display_->stop();
    display_.reset();
    if (surface_) surface_->release_current();
}

bool DisplayHost::make_current() {
    if (!surface_->make_current()) return false;
    display_->gl().activate();
    return true;
}

HostFault DisplayHost::start(const DisplayHostSettings& settings) {
    if (const HostFault fault = open_databases(settings)) return fault;
    if (const HostFault fault = open_surface(settings)) return fault;
    if (const HostFault fault = reserve(settings)) return fault;
    if (const HostFault fault = start_workers(settings)) return fault;
    ProgramFolder folder;
    base::ProgramStore* programs = settings.display.programs;
    if (const HostFault fault = open_programs(settings, folder, programs)) return fault;
    return start_display(settings, programs);
}

HostFault DisplayHost::open_databases(const DisplayHostSettings& settings) {
    if (const base::Error error = open_terrain(settings)) {
        if (settings.terrain_fault == TerrainFaultPolicy::refuse) return {HostPart::terrain, error};
        give_up_terrain(error);
    }
    return fault_of(HostPart::scene, open_database(settings.scene, scene_file_, scene_));
}

/// Who holds the bytes has them at once: they are read without a thread.
base::Error DisplayHost::open_terrain(const DisplayHostSettings& settings) {
    if (base::Error error = open_database(settings.terrain, terrain_file_, terrain_)) return error;
    if (terrain_ == nullptr) return {};
    if (settings.terrain.bytes != nullptr) {
        terrain_reader_ = std::make_unique<base::SynchronousReader>(*terrain_, base::kMaxReadTickets);
        return {};
    }
    const std::uint32_t tickets = display::TerrainPlanner::reader_tickets(settings.display.device);
    auto reader = make_thread_reader(*terrain_, {tickets, tickets, nullptr});
    if (!reader.ok()) return reader.error();
    terrain_reader_ = std::move(reader.value());
    return {};
}

void DisplayHost::give_up_terrain(const base::Error& why) {
    terrain_fault_ = why;
    terrain_reader_.reset();
    terrain_ = nullptr;
    terrain_file_ = {};
}

HostFault DisplayHost::open_surface(const DisplayHostSettings& settings) {
    const bool is_es2 = settings.display.device.capability.lane == effects::Lane::es2;
    const SurfaceSettings size = {settings.display.width_px, settings.display.height_px,
                                  is_es2 ? ContextLane::es2 : ContextLane::es3};
    const SurfaceSource& source = settings.surface;
    auto surface = source.make != nullptr ? source.make(source.self, size) : make_surface(source.backend, size);
    if (!surface.ok()) return {HostPart::surface, surface.error()};
    surface_ = std::move(surface.value());
    if (surface_->make_current()) return {};
    return {HostPart::context, base::make_error("the surface cannot be made current; is another one in use?")};
}

HostFault DisplayHost::reserve(const DisplayHostSettings& settings) {
    memory_ = settings.memory;
    if (memory_.use().capacity > 0) return {};
    auto reserved = reserve_memory(display::DisplayMemory::bytes_needed(settings.display.device.budget), settings.residency);
    if (!reserved.ok()) return {HostPart::memory, reserved.error()};
    reservation_ = std::move(reserved.value());
    memory_ = reservation_.arena();
    return {};
}

HostFault DisplayHost::start_workers(const DisplayHostSettings& settings) {
    workers_ = settings.workers;
    if (workers_ != nullptr || terrain_ == nullptr || !settings.display.asks_for_rays()) return {};
    auto workers = make_thread_workers({usable_processors(), nullptr});
    if (!workers.ok()) return {HostPart::workers, workers.error()};
    own_workers_ = std::move(workers.value());
    workers_ = own_workers_.get();
    return {};
}

HostFault DisplayHost::open_programs(const DisplayHostSettings& settings, ProgramFolder& folder, base::ProgramStore*& programs) {
    if (settings.programs.empty() || gl::has_compiler(settings.display.device.capability)) return {};
    auto opened = open_program_folder(settings.programs);
    if (!opened.ok()) return {HostPart::programs, opened.error()};
    folder = std::move(opened.value());
    programs = &folder;
    return {};
}

HostFault DisplayHost::start_display(const DisplayHostSettings& settings, base::ProgramStore* programs) {
    base::Error error = start_core(settings, programs);
    std::string_view fault = display::database_fault(error.message.view());
    if (!fault.empty() && settings.terrain_fault == TerrainFaultPolicy::run_without) {
        display_->stop();  // and once more, on the same surface and in the same memory
        give_up_terrain(database_fault(HostPart::terrain, settings.terrain, fault, error).error);
        error = start_core(settings, programs);
        fault = {};
    }
    if (!error) return {};
    display_.reset();  // what has not started is not stopped
    if (!fault.empty()) return database_fault(HostPart::terrain, settings.terrain, fault, error);
    if (const std::string_view of_scene = display::scene_fault(error.message.view()); !of_scene.empty())
        return database_fault(HostPart::scene, settings.scene, of_scene, error);
    return {HostPart::display, error};
}

base::Error DisplayHost::start_core(const DisplayHostSettings& settings, base::ProgramStore* programs) {
    display::DisplaySettings of_display = settings.display;
    of_display.programs = programs;
    of_display.terrain_failed_at_start = !terrain_fault_.message.empty();
    display::TerrainInput terrain;
    if (terrain_ != nullptr) terrain = {terrain_, terrain_reader_.get(), settings.arrival, workers_};
    display_ = std::make_unique<display::Display>();
    return display_->start(of_display, memory_, *surface_, terrain, scene_);
}

base::Error DisplayHost::hold_deadline(double deadline_ms, const CostsFile& costs) {
    effects::Calibration known;
    if (!costs.name.empty()) {
        const auto read = effects::read_calibration(costs.text, costs.name, display::calibration_subject(*display_));
        if (!read.ok()) return read.error();
        known = read.value();
    }
    display_->memory().budget.hold(deadline_ms, known.costs, known.quality);
    return {};
}

}  // namespace tedavis::platform
