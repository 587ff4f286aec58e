/// The loop that both programs run after their start: recorded bus and switches up to each step of the phase's grid, then
/// the frames. Made before a heap trap is closed around its running; nothing in it allocates afterwards.
#pragma once

#include <vector>

#include "bus/canaerospace/identification_service.hpp"
#include "bus/candump/candump_log_source.hpp"
#include "bus/state/state_assembler.hpp"
#include "bus/switches/switch_log_source.hpp"
#include "bus/switches/switch_to_phase.hpp"
#include "render_core/display/phase_monitor.hpp"
#include "tests/support/default_flight.hpp"

namespace tedavis::test_support {

class FlightLoop {
public:
    /// `log` holds the flight's log; what is given must outlive the loop.
    FlightLoop(const RecordedFlight& flight, base::ByteSource& log, HeadlessDisplay& display)
        : display_(display),
          window_(64 * 1024),
          can_(log, {window_.data(), window_.size()}),
          panel_(flight.switch_log, flight.panel),
          switches_(flight.panel),
          first_(first_stamp(flight.log)),
          next_step_(first_),
          next_frame_(first_),
          design_(shipped_design("default")) {}

    struct Seen {
        std::uint64_t frames = 0, frames_with_terrain = 0, good = 0;
        bool by_switch = false, by_can = false, by_motion = false;
    };

    /// Flies on to `seconds` after the log's start with a frame each `frame_step`; true while the log has frames.
    bool fly_to(double seconds, base::Duration frame_step) {
        const base::Time end = first_ + base::Duration::from_seconds(seconds);
        for (; next_step_ <= end; next_step_ = next_step_ + display::PhaseMonitor::kStep) {
            feed(next_step_);
            step_phase(next_step_);
            if (next_frame_ > next_step_) continue;
            draw(next_step_);
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

    void feed(base::Time now) {
        std::size_t count = batch_.size();
        while (count == batch_.size()) {
            count = can_.read(now, {batch_.data(), batch_.size()});
            assembler_.feed({batch_.data(), count});
            for (std::size_t n = 0; n < count; ++n)
                answers_ += bus::answer_identification(batch_[n], bus::NodeSettings()).due ? 1 : 0;
        }
        assembler_.note_dropped(can_.statistics().dropped);
        bus::SwitchEdge edge;
        while (panel_.read(now, base::Span<bus::SwitchEdge>(&edge, 1)) == 1) switches_.add(edge);
    }
    [[nodiscard]] flight::AircraftState aircraft_at(base::Time now) {
        flight::AircraftState aircraft = assembler_.snapshot(now).state;
        aircraft[flight::Signal::height_above_terrain] = display_.display().height_above_terrain(aircraft.own_ship, now);
        return aircraft;
    }
    void step_phase(base::Time now) {
        flight::PhaseInputs inputs;
        inputs.can = assembler_.snapshot(now).phase_status.phase;
        const bus::SwitchPhase switches = switches_.status(now);
        inputs.switches = switches.statement;
        inputs.switch_fault = switches.fault;
        const flight::PhaseSource source = monitor_.step(aircraft_at(now), inputs, now).source;
        seen_.by_switch = seen_.by_switch || source == flight::PhaseSource::switches;
        seen_.by_can = seen_.by_can || source == flight::PhaseSource::can;
        seen_.by_motion = seen_.by_motion || source == flight::PhaseSource::motion;
    }
    void draw(base::Time now) {
        display::Display& display = display_.display();
        display.update(aircraft_at(now), monitor_.status(), now);
        display.draw(display_.surface());
        seen_.good += display_.surface().present() == base::SurfaceState::ready ? 1 : 0;
        ++seen_.frames;
        seen_.frames_with_terrain += display.record().terrain.triangles > 0 ? 1 : 0;
    }

    HeadlessDisplay& display_;
    std::vector<char> window_;
    std::vector<bus::CanFrame> batch_ = std::vector<bus::CanFrame>(256);
    bus::CandumpLogSource can_;
    bus::SwitchLogSource panel_;
    bus::SwitchToPhase switches_;
    bus::StateAssembler assembler_{traffic_bus()};
    display::PhaseMonitor monitor_;
    base::Time first_, next_step_, next_frame_;
    design::DesignSettings design_;
    std::uint64_t answers_ = 0;
    Seen seen_;
};

}  // namespace tedavis::test_support
