/// The results of a run of `tedavis accuracy` and the conditions of its measurements.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/accuracy/flight_errors.hpp"
#include "host_sim/accuracy/governor_choice.hpp"
#include "host_sim/accuracy/measured_knob.hpp"
#include "host_sim/accuracy/negative_control.hpp"
#include "host_sim/accuracy/rank_agreement.hpp"
#include "host_sim/accuracy/uncalled_effects.hpp"

namespace tedavis::host_sim {

/// The inputs of the measurements: names as the user gave them, and identity numbers, which differ if the contents differ.
struct MeasuredInputs {
    std::string terrain;
    std::uint64_t terrain_identity = 0;         ///< terrain_identity()
    std::string flight = "the shipped flight";  ///< the flight along which knobs are measured
    std::uint64_t flight_identity = 0;          ///< RecordedPoses::identity; 0: the shipped flight
    std::string size, device, design;           ///< of the displays that draw the flight; size as "640 x 360"
    std::uint64_t display_identity = 0;         ///< of size, device and design, by the texts of the files
    bool is_quick = false;
};

struct MeasuringConditions : MeasuredInputs {
    std::string version, commit, compiler, command, date;  ///< date: when the first knob was measured, UTC
    std::string processor, renderer;                       ///< renderer: the name that the GL driver states
    unsigned processors = 0;
    double load = 0;            ///< load average of the last minute at the start of the run; 0: unknown
    std::uint64_t program = 0;  ///< program_identity() (replay/index_key.hpp)
};

/// A level of this report beside the same level of an earlier one.
struct ComparedLevel {
    std::string knob, level;
    double ms = 0, earlier_ms = 0;                     ///< medians
    double error = 0, earlier_error = 0;               ///< the greatest
    bool is_slower = false, is_less_accurate = false;  ///< beyond the limits
};

/// An earlier report that this one is compared with (compare_accuracy.hpp).
struct ComparedReport {
    std::string file, processor, date, version;  ///< of the earlier report
    bool is_same_machine = false;                ///< true: times are judged
    std::vector<ComparedLevel> levels;
    std::vector<std::string> gone;  ///< "knob: level" that only the earlier report has, of knobs that both measured
    RankAgreement ranks;            ///< whether both rank levels by time alike
};

struct AccuracyReport {
    MeasuringConditions conditions;
    bool interrupted = false;
    std::vector<MeasuredKnob> knobs;        ///< in the registry's order
    std::optional<double> budget_ms;        ///< time budget of the last run, on which the answers depend; nothing: none was given
    std::vector<std::string> not_measured;  ///< names of knobs that were requested and not measured
    std::vector<FlightErrors> flights;
    std::optional<UncalledEffects> uncalled;
    std::optional<GovernorChoice> governor;
    std::optional<NegativeControl> control;
    std::vector<ComparedReport> comparisons;
};

/// Returns the conditions of a run that begins now, on this machine and with this program.
[[nodiscard]] MeasuringConditions conditions_now(const std::string& command, const std::string& renderer,
                                                 const MeasuredInputs& inputs);

/// Returns whether both measured the same heights, flight and extent, and displays of the same names. The files of these displays
/// may have changed between two versions.
[[nodiscard]] bool have_same_inputs(const MeasuredInputs& a, const MeasuredInputs& b);

/// Returns whether figures of both may be in one report, that is, whether program, machine, files of displays, and inputs are the
/// same.
[[nodiscard]] bool are_of_one_kind(const MeasuringConditions& a, const MeasuringConditions& b);

}  // namespace tedavis::host_sim
