/// A recorded flight through the tracker and the display, as both programs fly it. Made before a heap trap is closed around its
/// running; nothing in it allocates afterwards.
#pragma once

#include <vector>

#include "bus/canaerospace/identification_service.hpp"
#include "bus/candump/candump_log_source.hpp"
#include "bus/switches/switch_log_source.hpp"
#include "bus/tracker/flight_tracker.hpp"
#include "tests/support/flights/default_flight.hpp"

namespace tedavis::test_support {

class FlightLoop : private bus::FrameListener {
public:
    /// `log` holds the flight's log; what is given must outlive the loop.
    FlightLoop(const RecordedFlight& flight, base::ByteSource& log, HeadlessDisplay& display)
        : display_(display),
          window_(64 * 1024),
          can_(log, {window_.data(), window_.size()}),
          panel_(flight.switch_log, flight.panel),
          first_(first_stamp(flight.log)),
          next_frame_(first_),
          memory_(traffic_bus(), &flight.panel, first_),
          tracker_(memory_, {can_, &panel_, this}),
          design_(shipped_design("default")) {}

    struct Seen {
        std::uint64_t frames = 0, frames_with_terrain = 0, good = 0;
        bool by_switch = false, by_can = false, by_motion = false;
    };

    /// Flies on to `seconds` after the log's start with a frame each `frame_step`; true while the log has frames.
    bool fly_to(double seconds, base::Duration frame_step) {
        const base::Time end = first_ + base::Duration::from_seconds(seconds);
        while (tracker_.next_step() <= end) {
            const flight::FrameInput input = tracker_.advance_to(tracker_.next_step(), display_.display().planner());
            record_source(input.phase.source);
            if (next_frame_ > input.time) continue;
            draw(input);
            next_frame_ = next_frame_ + frame_step;
        }
        return can_.health() == bus::SourceHealth::running;
    }
    /// What a live reload of the design does.
    [[nodiscard]] bool reload_design() { return display_.display().set_design(design_); }
    [[nodiscard]] const Seen& seen() const { return seen_; }
    [[nodiscard]] const bus::LogPosition& position() const { return can_.position(); }

private:
    static base::Time first_stamp(const std::string& log) {
        return base::Time{} + base::Duration::seconds(std::stoll(log.substr(1, 10)));
    }

    void receive(base::Span<const bus::CanFrame> frames) override {
        for (const bus::CanFrame& frame : frames) answers_ += bus::answer_identification(frame, bus::NodeSettings()).due ? 1 : 0;
    }
    void record_source(flight::PhaseSource source) {
        seen_.by_switch = seen_.by_switch || source == flight::PhaseSource::switches;
        seen_.by_can = seen_.by_can || source == flight::PhaseSource::can;
        seen_.by_motion = seen_.by_motion || source == flight::PhaseSource::motion;
    }
    void draw(const flight::FrameInput& input) {
        display::Display& display = display_.display();
        display.plan(input);
        display.draw(display_.surface());
        seen_.good += display_.surface().present() == base::SurfaceState::ready ? 1 : 0;
        ++seen_.frames;
        seen_.frames_with_terrain += display.record().terrain.triangles > 0 ? 1 : 0;
    }

    HeadlessDisplay& display_;
    std::vector<char> window_;
    bus::CandumpLogSource can_;
    bus::SwitchLogSource panel_;
    base::Time first_, next_frame_;
    bus::TrackerMemory memory_;
    bus::FlightTracker tracker_;
    design::DesignSettings design_;
    std::uint64_t answers_ = 0;
    Seen seen_;
};

}  // namespace tedavis::test_support
