/// The shipped default flight over a terrain: poses along it, and the data round it, for the knobs that draw with the display.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host_sim/geoid_egm96.hpp"
#include "host_sim/scenario/posed_aircraft.hpp"
#include "host_sim/scenario/scenario_flight.hpp"
#include "host_sim/temporary_folder.hpp"
#include "host_sim/tracing/traced_ground.hpp"

namespace tedavis::host_sim {

/// Over a terrain that does not hold the whole flight, the strip is moved to the terrain's middle, at the height of the highest
/// post, and the flight and its weather with it; the layers of places then stay away.
class KnobFlight {
public:
    /// Throws UserError where a shipped file or the grid of EGM96 is missing.
    explicit KnobFlight(const TracedGround& ground);
    KnobFlight(const KnobFlight&) = delete;
    KnobFlight& operator=(const KnobFlight&) = delete;

    /// The pose at a time since the begin, which is clamped to the flight.
    [[nodiscard]] AircraftPose pose_at(double at_s) const;
    /// The poses in the middle of `count` equal parts of the flight.
    [[nodiscard]] std::vector<AircraftPose> poses(std::size_t count) const;
    [[nodiscard]] double duration_s() const;
    [[nodiscard]] base::Time begin() const { return flight_.begin(); }
    [[nodiscard]] bool is_moved() const { return is_moved_; }
    /// Path of a database with the flight's data, which lasts as long as the object. It is made by the first call.
    [[nodiscard]] const std::string& scene();

private:
    [[nodiscard]] static Scenario scenario_over(const TracedGround& ground, const GeoidEgm96& geoid, bool& is_moved);

    GeoidEgm96 geoid_ = GeoidEgm96::installed();
    bool is_moved_ = false;
    Scenario scenario_;
    ScenarioFlight flight_;
    TemporaryFolder folder_;
    std::string scene_;
};

/// As `--pose` of `tedavis shot` takes it.
[[nodiscard]] std::string pose_text(const AircraftPose& pose);

}  // namespace tedavis::host_sim
