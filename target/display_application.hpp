/// The display of one board from start to stop: the drawing half, bus and panel, and the frame loop.
///
/// start() acquires all resources; afterwards nothing allocates outside drivers. A missing bus, panel, terrain or scene never
/// ends the program: the display flags what is missing. Nor does a socket for records that cannot be made. A lost drawing surface
/// ends it, and the service manager restarts it.
///
/// Thread  one. Failure  start() returns one sentence; run() returns how it ended.
#pragma once

#include <cstdint>
#include <memory>

#include "platform/runtime/design_warmer.hpp"
#include "platform/runtime/display_host.hpp"
#include "target/board_clocks.hpp"
#include "target/board_config.hpp"
#include "target/event_log.hpp"
#include "target/frame_pacer.hpp"
#include "target/json_line.hpp"
#include "target/live_flight.hpp"
#include "target/phase_events.hpp"
#include "target/record_line.hpp"
#include "target/record_socket.hpp"
#include "target/scene_watch.hpp"
#include "target/screen_events.hpp"
#include "target/snapshot.hpp"
#include "target/stop_signal.hpp"
#include "target/watchdog.hpp"

namespace tedavis::target {

/// The machine's interfaces that the application uses besides files and the surface; tests substitute their own.
struct BoardPorts {
    bus::CanSocketPort* can = nullptr;
    std::unique_ptr<bus::GpioLines> gpio;  ///< null: built without a GPIO library
    BoardClocks clocks;
    base::Duration (*process_age)() = nullptr;  ///< see process_age.hpp; null: not known
    EventLog log;
    Snapshot* snapshot = nullptr;            ///< null, or not started: no picture is written
    PanelExplainer explain_panel = nullptr;  ///< see LiveFlight
};

enum class RunEnd : std::uint8_t { stopped, surface_lost };

struct RunReport {
    RunEnd end = RunEnd::stopped;
    std::uint64_t frames = 0;
    std::uint64_t missed = 0;  ///< periods of the frame rate that passed without a frame
    std::uint64_t gl_calls_outside_device = 0;
    bool has_first_picture = false;
    base::Duration first_picture;  ///< from the start of the process until the first correct picture was shown
    bool is_warm = false;          ///< all designs were drawn
    base::Duration warm;           ///< from the start of the process until then
    bus::BusCounters bus;
    LatencyReport latency;
    platform::ScreenReport screen;  ///< without a connector: the surface is no screen
};

class DisplayApplication {
public:
    DisplayApplication(const BoardSettings& settings, BoardPorts ports);
    ~DisplayApplication();
    DisplayApplication(const DisplayApplication&) = delete;
    DisplayApplication& operator=(const DisplayApplication&) = delete;

    /// Returns an empty error on success. May be called once.
    [[nodiscard]] base::Error start();
    /// Draws until `frames` are drawn (0: no limit) or `stop` is requested.
    [[nodiscard]] RunReport run(std::uint64_t frames, const StopSignal& stop);
    /// Draws one frame of the state at `now`; to be called after start().
    [[nodiscard]] base::SurfaceState draw_frame(base::Time now);

    [[nodiscard]] display::Display& display() { return host_.display(); }
    [[nodiscard]] const BoardSettings& settings() const { return settings_; }
    [[nodiscard]] const base::Error& terrain_fault() const { return host_.terrain_fault(); }
    [[nodiscard]] const LiveFlight& flight() const { return flight_; }
    [[nodiscard]] const base::Surface& surface() const { return host_.surface(); }
    /// Without a connector where the surface is no screen.
    [[nodiscard]] const platform::ScreenReport& screen() const { return screen_; }

private:
    [[nodiscard]] bool wants_picture(bool is_last);
    void report_screen();
    void await_compilation(const flight::FrameInput& input);
    void record_first_picture(const flight::FrameInput& input);
    [[nodiscard]] std::optional<base::Duration> record_latency();
    void start_records();
    void hand_out_record();
    void hold_for_screen();
    [[nodiscard]] base::Time next_frame(base::Duration work);
    void start_scene();
    void take_new_scene();
    void warm_next_design();
    void record_warm();

    BoardSettings settings_;
    BoardPorts ports_;
    LiveFlight flight_;
    PhaseEvents phase_events_;
    std::uint64_t drawn_ = 0;
    Watchdog watchdog_;
    FramePacer pacer_;
    base::Duration held_;                  ///< the last frame, so that the screen does not show it too early
    flight::FlightPhase presented_phase_;  ///< of the frame before
    bool was_placed_ = false;              ///< it knew the own ship's position
    platform::ScreenReport screen_;
    ScreenEvents screen_events_;
    platform::DisplayHost host_;
    bool has_first_picture_ = false;
    base::Duration first_picture_;
    platform::DesignWarmer warmer_;
    bool follows_warming_ = false;  ///< the next frame: a new scene, which fades in over the last frame, waits for it
    bool is_warm_ = false;          ///< has been, since the start
    base::Duration warm_;
    flight::FrameInput input_;  ///< of the last frame
    bool is_pictured_ = false;  ///< the frame that is drawn next
    FrameDelivery delivery_;    ///< of the last frame
    RecordSocket records_;
    JsonLine record_line_;
    SceneWatch scene_watch_;  ///< reads into the display's memory
};

}  // namespace tedavis::target
