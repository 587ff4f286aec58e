#include "host_sim/window/live_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "host_sim/atomic_file.hpp"
#include "host_sim/geoid_below.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/options/replay_config.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "host_sim/user_error.hpp"
#include "host_sim/window/painted_rects.hpp"
#include "host_sim/window/switch_recording.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

/// An edge comes after the picture that the person saw when pressing the key.
constexpr base::Duration kAfterThePicture{1000};
constexpr base::Duration kDesignLook = base::Duration::milliseconds(250);
constexpr std::size_t kEventsAtOnce = 64;
constexpr base::Duration kSaidFor = base::Duration::seconds(4);
/// Intervals that are decided without a picture in between, and in each turn of the window where there are more.
constexpr std::int64_t kDecidedAtOnce = 240, kDecidedATurn = 120;

/// Few enough colored rectangles for a picture that moves.
constexpr std::uint32_t kErrorCell_px = 16;

bool same_pose(const CameraPose& a, const CameraPose& b) {
    return a.position.latitude_rad == b.position.latitude_rad && a.position.longitude_rad == b.position.longitude_rad &&
           a.position.height.m == b.position.height.m && a.heading_rad == b.heading_rad && a.pitch_rad == b.pitch_rad &&
           a.roll_rad == b.roll_rad;
}

std::optional<CameraTour> load_tour(const std::string& path, display::Display& display) {
    if (path.empty()) return std::nullopt;
    GeoidBelow geoid(display.planner().terrain_database());
    return CameraTour(read_file(path), path, [&geoid](double lat, double lon) { return geoid.at(lat, lon); });
}

Transport transport_over(const FrameInstants& times) { return {times.count(), times.step(), times.backwards()}; }

std::string phase_text(const flight::PhaseStatus& status) {
    const std::string sub = flight::sub_phase_name(status.phase);
    return std::string(flight::scenario_name(status.phase)) + (sub.empty() ? sub : "." + sub) + " (" +
           flight::to_string(status.source) + ")";
}

/// Close enough that nothing in front is cut away, far enough for a depth buffer that tells mountains apart.
double near_plane_m(display::Display& display, const CameraPose& camera, base::Time now) {
    flight::OwnShipEstimate place;
    place.position = camera.position;
    place.state = base::SignalState::valid;
    place.height_is_geometric = true;
    return std::clamp(0.02 * display.planner().height_above_terrain(place, now).value_or(camera.position.height.m), 1.0, 50.0);
}

}  // namespace

LiveRun::LiveRun(const ReplayOptions& options, const std::optional<DisplayFiles>& files, DisplaySession& session,
                 FlightPlayer& player, platform::Window& window, Console& console)
    : options_(options),
      session_(session),
      player_(player),
      window_(window),
      console_(console),
      times_(options, player.first(), player.last(), session.device().frame_rate_hz),
      design_(options.picture),
      tour_(load_tour(options.tour, session.display())),
      controller_(transport_over(times_), static_cast<std::uint32_t>(player.switch_config().patterns.size()), tour_.has_value()),
      preroll_(player, session, session.device().frame_rate_hz),
      recorder_(options_, session, player),
      overlay_({options.accuracy, true, kErrorCell_px, ErrorMapStyle::dots}, options.picture.terrain),
      intervals_(options_, files, session, player, preroll_, console) {
    controller_.set_accuracy(options.accuracy);
    controller_.set_light(options.picture.light);
    controller_.set_legend(options.picture.legend);
}

bool LiveRun::turn(base::Duration wall) {
    take_events();
    controller_.advance(is_prepared() ? wall : base::Duration{});
    if (controller_.take_help()) console_.note(window_keys_help());
    if (controller_.take_screenshot()) take_screenshot();
    said_left_ = said_left_ - wall;
    watch_design(wall);
    turn_accuracy();
    turn_light();
    const Shown next = wanted();
    if (prepare(next)) return true;
    const bool same = shown_ && !is_unprepared_shown_ && shown_->frame == next.frame && shown_->revision == next.revision &&
                      shown_->mode == next.mode && shown_->light == next.light && shown_->legend == next.legend &&
                      same_pose(shown_->camera, next.camera);
    const bool same_overlay = same && shown_->accuracy == next.accuracy && painted_line_ == window_overlay().line &&
                              paints_help_ == controller_.shows_help();
    is_unprepared_shown_ = false;
    if (!same) draw(next);
    if (same && !same_overlay) draw_again();
    shown_ = next;
    show_title();
    return !same_overlay;
}

/// True where this turn showed a picture that is not yet that of the flight.
bool LiveRun::prepare(const Shown& wanted) {
    const base::Time now = shown_time();
    if (decided_revision_ != wanted.revision) {
        preroll_.forget();
        decided_revision_ = wanted.revision;
        prepared_percent_.reset();
    }
    const std::int64_t left = wanted.mode == CameraMode::cockpit ? preroll_.undecided_before(now) : 0;
    if (left <= (prepared_percent_ ? 0 : kDecidedAtOnce)) {
        prepared_percent_.reset();
        return false;
    }
    if (!prepared_percent_) undecided_ = left;
    undecided_ = std::max(undecided_, left);
    prepared_percent_ = static_cast<int>(100 * (undecided_ - left) / undecided_);
    draw_unprepared(now);
    std::int64_t decided = 0;
    preroll_.decide_before(now, [&decided] { return decided++ < kDecidedATurn; });
    return true;
}

/// A picture that no other one follows from: the display's memory is what it was.
void LiveRun::draw_unprepared(base::Time now) {
    session_.display().planner().clear_free_view();
    const display::PlannerMemory memory = session_.display().memory();
    session_.display().memory().cut();
    session_.display().memory().labels.forget();
    session_.display().memory().boost.forget();
    const flight::FrameInput input = player_.at(now);
    session_.display().plan({input.state, input.phase, now, input.trail, input.legend});
    session_.draw();
    session_.display().memory() = memory;
    preroll_.leave();
    is_unprepared_shown_ = true;
    controller_.record_picture(cockpit_pose(), session_.display().planned().picture.camera.view.focal_px);
    present();
    show_title();
}

void LiveRun::take_events() {
    std::array<platform::WindowEvent, kEventsAtOnce> events;
    for (std::size_t count = events.size(); count == events.size();) {
        count = window_.poll_events({events.data(), events.size()});
        for (std::size_t n = 0; n < count; ++n) handle(events[n]);
    }
}

void LiveRun::handle(const platform::WindowEvent& event) {
    controller_.handle(event);
    if (const auto pattern = controller_.take_pattern()) turn_switches(*pattern);
}

void LiveRun::handle(const std::vector<platform::WindowEvent>& events) {
    for (const platform::WindowEvent& event : events) handle(event);
}

/// The frame that is on the screen, as the display drew it.
void LiveRun::take_screenshot() {
    if (!shown_ || is_unprepared_shown_)
        return console_.note("there is no picture of the flight yet; take it once the window is prepared");
    char time[40];
    std::snprintf(time, sizeof time, "%.3f", (session_.display().record().time - player_.first()).to_seconds());
    const std::string begin = options_.output + "/screenshot_" + time + "s";
    std::string path = begin + ".png";
    for (int n = 2; std::filesystem::exists(path); ++n) path = begin + "_" + std::to_string(n) + ".png";
    try {
        write_png(path, session_.pixels());
        said_ = "saved " + path;
    } catch (const UserError& error) {
        said_ = error.what();
    }
    console_.note(said_);
    said_left_ = kSaidFor;
}

void LiveRun::turn_switches(std::uint32_t pattern) {
    const base::Time now = shown_time();
    const bus::SwitchConfig& panel = player_.switch_config();
    std::vector<bus::SwitchEdge> before = player_.switch_edges();
    before.erase(std::find_if(before.begin(), before.end(), [now](const bus::SwitchEdge& edge) { return edge.time > now; }),
                 before.end());
    player_.replace_switches_after(now, edges_to_pattern(panel, before, panel.patterns[pattern].high, now + kAfterThePicture));
    write_switches();
    ++revision_;
    if (!latest_kept_ || *latest_kept_ <= now) return;
    char message[160];
    std::snprintf(message, sizeof message,
                  "frames later than %.3f s in the first %llu lines of frames.jsonl were drawn before the switches were set anew",
                  seconds(now), static_cast<unsigned long long>(recorder_.kept()));
    recorder_.note(message);
    latest_kept_ = now;
}

void LiveRun::watch_design(base::Duration wall) {
    since_look_ = since_look_ + wall;
    if (since_look_ < kDesignLook) return;
    since_look_ = {};
    const DesignNews news = design_.look();
    if (news == DesignNews::broken) console_.note(design_.message() + " (the design before stays)");
    if (news != DesignNews::changed) return;
    if (!session_.display().set_design(design_.designs().design, &design_.designs().phases))
        return console_.note(
            options_.picture.design +
            ": shows the terrain with other techniques than the display was started with; start the window again");
    ++revision_;
    console_.note(options_.picture.design + ": design reloaded");
    recorder_.note("the design was reloaded after " + std::to_string(recorder_.kept()) + " frames");
}

LiveRun::Shown LiveRun::wanted() const {
    Shown wanted;
    wanted.frame = controller_.transport().frame();
    wanted.revision = revision_;
    wanted.mode = controller_.camera_mode();
    wanted.accuracy = controller_.accuracy();
    wanted.light = controller_.light();
    wanted.legend = controller_.asked_legend();
    if (wanted.mode == CameraMode::free) wanted.camera = controller_.camera().pose();
    if (wanted.mode == CameraMode::tour) wanted.camera = tour_->at(seconds(shown_time()));
    return wanted;
}

void LiveRun::aim(const Shown& wanted) {
    display::Display& display = session_.display();
    if (wanted.mode == CameraMode::cockpit) return display.planner().clear_free_view();
    const double near_m = near_plane_m(display, wanted.camera, shown_time());
    display.planner().set_free_view(view_of(wanted.camera, session_.width(), session_.height(),
                                            design_.designs().design.view.horizontal_field_of_view_rad, near_m));
}

void LiveRun::draw(const Shown& wanted) {
    aim(wanted);
    turn_legend(wanted);
    const base::Time now = shown_time();
    if (wanted.mode == CameraMode::cockpit)
        static_cast<void>(preroll_.preroll(now));
    else
        preroll_.leave();  // nobody comes back to these pictures
    static_cast<void>(recorder_.draw(now));
    if (wanted.mode == CameraMode::cockpit) {
        recorder_.keep();
        latest_kept_ = latest_kept_ ? std::max(*latest_kept_, now) : now;
    }
    controller_.record_picture(wanted.mode == CameraMode::cockpit ? cockpit_pose() : wanted.camera,
                               session_.display().planned().picture.camera.view.focal_px);
    present();
}

/// Of the frame that was drawn last.
CameraPose LiveRun::cockpit_pose() const {
    display::Display& display = session_.display();
    const display::FrameRecord& record = display.record();
    return {earth::from_ecef(display.planned().picture.camera.view.eye), record.heading_rad, record.pitch_rad, record.roll_rad};
}

void LiveRun::turn_legend(const Shown& wanted) {
    if (!wanted.legend || (shown_ && shown_->legend == wanted.legend)) return;
    recorder_.ask_legend(*wanted.legend);
    recorder_.note("the legend was set to '" + std::string(name_of(*wanted.legend)) + "' after " +
                   std::to_string(recorder_.kept()) + " frames");
    options_.picture.legend = *wanted.legend;
}

/// The frame that is shown, with another overlay; nothing of it is planned or kept again.
void LiveRun::draw_again() {
    session_.draw_up_to(display::PictureLayer::symbology);
    present();
}

void LiveRun::turn_accuracy() {
    if (controller_.accuracy() == overlay_.shown()) return;
    try {
        overlay_.show(controller_.accuracy());
    } catch (const UserError& error) {
        console_.note(error.what());
        controller_.set_accuracy(overlay_.shown());
    }
}

/// The saved config has the last light.
void LiveRun::turn_light() {
    if (controller_.light() == options_.picture.light) return;
    options_.picture.light = controller_.light();
    session_.display().planner().settings().light = options_.picture.light;
    recorder_.note("the symbology was switched to " +
                   std::string(design::kSymbologyLightNames[static_cast<std::size_t>(options_.picture.light)]) + " after " +
                   std::to_string(recorder_.kept()) + " frames");
}

void LiveRun::present() {
    gl::Gl& gl = session_.display().gl();
    if (overlay_.shown().any() && is_prepared()) {
        FrameResult result = recorder_.result();
        const RgbaPicture picture = overlay_.over(session_, result);
        paint_rects(gl, session_.height(), changed_rects(session_.pixels(), view_of(picture)));
    }
    const WindowOverlay own = window_overlay();
    paint_rects(gl, session_.height(), overlay_rects(own, session_.width(), session_.height()));
    painted_line_ = own.line;
    paints_help_ = controller_.shows_help();
    session_.present();
}

WindowOverlay LiveRun::window_overlay() const {
    WindowOverlay overlay;
    if (controller_.shows_help()) overlay.panel = window_keys_lines();
    if (!is_prepared()) {
        overlay.line = "WINDOW  PREPARING " + std::to_string(*prepared_percent_) +
                       " %: labels and alerts are not yet those of the flight, and nothing is recorded";
    } else if (said_left_ > base::Duration{}) {
        overlay.line = "WINDOW  " + said_;
    } else if (controller_.shows_head_up()) {
        const Transport& transport = controller_.transport();
        display::Display& display = session_.display();
        overlay.line =
            head_up_text({seconds(shown_time()), seconds(player_.last()), display.record().flight_time, transport.speed(),
                          transport.backwards(), transport.playing(), phase_text(display.record().phase),
                          std::string(display.planned().shown->name.view()), camera_text()});
    }
    return overlay;
}

std::string LiveRun::camera_text() const {
    if (controller_.camera_mode() == CameraMode::tour) return "tour";
    if (controller_.camera_mode() == CameraMode::cockpit) return {};
    return "free camera " + std::to_string(std::lround(controller_.camera().speed_mps())) + " m/s";
}

void LiveRun::show_title() {
    const Transport& transport = controller_.transport();
    char text[200];
    std::snprintf(text, sizeof text, "TEDAVIS  %.2f / %.2f s  x%g%s%s  %s", seconds(shown_time()), seconds(player_.last()),
                  transport.speed(), transport.backwards() ? " backwards" : "", transport.playing() ? "" : "  paused",
                  phase_text(session_.display().record().phase).c_str());
    std::string title = text;
    if (const std::string camera = camera_text(); !camera.empty()) title += "  " + camera;
    if (!is_prepared()) title += "  preparing " + std::to_string(*prepared_percent_) + " %";
    if (title == title_) return;
    title_ = title;
    window_.set_title(title_.c_str());
}

std::string LiveRun::switches_path() const { return options_.output + "/" + kWindowSwitchesName; }

void LiveRun::write_switches() const {
    write_file_atomically(switches_path(), switch_log_text(player_.switch_config(), player_.switch_edges()));
}

int LiveRun::finish(bool interrupted) {
    write_switches();
    options_.switches = switches_path();
    if (!options_.save_config.empty()) save_replay_config(options_, options_.save_config);
    return recorder_.finish(interrupted, console_);
}

}  // namespace tedavis::host_sim
