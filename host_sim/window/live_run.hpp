/// A session in the window: applies the requests of the controller to the flight, the display and the run's folder.
///
/// Frames from the cockpit are recorded in the folder as in a batch run: frames.jsonl, summary.json, report.html. Keys of the
/// phase switches act at the shown time: from then on the panel has their pattern, and later edges of the switch log or of
/// earlier keys are discarded. The resulting switch log is written to window.switches; with it a batch replay draws the same
/// pictures. The accuracy overlay and the window's own overlay (window_overlay.hpp) are on the screen alone. Neither a clock nor
/// a screen is needed.
///
/// If many intervals before a picture have not been decided, as at the first one with --from or after a long leap, a turn decides
/// some of them and shows a picture without the effect of earlier frames. The window states this, and no record contains such a
/// picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host_sim/accuracy/accuracy_overlay.hpp"
#include "host_sim/console.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/flight_player.hpp"
#include "host_sim/replay/frame_instants.hpp"
#include "host_sim/replay/frame_preroll.hpp"
#include "host_sim/replay/interval_store.hpp"
#include "host_sim/replay/run_recorder.hpp"
#include "host_sim/window/camera_tour.hpp"
#include "host_sim/window/design_watch.hpp"
#include "host_sim/window/window_controller.hpp"
#include "host_sim/window/window_overlay.hpp"
#include "platform/window/window_surface.hpp"

namespace tedavis::host_sim {

class LiveRun {
public:
    /// `window` is the surface of `session`. `files` are IntervalStore::files_before_start(). All but the options and the files,
    /// which are copied, must outlive the run. Throws UserError.
    LiveRun(const ReplayOptions& options, const std::optional<DisplayFiles>& files, DisplaySession& session, FlightPlayer& player,
            platform::Window& window, Console& console);

    /// Processes the window's events, advances by the elapsed time `wall`, and draws if something changed; returns true if it
    /// drew.
    bool turn(base::Duration wall);
    /// Processes events that were received before the run began.
    void handle(const std::vector<platform::WindowEvent>& events);
    [[nodiscard]] bool closed() const { return controller_.closed(); }
    [[nodiscard]] const WindowController& controller() const { return controller_; }
    /// False while the flight before the shown instant is being decided.
    [[nodiscard]] bool is_prepared() const { return !prepared_percent_; }

    /// Writes the folder and, on request, the config that replays the session. To be called once, at the end. Returns the exit
    /// code, as RunRecorder::finish.
    [[nodiscard]] int finish(bool interrupted);

private:
    /// All that a picture depends on; if it is unchanged, nothing is drawn.
    struct Shown {
        std::uint64_t frame = 0, revision = 0;
        CameraMode mode = CameraMode::cockpit;
        CameraPose camera;
        AccuracyShown accuracy;
        design::SymbologyLight light = design::SymbologyLight::day;
        std::optional<flight::LegendShow> legend;
    };
    void take_events();
    void handle(const platform::WindowEvent& event);
    [[nodiscard]] bool prepare(const Shown& wanted);
    void draw_unprepared(base::Time now);
    void take_screenshot();
    [[nodiscard]] WindowOverlay window_overlay() const;
    [[nodiscard]] std::string camera_text() const;
    [[nodiscard]] CameraPose cockpit_pose() const;
    void turn_switches(std::uint32_t pattern);
    void watch_design(base::Duration wall);
    [[nodiscard]] Shown wanted() const;
    void draw(const Shown& wanted);
    void draw_again();
    void turn_accuracy();
    void turn_light();
    void turn_legend(const Shown& wanted);
    void present();
    void aim(const Shown& wanted);
    void show_title();
    [[nodiscard]] base::Time shown_time() const { return times_.in_order_of_time(controller_.transport().frame()); }
    [[nodiscard]] double seconds(base::Time time) const { return (time - player_.first()).to_seconds(); }
    [[nodiscard]] std::string switches_path() const;
    void write_switches() const;

    ReplayOptions options_;
    DisplaySession& session_;
    FlightPlayer& player_;
    platform::Window& window_;
    Console& console_;
    FrameInstants times_;
    DesignWatch design_;
    std::optional<CameraTour> tour_;
    WindowController controller_;
    FramePreroll preroll_;
    RunRecorder recorder_;
    AccuracyOverlay overlay_;
    std::optional<Shown> shown_;
    std::uint64_t revision_ = 0;  ///< counts changes of switches and design
    base::Duration since_look_;
    std::optional<base::Time> latest_kept_;
    std::string title_;
    std::string painted_line_;  ///< lines of the window's overlay that are on the screen
    bool paints_help_ = false;
    IntervalStore intervals_;
    std::uint64_t decided_revision_ = 0;
    bool is_unprepared_shown_ = false;
    std::int64_t undecided_ = 0;  ///< number of intervals when preparing began
    std::optional<int> prepared_percent_;
    std::string said_;  ///< message about the last screenshot
    base::Duration said_left_;
};

}  // namespace tedavis::host_sim
