/// A report with one closest point by height and one by distance.
#pragma once

#include "host_sim/reports/closest_json.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::test_support {

inline host_sim::ClosestReport closest_report() {
    host_sim::TrackSample sample;
    sample.time = base::Time{} + base::Duration::seconds(83);
    sample.own = {{base::radians(46.7312), base::radians(9.8123), {2050}}, 2000, true};
    sample.height_above_terrain_m = 95;
    sample.along_m = 5000;
    sample.uncertainty = {15.0, 18.0, 16.0};
    sample.phase = {flight::Scenario::cruise, 0};
    const host_sim::GroundPlace ground{80, base::radians(120), base::radians(-50), sample.own.place, 1930};
    const host_sim::StatedClosest closest{{sample, ground},
                                          83.2,
                                          "2023-11-14T14:23:05.2Z",
                                          {42, 83.5, policy::TerrainAhead::caution, "cruise", "frames/000042.png", {}}};
    host_sim::ClosestReport report;
    report.is_searched = true;
    report.sample_step_s = 0.5;
    report.left_out_s = 60;
    report.by_height = report.by_distance = {closest};
    for (int n = 0; n < 20; ++n) {
        sample.along_m = 500.0 * n;
        report.track.push_back(sample);
    }
    return report;
}

}  // namespace tedavis::test_support
