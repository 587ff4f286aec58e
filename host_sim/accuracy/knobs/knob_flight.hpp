/// The flight that knobs draw with the display: the shipped default flight over a terrain, or a recorded one; poses along it, and
/// the data round it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host_sim/accuracy/knobs/knob_ground.hpp"
#include "host_sim/geoid_egm96.hpp"
#include "host_sim/scenario/scenario_flight.hpp"
#include "host_sim/temporary_folder.hpp"

namespace tedavis::host_sim {

/// Over a terrain that does not contain the whole default flight, the flight's airstrip is moved to the terrain's middle, at the
/// height of the highest post, together with the flight and its weather; the layers of places are then left out.
///
/// A recorded flight has no data of its own. Around it are the default flight's data, moved in the same way, but with the
/// airstrip below the middle of the recorded flight.
class KnobFlight {
public:
    /// `recorded` is null for the default flight, and else must outlive the object. Throws UserError where a shipped file or the
    /// grid of EGM96 is missing.
    explicit KnobFlight(const TracedGround& ground, const RecordedPoses* recorded = nullptr);
    explicit KnobFlight(const KnobGround& ground) : KnobFlight(ground.ground, ground.recorded) {}
    KnobFlight(const KnobFlight&) = delete;
    KnobFlight& operator=(const KnobFlight&) = delete;

    /// "the shipped flight", or the log's name.
    [[nodiscard]] std::string name() const;
    /// The pose at a time since the begin, which is clamped to the flight. Where a recorded flight has no valid position, it is
    /// the last one before.
    [[nodiscard]] AircraftPose pose_at(double at_s) const;
    /// The poses in the middle of `count` equal parts of the flight, or of the time in which its position is valid.
    [[nodiscard]] std::vector<AircraftPose> poses(std::size_t count) const;
    [[nodiscard]] double duration_s() const;  ///< of that time, in which the position is valid
    /// The time from which pose_at() counts.
    [[nodiscard]] base::Time begin() const { return recorded_ == nullptr ? flight_.begin() : base::Time{}; }
    /// The phase that the shipped flight has at the time of a pose; of a recorded one that of the pose.
    [[nodiscard]] flight::FlightPhase phase_at(const AircraftPose& pose) const;
    /// Adds the data of the shipped flight besides position and attitude: air data, and other aircraft that it receives. For a
    /// recorded flight it adds nothing.
    void add_signals(const AircraftPose& pose, flight::AircraftState& state) const;
    /// Path of a database with the flight's data, which lasts as long as the object. It is made by the first call.
    [[nodiscard]] const std::string& scene();

private:
    [[nodiscard]] Scenario scenario_over(const TracedGround& ground);
    [[nodiscard]] AircraftPose recorded_pose_at(double at_s) const;

    const RecordedPoses* recorded_;
    GeoidEgm96 geoid_ = GeoidEgm96::installed();
    bool is_moved_ = false;
    Scenario scenario_;
    ScenarioFlight flight_;
    TemporaryFolder folder_;
    std::string scene_;
};

/// As `--pose` of `tedavis shot` takes it.
[[nodiscard]] std::string pose_text(const AircraftPose& pose);
/// As `--phase` of `tedavis shot` states it; none where the pose has no phase.
[[nodiscard]] flight::PhaseStatus phase_of(const AircraftPose& pose);
/// " --phase P" of `tedavis shot`; empty where the pose has no phase.
[[nodiscard]] std::string phase_option(const AircraftPose& pose);

}  // namespace tedavis::host_sim
