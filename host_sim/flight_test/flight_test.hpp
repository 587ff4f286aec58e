/// A flight test: what the display is started with, what it is fed with, and what is expected of it.
///
/// SI and radians; times are seconds since the first frame of the input.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bus/canaerospace/bus_settings.hpp"
#include "bus/canaerospace/message_encoder.hpp"
#include "bus/frame/can_frame.hpp"
#include "bus/switches/switch_config.hpp"
#include "host_sim/flight_log/signal_sample.hpp"
#include "host_sim/flight_test/placed_words.hpp"
#include "host_sim/flight_test/shown_picture.hpp"
#include "host_sim/options/picture_options.hpp"
#include "render_core/display/planner/frame_record.hpp"

namespace tedavis::host_sim {

/// What one frame shows, as expectations see it.
struct ObservedFrame {
    double time_s = 0;
    display::FrameRecord record;
    double latency_frames = 0;          ///< age of the newest message, in frames of the device; NaN: not known
    bool is_latency_to_screen = false;  ///< latency_frames is the time from the bus to the screen, as a board measures it
    bool has_obstacles = false;         ///< data of obstacles ahead, of which there could be an alert
    SignalSample values;                ///< that the display was given, SI
    std::vector<PlacedWords> words;     ///< where a condition of the test asks for a text
    ShownPicture* picture = nullptr;    ///< while this frame is judged; null: nobody can look at its picture, as on a board
};

/// Whether a condition holds in a frame, what was found there, and what the record says of the reason.
struct Observation {
    bool holds = false;
    std::string found, reason;
};

using FrameObserver = std::function<Observation(const ObservedFrame&)>;

/// When an expectation must hold.
enum class WindowKind : std::uint8_t {
    at,      ///< in the first frame at or after from_s
    during,  ///< in every frame from from_s to to_s
    within,  ///< not in the first frame from from_s on, but in a later one up to to_s
};

struct FrameCondition {
    std::string key, expected;
    FrameObserver observe;
    std::optional<flight::Signal> signal{};  ///< whose state or value it asks for
    /// Of one that looks at frames together, the frames of a window in their order: makes what observes those of one window.
    std::function<FrameObserver(WindowKind)> begin{};
};

/// What a script can name of the display that it tests.
struct TestedDisplay {
    std::vector<std::string> designs;  ///< names that a frame's design can have
    PictureOptions picture;            ///< as the script says
};

struct Expectation {
    std::string file, name;
    std::size_t line = 0;
    WindowKind kind = WindowKind::at;
    double from_s = 0, to_s = 0;
    bool stays = false;                      ///< of one that must be reached: it holds from then to to_s
    std::vector<FrameCondition> conditions;  ///< all of them, in one frame

    [[nodiscard]] bool reads_text() const {
        for (const FrameCondition& condition : conditions)
            if (condition.key == "text") return true;
        return false;
    }
};

struct SignalTarget {
    flight::Signal signal = flight::Signal::count_;
    double si = 0;
};

struct LineBounce {
    std::size_t line = 0;     ///< of the panel
    std::uint32_t times = 0;  ///< changes of level
    double gap_s = 0;         ///< between them

    [[nodiscard]] double lasts_s() const { return (times - 1) * gap_s; }
};

struct LineLevel {
    std::size_t line = 0;
    bool level = false;
};

struct TestStep {
    std::string file;
    std::size_t line = 0;
    double at_s = 0;
    std::vector<SignalTarget> hold, ramp;
    double over_s = 0;  ///< of the ramp
    std::vector<flight::Signal> stop, send, invalid;
    bool stops_phase = false, stops_clock = false, sends_clock = false;
    std::optional<flight::FlightPhase> phase;  ///< that message 1830 states from here on
    bool phase_valid = true;
    bus::PhaseOrigin phase_origin = bus::PhaseOrigin::fms;
    std::vector<LineLevel> lines;
    std::optional<LineBounce> bounce;
    std::vector<bus::CanFrame> frames;  ///< as they are
};

/// Where the aircraft is at first; from there it moves as its ground speed, track and vertical speed say.
struct TestStart {
    base::Time time;
    double latitude_rad = 0, longitude_rad = 0, altitude_msl_m = 0;
    double heading_rad = 0, speed_mps = 0, climb_mps = 0;
    std::optional<double> ground_msl_m;  ///< flat ground below, which the radio altimeter measures; nothing: there is none
};

struct FlightTest {
    std::string path, title;
    PictureOptions picture;  ///< design, device, bus, aircraft, terrain and scene
    std::string switch_config;
    std::string log, switch_log;  ///< of a recorded flight; empty: the steps
    std::string scenario;         ///< of a generated flight
    bool has_steps = false;
    TestStart start;
    std::vector<TestStep> steps;  ///< in order of time
    std::vector<Expectation> expectations;
    double end_s = 0;                ///< of the steps' flight
    bus::BusSettings bus;            ///< as the bus file says
    bus::SwitchConfig panel;         ///< as the panel's file says
    std::vector<std::string> files;  ///< that it was read from
    std::vector<std::string> parameters;
    std::size_t input_line = 1;  ///< where `path` says its log or scenario
};

}  // namespace tedavis::host_sim
