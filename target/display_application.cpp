#include "target/display_application.hpp"

#include <utility>

#include "platform/programs/program_folder.hpp"
#include "platform/surface_factory.hpp"
#include "platform/threads/thread_reader.hpp"
#include "platform/threads/thread_workers.hpp"
#include "render_core/gl/program.hpp"
#include "target/file_text.hpp"
#include "target/frame_pacer.hpp"

namespace tedavis::target {

DisplayApplication::DisplayApplication(const BoardSettings& settings, BoardPorts ports)
    : settings_(settings),
      ports_(std::move(ports)),
      flight_(settings_, *ports_.can, std::move(ports_.gpio), ports_.clocks.live, ports_.log) {}

DisplayApplication::~DisplayApplication() {
    scene_watch_.stop();
    if (started_) display_.stop();
    if (surface_) surface_->release_current();
}

BoardError DisplayApplication::start() {
    if (BoardError error = open_surface(); !error.sentence.empty()) return error;
    if (BoardError error = start_display(); !error.sentence.empty()) return error;
    if (BoardError error = hold_deadline(); !error.sentence.empty()) return error;
    if (BoardError error = start_scene(); !error.sentence.empty()) return error;
    flight_.start(ports_.clocks.live.monotonic());
    started_ = true;
    return {};
}

BoardError DisplayApplication::open_surface() {
    const auto lane =
        settings_.device.capability.lane == effects::Lane::es2 ? platform::ContextLane::es2 : platform::ContextLane::es3;
    auto surface = platform::make_surface(settings_.surface.view(), {settings_.width_px, settings_.height_px, lane});
    if (!surface.ok()) return make_board_error({"[surface]: ", surface.error().sentence.view()});
    surface_ = std::move(surface.value());
    if (!surface_->make_current())
        return make_board_error({"[surface]: the surface cannot be made current; is another one in use?"});
    return {};
}

BoardError DisplayApplication::open_terrain() {
    if (settings_.terrain.empty()) return {};
    auto file = platform::open_file(settings_.terrain.c_str());
    if (!file.ok()) return make_board_error({file.error().sentence.view()});
    terrain_file_ = std::move(file.value());
    const std::uint32_t tickets = display::TerrainScene::reader_tickets(settings_.device);
    auto reader = platform::make_thread_reader(terrain_file_, {tickets, tickets, nullptr});
    if (!reader.ok()) return make_board_error({reader.error().sentence.view()});
    terrain_reader_ = std::move(reader.value());
    return {};
}

BoardError DisplayApplication::start_workers(const display::DisplaySettings& settings) {
    if (!terrain_reader_ || !display::Display::asks_for_rays(settings)) return {};
    auto workers = platform::make_thread_workers({platform::usable_processors(), nullptr});
    if (!workers.ok()) return make_board_error({workers.error().sentence.view()});
    workers_ = std::move(workers.value());
    return {};
}

BoardError DisplayApplication::start_display() {
    if (BoardError error = open_terrain(); !error.sentence.empty()) return error;
    auto reserved = platform::reserve_memory(display::Display::bytes_needed(settings_.device), settings_.residency);
    if (!reserved.ok()) return make_board_error({reserved.error().sentence.view()});
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
        if (!opened.ok()) return make_board_error({opened.error().sentence.view()});
        programs = std::move(opened.value());
        settings.programs = &programs;
    }
    if (BoardError error = start_workers(settings); !error.sentence.empty()) return error;
    display::TerrainInput terrain;
    if (terrain_reader_) terrain = {&terrain_file_, terrain_reader_.get(), terrain::ArrivalMode::live, workers_.get()};
    const gl::GlError error = display_.start(settings, reservation_.arena(), *surface_, terrain);
    if (error.sentence.empty()) return {};
    if (const std::string_view fault = display::database_fault(error.sentence.view()); !fault.empty())
        return make_board_error({settings_.terrain.view(), ": ", fault});
    return make_board_error({"device '", settings_.device.name.view(), "': ", error.sentence.view()});
}

BoardError DisplayApplication::hold_deadline() {
    effects::CostTable costs;
    if (!settings_.costs.empty()) {
        const auto text = read_file_text(settings_.costs.c_str());
        if (!text.ok()) return text.error();
        const auto read = effects::read_calibration(text.value().view(), settings_.costs.view(), display_.calibration_subject());
        if (!read.ok()) return make_board_error({read.error().sentence.view()});
        costs = read.value().costs;
    }
    display_.frame_budget().hold(settings_.device.deadline_ms, costs);
    return {};
}

/// The first scene comes the way all others do: the display shows what it has until then.
BoardError DisplayApplication::start_scene() {
    if (settings_.scene.empty()) return {};
    if (scene_watch_.start(settings_.scene.c_str(), display_.spare_scene_memory(), 0)) return {};
    return make_board_error({"the machine gives no thread for reading the scene; end other programs"});
}

void DisplayApplication::take_new_scene() {
    if (settings_.scene.empty()) return;
    if (const auto fault = scene_watch_.take_fault(); !fault.empty()) ports_.log.write({fault.view()});
    const scene::Scene* const loaded = scene_watch_.loaded();
    if (loaded == nullptr) return;
    const std::uint64_t revision = loaded->header().revision;
    if (display_.take_scene(*loaded))
        ports_.log.write({settings_.scene.view(), ": shows revision ", gl::digits(revision).view()});
    scene_watch_.go_on(display_.spare_scene_memory(), revision);
}

base::SurfaceState DisplayApplication::draw_frame(base::Time now) {
    take_new_scene();
    const LiveFlight::Instant instant = flight_.at(now, display_);
    display_.update(instant.aircraft, instant.phase, now, &flight_.way());
    display_.draw(*surface_);
    return surface_->present();
}

RunReport DisplayApplication::run(std::uint64_t frames, const StopSignal& stop) {
    RunReport report;
    const BoardClocks& clocks = ports_.clocks;
    FramePacer pacer(settings_.device.frame_rate_hz, clocks.live.monotonic());
    watchdog_.ready();
    while (!stop.requested() && (frames == 0 || report.frames < frames)) {
        const base::Time begun = clocks.live.monotonic();
        if (draw_frame(begun) != base::SurfaceState::ready) {
            ports_.log.write({"the drawing surface was lost; start the program again"});
            report.end = RunEnd::surface_lost;
            break;
        }
        display_.frame_budget().note_measured((clocks.live.monotonic() - begun).to_seconds() * 1000);
        ++report.frames;
        watchdog_.alive();
        clocks.sleep_until(pacer.next(clocks.live.monotonic()));
    }
    watchdog_.stopping();
    report.missed = pacer.missed();
    report.gl_calls_outside_device = display_.gl().denied().total;
    report.bus = flight_.counters(clocks.live.monotonic());
    return report;
}

}  // namespace tedavis::target
