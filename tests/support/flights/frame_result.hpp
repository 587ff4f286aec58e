/// One frame's result with something in every field, for tests of what records and reports say.
#pragma once

#include "host_sim/reports/frame_record_json.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::test_support {

inline host_sim::FrameResult frame_result(std::uint64_t frame, double time_s) {
    host_sim::FrameResult result;
    display::FrameRecord& record = result.record;
    record.frame = frame;
    record.time = base::Time{} + base::Duration::from_seconds(time_s);
    record.phase.phase = flight::kTakeoffFirstClimb;
    record.phase.source = flight::PhaseSource::can;
    record.own_ship.position = {base::radians(46.5), base::radians(9.75), {1560}};
    record.own_ship.state = base::SignalState::valid;
    record.own_ship.height_is_geometric = true;
    record.altitude_msl_m = 1510;
    record.heading_rad = base::radians(270);
    record.pitch_rad = base::radians(5);
    record.roll_rad = base::radians(-10);
    record.elements[static_cast<std::size_t>(policy::Element::slip)] = policy::ElementShow::flagged;
    record.terrain = {1,
                      0.75,
                      base::FixedString<31>("2/3/4"),
                      1.5,
                      display::Name("triangles"),
                      12345,
                      67,
                      8,
                      display::Name("raster"),
                      base::FixedString<63>("the device's lane is es2")};
    record.bytes = {100, 200, 1000, 2000, 50};
    result.hash = 0x0123456789abcdefu;
    result.timing = {1, 2, 3};
    result.latency_ms = 12;
    return result;
}

}  // namespace tedavis::test_support
