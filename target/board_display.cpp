#include "target/board_display.hpp"

#include <utility>

#include "platform/programs/program_folder.hpp"
#include "platform/surface_factory.hpp"
#include "platform/threads/thread_reader.hpp"
#include "platform/threads/thread_workers.hpp"
#include "render_core/display/calibration_subject.hpp"
#include "render_core/effects/calibration.hpp"
#include "render_core/gl/program.hpp"
#include "target/file_text.hpp"

namespace tedavis::target {

BoardDisplay::BoardDisplay(const BoardSettings& settings) : settings_(settings) {}

BoardDisplay::~BoardDisplay() {
    if (is_started_) display_->stop();
    if (surface_) surface_->release_current();
}

base::Error BoardDisplay::open_surface() {
    const auto lane =
        settings_.device.capability.lane == effects::Lane::es2 ? platform::ContextLane::es2 : platform::ContextLane::es3;
    auto surface = platform::make_surface(settings_.surface.view(), {settings_.width_px, settings_.height_px, lane});
    if (!surface.ok()) return base::make_error("[surface]: ", surface.error().message.view());
    surface_ = std::move(surface.value());
    if (!surface_->make_current())
        return base::make_error("[surface]: the surface cannot be made current; is another one in use?");
    return {};
}

base::Error BoardDisplay::open_terrain() {
    auto file = platform::open_file(settings_.terrain.c_str());
    if (!file.ok()) return base::make_error(file.error().message.view());
    terrain_file_ = std::move(file.value());
    const std::uint32_t tickets = display::TerrainPlanner::reader_tickets(settings_.device);
    auto reader = platform::make_thread_reader(terrain_file_, {tickets, tickets, nullptr});
    if (!reader.ok()) return base::make_error(reader.error().message.view());
    terrain_reader_ = std::move(reader.value());
    return {};
}

void BoardDisplay::give_up_terrain(const base::Error& why) {
    terrain_fault_ = why;
    terrain_reader_.reset();
    terrain_file_ = {};
}

base::Error BoardDisplay::start_workers(const display::DisplaySettings& settings) {
    if (!terrain_reader_ || !settings.asks_for_rays()) return {};
    auto workers = platform::make_thread_workers({platform::usable_processors(), nullptr});
    if (!workers.ok()) return base::make_error(workers.error().message.view());
    workers_ = std::move(workers.value());
    return {};
}

base::Error BoardDisplay::start() {
    if (!settings_.terrain.empty())
        if (const base::Error error = open_terrain()) give_up_terrain(error);
    auto reserved = platform::reserve_memory(display::DisplayMemory::bytes_needed(settings_.device.budget), settings_.residency);
    if (!reserved.ok()) return base::make_error(reserved.error().message.view());
    reservation_ = std::move(reserved.value());
    display::DisplaySettings settings;
    settings.device = settings_.device;
    settings.design = settings_.design;
    settings.phases = &settings_.phases;
    settings.width_px = settings_.width_px;
    settings.height_px = settings_.height_px;
    settings.expects_scene = !settings_.scene.empty();
    platform::ProgramFolder programs;
    if (!settings_.programs.empty() && !gl::has_compiler(settings_.device.capability)) {
        auto opened = platform::open_program_folder(settings_.programs.view());
        if (!opened.ok()) return base::make_error(opened.error().message.view());
        programs = std::move(opened.value());
        settings.programs = &programs;
    }
    if (base::Error error = start_workers(settings)) return error;
    base::Error error = start_core(settings);
    if (const std::string_view fault = display::database_fault(error.message.view()); !fault.empty()) {
        display_->stop();  // and once more, on the same surface and in the same memory
        give_up_terrain(base::make_error(settings_.terrain.view(), ": ", fault));
        error = start_core(settings);
    }
    is_started_ = error.message.empty();
    if (is_started_) return {};
    return base::make_error("device '", settings_.device.name.view(), "': ", error.message.view());
}

base::Error BoardDisplay::start_core(display::DisplaySettings& settings) {
    settings.terrain_failed_at_start = !terrain_fault_.message.empty();
    display::TerrainInput terrain;
    if (terrain_reader_) terrain = {&terrain_file_, terrain_reader_.get(), terrain::ArrivalMode::live, workers_.get()};
    display_ = std::make_unique<display::Display>();
    return display_->start(settings, reservation_.arena(), *surface_, terrain);
}

base::Error BoardDisplay::hold_deadline() {
    effects::CostTable costs;
    if (!settings_.costs.empty()) {
        const auto text = read_file_text(settings_.costs.c_str());
        if (!text.ok()) return text.error();
        const auto read =
            effects::read_calibration(text.value().view(), settings_.costs.view(), display::calibration_subject(*display_));
        if (!read.ok()) return base::make_error(read.error().message.view());
        costs = read.value().costs;
    }
    display_->memory().budget.hold(settings_.device.deadline_ms, costs);
    return {};
}

}  // namespace tedavis::target
