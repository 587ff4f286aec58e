/// What was measured of a knob: times with their spread, errors with their distribution, what follows from both.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/accuracy/knob_pictures.hpp"
#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/statistics.hpp"

namespace tedavis::host_sim {

struct MeasuredLevel {
    std::string name;
    double amount = 0;
    TimeSpread ms;                 ///< of all samples, once
    TimeSpread sample_ms;          ///< of one sample, over all samples and rounds
    double kept_ms = 0;            ///< what 95 of 100 runs of its slowest sample keep to; see `kept_times`
    double kept_99_ms = 0;         ///< what 99 of 100 runs keep to
    std::string options;           ///< of `tedavis replay`, which give the level; may be empty
    ErrorDistribution error;       ///< in the metric's unit
    std::optional<double> proven;  ///< the greatest error that the product states for its frames, in the same unit
    std::uint64_t bytes = 0;
    std::optional<std::uint64_t> uploaded_bytes;  ///< to the GPU, of a frame
    double build_ms = 0;
    std::string worst_place;    ///< where the greatest error is
    std::string worst_command;  ///< that gives it again
    std::size_t worst_sample = 0;
    std::optional<KnobPixel> worst_pixel;  ///< of knobs that draw pictures
    bool is_dominated = false;             ///< another level is more accurate and no slower, or as accurate and quicker
    bool is_near_reference = false;        ///< its greatest error is less than ten times the reference's own bound
    bool is_offered = true;                ///< by the product; false: an alternative to its only level

    /// What the level may be trusted to keep to: the proven error where there is one, else the greatest that was measured.
    [[nodiscard]] double trusted_error() const { return proven && *proven > error.max ? *proven : error.max; }
};

/// What the levels work through.
struct MeasuredWork {
    std::string thing;
    std::vector<double> counts;  ///< by level, mean of a sample
    FittedLaw law;               ///< over the amount
    std::string law_expected;
    bool law_agrees = false;
    double fixed_ms = 0, ms_per_thousand = 0;  ///< median time of a sample = fixed + that of its things, by least squares
};

struct MeasuredKnob {
    std::string name, title, setting, metric, unit, amount;
    std::string reference, reference_reason, second_oracle, never_trades;
    double reference_bound = 0;
    std::size_t rounds = 0, samples = 0;
    /// The greatest ratio of two medians of the same level, from the odd rounds and the even ones, less 1.
    double noise = 0;
    std::size_t moments = 0;  ///< that were timed beside the samples
    /// How much longer the dearest moment takes than the slowest sample, medians of one level; 1 or more.
    double dearest = 1;
    std::vector<MeasuredLevel> levels;  ///< as the knob has them
    std::string only_level;             ///< why the product offers one level, the first; empty: it offers all
    FittedLaw error_law, time_law;      ///< over the amount: mean error, median time
    std::string law_expected;           ///< in words; empty: none is known
    bool law_agrees = false;            ///< with what is expected
    std::optional<MeasuredWork> work;
    std::optional<KnobPictures> pictures;

    [[nodiscard]] bool has_one_level() const { return !only_level.empty(); }
};

/// True where the noise does not hide which of both is quicker.
[[nodiscard]] bool is_quicker(const MeasuredKnob& knob, const MeasuredLevel& a, const MeasuredLevel& b);

/// Fills in what follows from times and errors: dominated levels and laws. A knob with one level has neither.
void judge(const KnobFacts& facts, MeasuredKnob& knob);

/// The quickest level on offer whose trusted error keeps to the target; null where none does.
[[nodiscard]] const MeasuredLevel* cheapest_for(const MeasuredKnob& knob, double target_error);

}  // namespace tedavis::host_sim
