#include "target/display_application.hpp"

#include <utility>

#include "target/board_display.hpp"

namespace tedavis::target {

DisplayApplication::DisplayApplication(const BoardSettings& settings, BoardPorts ports)
    : settings_(settings),
      ports_(std::move(ports)),
      flight_(settings_, *ports_.can, std::move(ports_.gpio), ports_.clocks.live, ports_.log, ports_.explain_panel),
      phase_events_(ports_.log),
      pacer_(settings_.device.frame_rate_hz, {}),
      screen_events_(ports_.log) {
    settings_.screen.report = &screen_;
}

DisplayApplication::~DisplayApplication() { scene_watch_.stop(); }

base::Error DisplayApplication::start() {
    if (const platform::HostFault fault = start_board_display(settings_, host_, ports_.clocks.live.wall())) return fault.error;
    if (!screen_.connector.empty()) screen_events_.started(screen_);
    if (base::Error error = hold_board_deadline(settings_, host_)) return error;
    if (const base::Error& why = host_.terrain_fault(); !why.message.empty())
        ports_.log.write({why.message.view(), "; the display shows TERRAIN FAIL until it is started again with sound terrain"});
    start_scene();
    start_records();
    warmer_.begin(display().planner());
    flight_.start(ports_.clocks.live.monotonic());
    return {};
}

/// The first scene comes the way all others do: the display shows what it has until then, and without a thread nothing.
void DisplayApplication::start_scene() {
    if (settings_.scene.empty()) return;
    if (!scene_watch_.start(settings_.scene.c_str(), display().planner().data().spare(), 0))
        ports_.log.write({settings_.scene.view(),
                          ": is not shown, for the machine gives no thread for reading it; end other programs and start again"});
    if (!settings_.pack.is_pack()) return;
    // The scene of a pack is the one that was checked, until the next start.
    scene_watch_.await_first_look();
    take_new_scene();
    scene_watch_.stop();
}

void DisplayApplication::take_new_scene() {
    if (settings_.scene.empty()) return;
    if (const auto fault = scene_watch_.take_fault(); !fault.empty()) ports_.log.write({fault.view()});
    const scene::Scene* const loaded = scene_watch_.loaded();
    if (loaded == nullptr) return;
    const std::uint64_t revision = loaded->header().revision;
    if (display().take_scene(*loaded)) {
        ports_.log.write({settings_.scene.view(), ": has revision ", base::digits(revision).view()});
        warmer_.begin(display().planner());  // designs that put data first have waited for it
    }
    scene_watch_.go_on(display().planner().data().spare(), revision);
}

/// A GL driver compiles what it draws for the first time: another design with a phase, terrain with a position.
void DisplayApplication::await_compilation(const flight::FrameInput& input) {
    const bool is_placed = input.state.own_ship.state == base::SignalState::valid;
    if (!(input.phase.presented == presented_phase_) || (is_placed && !was_placed_)) watchdog_.expect_slow_frames();
    presented_phase_ = input.phase.presented;
    was_placed_ = is_placed;
}

base::SurfaceState DisplayApplication::draw_frame(base::Time now) {
    if (!std::exchange(follows_warming_, false)) take_new_scene();
    input_ = flight_.at(now, display().planner());
    await_compilation(input_);
    display().plan(input_);
    display().draw(host_.surface());
    if (is_pictured_) ports_.snapshot->take(display().gl());
    hold_for_screen();
    const base::SurfaceState state = host_.surface().present();
    report_screen();
    delivery_.values = values_of(input_.state);
    delivery_.can_to_screen = record_latency();
    delivery_.is_on_screen = state == base::SurfaceState::ready && screen_.is_plugged && screen_.is_master &&
                             (screen_.connector.empty() || screen_.shown_at);
    if (!has_first_picture_ && state == base::SurfaceState::ready && screen_.is_plugged && screen_.is_master)
        record_first_picture(input_);
    if (state == base::SurfaceState::ready) phase_events_.report(input_.phase, ++drawn_, ports_.clocks.live.monotonic());
    return state;
}

/// What the driver has put off is work of this frame: it is done before the waiting, not after it.
void DisplayApplication::hold_for_screen() {
    held_ = {};
    if (pacer_.earliest_flip() <= ports_.clocks.live.monotonic()) return;
    if (display().gl().has(gl::CallId::Finish)) display().gl()->Finish();
    const base::Time begun = ports_.clocks.live.monotonic();
    if (pacer_.earliest_flip() <= begun) return;
    ports_.clocks.sleep_until(pacer_.earliest_flip());
    held_ = ports_.clocks.live.monotonic() - begun;
}

base::Time DisplayApplication::next_frame(base::Duration work) {
    constexpr std::int64_t kOfMillihertz = 1'000'000'000'000;  // ns
    const bool is_paced = screen_.paced_by == platform::FlipPacing::vblank && screen_.shown_at && screen_.refresh_mhz > 0;
    if (!is_paced) return pacer_.next(ports_.clocks.live.monotonic());
    return pacer_.next_after({*screen_.shown_at, {kOfMillihertz / screen_.refresh_mhz}}, work);
}

/// A picture is correct once it shows where the aircraft is, over terrain that has all arrived.
void DisplayApplication::record_first_picture(const flight::FrameInput& input) {
    if (ports_.process_age == nullptr || input.state.own_ship.state != base::SignalState::valid) return;
    if (display().record().terrain.pending > 0) return;
    has_first_picture_ = true;
    first_picture_ = ports_.process_age();
}

/// Behind a correct picture, with frames of the flight between them: a design may take as long as many frames.
void DisplayApplication::warm_next_design() {
    constexpr std::uint64_t kFramesBetween = 8;
    delivery_.is_warm = warmer_.is_done();
    if (delivery_.is_warm || !has_first_picture_ || drawn_ % kFramesBetween != 0) return;
    if (display().memory().must_be_drawn()) return;
    watchdog_.expect_slow_frames();
    follows_warming_ = warmer_.draw_next(display(), host_.surface(), input_);
    if (warmer_.is_done() && !is_warm_) record_warm();
}

void DisplayApplication::record_warm() {
    is_warm_ = true;
    if (ports_.process_age == nullptr) return;
    warm_ = ports_.process_age();
    ports_.log.write({"all designs have been drawn once; from now on no change of phase waits for the graphics driver"});
}

/// Off screen, a picture is shown when it has been completed.
std::optional<base::Duration> DisplayApplication::record_latency() {
    const bool is_screen = !screen_.connector.empty();
    if (!is_screen) return flight_.latency().shown(ports_.clocks.live.monotonic());
    if (screen_.is_plugged && screen_.is_master && screen_.shown_at) return flight_.latency().shown(*screen_.shown_at);
    if (!(screen_.is_plugged && screen_.is_master)) flight_.latency().hidden();
    return std::nullopt;
}

void DisplayApplication::start_records() {
    if (settings_.records.empty()) return;
    if (const base::Error error = records_.start(settings_.records))
        ports_.log.write({error.message.view(), "; this run hands out no records"});
}

void DisplayApplication::hand_out_record() {
    if (!records_.has_readers()) return;
    write_record(display().record(), delivery_, record_line_);
    if (!record_line_.cut()) records_.send(record_line_.line());
}

bool DisplayApplication::wants_picture(bool is_last) {
    if (ports_.snapshot == nullptr || !ports_.snapshot->is_started()) return false;
    return ports_.snapshot->take_request() || is_last;
}

void DisplayApplication::report_screen() {
    if (!screen_.connector.empty()) screen_events_.report(screen_);
}

RunReport DisplayApplication::run(std::uint64_t frames, const StopSignal& stop) {
    RunReport report;
    const BoardClocks& clocks = ports_.clocks;
    pacer_ = FramePacer(settings_.device.frame_rate_hz, clocks.live.monotonic());
    delivery_.run_begun = clocks.live.monotonic();
    while (!stop.requested() && (frames == 0 || report.frames < frames)) {
        warm_next_design();
        const base::Time begun = clocks.live.monotonic();
        is_pictured_ = wants_picture(report.frames + 1 == frames);
        if (draw_frame(begun) != base::SurfaceState::ready) {
            ports_.log.write({"the drawing surface was lost; start the program again"});
            report.end = RunEnd::surface_lost;
            break;
        }
        const base::Duration took = clocks.live.monotonic() - begun - screen_.waited - held_;
        if (!is_pictured_) display().memory().budget.record_measured(took.to_seconds() * 1000);
        delivery_.took = took;
        hand_out_record();
        if (++report.frames == 1) watchdog_.ready();
        watchdog_.alive(took);
        clocks.sleep_until(next_frame(took));
    }
    watchdog_.stopping();
    report.missed = pacer_.missed();
    report.gl_calls_outside_device = display().gl().denied().total;
    report.screen = screen_;
    report.has_first_picture = has_first_picture_;
    report.first_picture = first_picture_;
    report.is_warm = is_warm_;
    report.warm = warm_;
    report.bus = flight_.counters(clocks.live.monotonic());
    report.latency = flight_.latency().report();
    return report;
}

}  // namespace tedavis::target
