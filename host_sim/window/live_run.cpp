#include "host_sim/window/live_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
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

LiveRun::LiveRun(const ReplayOptions& options, DisplaySession& session, FlightPlayer& player, platform::Window& window,
                 Console& console)
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
      overlay_({options.accuracy, true, kErrorCell_px, ErrorMapStyle::dots}, options.picture.terrain) {
    controller_.set_accuracy(options.accuracy);
    controller_.set_light(options.picture.light);
    controller_.set_legend(options.picture.legend);
}

bool LiveRun::turn(base::Duration wall) {
    take_events();
    controller_.advance(wall);
    if (controller_.take_help()) console_.note(window_keys_help());
    watch_design(wall);
    turn_accuracy();
    turn_light();
    const Shown next = wanted();
    const bool same = shown_ && shown_->frame == next.frame && shown_->revision == next.revision && shown_->mode == next.mode &&
                      shown_->light == next.light && shown_->legend == next.legend && same_pose(shown_->camera, next.camera);
    const bool same_overlay = same && shown_->accuracy == next.accuracy;
    if (!same) draw(next);
    if (same && !same_overlay) draw_again();
    shown_ = next;
    show_title();
    return !same_overlay;
}

void LiveRun::take_events() {
    std::array<platform::WindowEvent, kEventsAtOnce> events;
    for (std::size_t count = events.size(); count == events.size();) {
        count = window_.poll_events({events.data(), events.size()});
        for (std::size_t n = 0; n < count; ++n) {
            controller_.handle(events[n]);
            if (const auto pattern = controller_.take_pattern()) turn_switches(*pattern);
        }
    }
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
    if (shown_ && (shown_->revision != wanted.revision || shown_->mode != wanted.mode)) preroll_.forget();
    const base::Time now = shown_time();
    preroll_.preroll(now);
    const display::FrameRecord& record = recorder_.draw(now).record;
    CameraPose pose = wanted.camera;
    if (wanted.mode == CameraMode::cockpit) {
        recorder_.keep();
        latest_kept_ = latest_kept_ ? std::max(*latest_kept_, now) : now;
        pose = {earth::from_ecef(session_.display().planned().picture.camera.view.eye), record.heading_rad, record.pitch_rad,
                record.roll_rad};
    }
    controller_.record_picture(pose, session_.display().planned().picture.camera.view.focal_px);
    present();
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
    if (overlay_.shown().any()) {
        FrameResult result = recorder_.result();
        const RgbaPicture picture = overlay_.over(session_, result);
        paint_rects(session_.display().gl(), session_.height(), changed_rects(session_.pixels(), view_of(picture)));
    }
    session_.present();
}

void LiveRun::show_title() {
    const Transport& transport = controller_.transport();
    char text[200];
    std::snprintf(text, sizeof text, "TEDAVIS  %.2f / %.2f s  x%g%s%s  %s", seconds(shown_time()), seconds(player_.last()),
                  transport.speed(), transport.backwards() ? " backwards" : "", transport.playing() ? "" : "  paused",
                  phase_text(session_.display().record().phase).c_str());
    std::string title = text;
    if (controller_.camera_mode() == CameraMode::tour) title += "  tour";
    if (controller_.camera_mode() == CameraMode::free)
        title += "  free camera " + std::to_string(std::lround(controller_.camera().speed_mps())) + " m/s";
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
