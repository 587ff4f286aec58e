#include "host_sim/commands/gallery_moments.hpp"

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr flight::FlightPhase kOnTheGround{flight::Scenario::ground}, kCruising{flight::Scenario::cruise};
constexpr flight::FlightPhase kApproaching{flight::Scenario::approach};

base::Time at_share(const PhaseSpan& span, double share) {
    return span.begin + base::Duration::from_seconds(share * (span.end - span.begin).to_seconds());
}

/// A time without interruption in one scenario, as the range of its phases.
struct ScenarioSpan {
    std::size_t begin = 0, end = 0;
};

ScenarioSpan next_scenario(const std::vector<PhaseSpan>& spans, std::size_t begin) {
    ScenarioSpan next{begin, begin};
    while (next.end < spans.size() && spans[next.end].phase.scenario == spans[begin].phase.scenario) ++next.end;
    return next;
}

PhaseSpan within_scenario(const std::vector<PhaseSpan>& spans, const ScenarioSpan& scenario, flight::FlightPhase phase) {
    for (std::size_t n = scenario.begin; n < scenario.end; ++n)
        if (phase.sub_phase != 0 && spans[n].phase == phase) return spans[n];
    return {{phase.scenario}, spans[scenario.begin].begin, spans[scenario.end - 1].end};
}

}  // namespace

const std::vector<GalleryMoment>& gallery_moments() {
    static constexpr const char* kOut = "Out";
    static constexpr const char* kBack = "Back";
    static constexpr const char* kAgain = "Once more";
    static constexpr ReadmePlace kRow = ReadmePlace::row;
    static const std::vector<GalleryMoment> kMoments = {
        {kOut, "parked", "Before take-off", "The planned climb and the mountains lie ahead.", kOnTheGround, 0, 0.6},
        {kOut, "roll", "Take-off roll", "The ground keeps its natural colors: no alert on the runway.", flight::kTakeoffStart, 0,
         0.45},
        {kOut, "climb", "First climb", "Frames show the planned path, and diamonds other aircraft.", flight::kTakeoffFirstClimb,
         0, 0.75},
        {kOut, "storm", "Towards the storm", "Storm cells have the colors of a weather radar.", flight::kTakeoffSecondClimb, 0,
         0.93},
        {kBack, "cruise", "Cruise", "Data come first: radar, storm, wind and traffic over quiet ground.", kCruising, 0, 0.8,
         kRow},
        {kBack, "terrain_ahead", "Terrain ahead", "Only the ground that the aircraft comes too close to is colored.",
         flight::kApproachDescent, 0, 0.93, kRow},
        {kBack, "approach", "Approach", "The aircraft turns to the runway on the planned path.", kApproaching, 0, 0.72},
        {kBack, "short_final", "Short final", "Runway, lights of the glide path, frames, and an aircraft on the runway.",
         kApproaching, 0, 0.98, ReadmePlace::large},
        {kAgain, "go_around", "Go-around", "Another aircraft is on the runway: the way up comes first.", flight::kGoAroundAbort,
         0, 0.5},
        {kAgain, "replanning", "Re-planning", "Uncertainty comes first: the larger a pyramid, the less sure the wind.",
         flight::kGoAroundReplanning, 0, 0.2, kRow},
        {kAgain, "second_approach", "Second approach", "The aircraft is on final again, below its minimum.",
         flight::kApproachFinal, 1, 0.85},
        {kAgain, "landing", "Landing", "The runway has its numbers, threshold and aiming points.", flight::kApproachLanding, 1,
         0.5, kRow},
    };
    return kMoments;
}

void add_to_spans(flight::FlightPhase phase, base::Time time, std::vector<PhaseSpan>& spans) {
    if (spans.empty() || spans.back().phase != phase) spans.push_back({phase, time, time});
    spans.back().end = time;
}

base::Time instant_of(const GalleryMoment& moment, const std::vector<PhaseSpan>& spans, const std::string& log) {
    std::size_t turn = 0;
    for (ScenarioSpan scenario; scenario.end < spans.size();) {
        scenario = next_scenario(spans, scenario.end);
        if (spans[scenario.begin].phase.scenario == moment.phase.scenario && turn++ == moment.turn)
            return at_share(within_scenario(spans, scenario, moment.phase), moment.share);
    }
    throw UserError(log + ": flies the scenario " + flight::scenario_name(moment.phase) + " " +
                    (turn == 1 ? "once" : std::to_string(turn) + " times") + ", and the picture '" + moment.title +
                    "' shows time " + std::to_string(moment.turn + 1) + "; give the scenario file such a leg");
}

}  // namespace tedavis::host_sim
