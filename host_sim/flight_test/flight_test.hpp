/// A flight test: the display's files, its input, and the expectations of its frames.
///
/// Units are SI and radians; times are seconds since the first frame of the input.
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

/// One frame, as expectations observe it.
struct ObservedFrame {
    double time_s = 0;
    display::FrameRecord record;
    double latency_frames = 0;          ///< age of the newest bus message in periods of the device's frame rate; NaN: not known
    bool is_latency_to_screen = false;  ///< latency_frames is the time from the bus to the screen, as a board measures it
    bool has_obstacles = false;         ///< there are data of obstacles, so that an alert is possible
    SignalSample values;                ///< values that the display received, SI
    std::vector<PlacedWords> words;     ///< texts of the symbology; read only if a condition of the test expects one
    ShownPicture* picture = nullptr;    ///< valid while this frame is judged; null: there is no picture, as on a board
};

/// The result of a condition in a frame: whether it holds, the value that was found, and the reason by the record.
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

/// Both ends belong to it; SI.
struct SignalRange {
    double low = 0, high = 0;
};

struct FrameCondition {
    std::string key, expected;
    FrameObserver observe;
    std::optional<flight::Signal> signal{};  ///< whose state or value it expects; nothing: none
    /// For a condition on several frames together: makes the observer of one window, which then takes its frames in order.
    std::function<FrameObserver(WindowKind)> begin{};
    std::optional<SignalRange> range{};  ///< of one that asks for the value of `signal`
};

/// Names that a script can use for the display under test.
struct TestedDisplay {
    std::vector<std::string> designs;  ///< names that a frame's design can have
    PictureOptions picture;            ///< options that the script states
};

struct Expectation {
    std::string file, name;
    std::size_t line = 0;
    WindowKind kind = WindowKind::at;
    double from_s = 0, to_s = 0;
    bool stays = false;                      ///< of WindowKind::within: once reached it must hold up to to_s
    std::vector<FrameCondition> conditions;  ///< all must hold in the same frame

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
    std::uint32_t times = 0;  ///< number of changes of level
    double gap_s = 0;         ///< between two changes

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
    double over_s = 0;  ///< duration of the ramp
    std::vector<flight::Signal> stop, send, invalid;
    bool stops_phase = false, stops_clock = false, sends_clock = false;
    std::optional<flight::FlightPhase> phase;  ///< stated by message 1830 from this step on
    bool phase_valid = true;
    bus::PhaseOrigin phase_origin = bus::PhaseOrigin::fms;
    std::vector<LineLevel> lines;
    std::optional<LineBounce> bounce;
    std::vector<bus::CanFrame> frames;  ///< sent unchanged
};

/// The state of the aircraft at time 0. From there it moves by its ground speed, track and vertical speed.
struct TestStart {
    base::Time time;
    double latitude_rad = 0, longitude_rad = 0, altitude_msl_m = 0;
    double heading_rad = 0, speed_mps = 0, climb_mps = 0;
    std::optional<double> ground_msl_m;  ///< height of flat ground for the radio altimeter; nothing: there is no ground
};

struct FlightTest {
    std::string path, title;
    PictureOptions picture;  ///< design, device, bus, aircraft, terrain and scene
    std::string switch_config;
    std::string log, switch_log;  ///< of a recorded flight; empty: the input is a scenario or the steps
    std::string scenario;         ///< of a generated flight
    bool has_steps = false;
    TestStart start;
    std::vector<TestStep> steps;  ///< ascending in at_s
    std::vector<Expectation> expectations;
    double end_s = 0;                ///< end of the flight of the steps
    bus::BusSettings bus;            ///< of the bus file
    bus::SwitchConfig panel;         ///< of the panel's file
    std::vector<std::string> files;  ///< from which the test was read
    std::vector<std::string> parameters;
    std::size_t input_line = 1;  ///< line of `path` that names its log or scenario
};

}  // namespace tedavis::host_sim
