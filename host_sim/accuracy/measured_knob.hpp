/// The measurements of a knob: times with their spread, errors with their distribution, and the laws derived from them.
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
    TimeSpread ms;                 ///< of one run over all samples
    TimeSpread sample_ms;          ///< of one sample, over all samples and rounds
    double kept_ms = 0;            ///< time that 95 of 100 runs of its slowest sample do not exceed; see kept_times()
    double kept_99_ms = 0;         ///< time that 99 of 100 runs do not exceed
    std::string options;           ///< options of `tedavis replay` that give the level; may be empty
    ErrorDistribution error;       ///< in the metric's unit
    std::optional<double> proven;  ///< the greatest error that the product states for its frames, in the same unit
    std::uint64_t bytes = 0;
    std::optional<std::uint64_t> uploaded_bytes;  ///< per frame, to the GPU
    double build_ms = 0;
    std::string worst_place;    ///< where the greatest error is
    std::string worst_command;  ///< command that reproduces it
    std::size_t worst_sample = 0;
    std::optional<KnobPixel> worst_pixel;  ///< of knobs that draw pictures
    bool is_dominated = false;             ///< another level is more accurate and no slower, or as accurate and quicker
    bool is_near_reference = false;        ///< its greatest error is less than ten times the reference's own bound
    bool is_offered = true;                ///< the product offers the level; false: an alternative to its only level

    /// The error that the level is trusted not to exceed: the larger of the greatest measured error and, if there is one, the
    /// proven error.
    [[nodiscard]] double trusted_error() const { return proven && *proven > error.max ? *proven : error.max; }
};

/// The number of things that the levels process (KnobFacts::work).
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
    /// The greatest ratio, less 1, between the medians of the odd and of the even rounds of a level.
    double noise = 0;
    std::size_t moments = 0;  ///< number of moments that were timed beside the samples
    /// Ratio of the slowest moment's time to that of the slowest sample, medians at one level; 1 or more.
    double dearest = 1;
    std::vector<MeasuredLevel> levels;  ///< in the order of the knob
    std::string only_level;             ///< why the product offers only the first level; empty: it offers all
    FittedLaw error_law, time_law;      ///< over the amount: mean error, median time
    std::string law_expected;           ///< in words; empty: none is known
    bool law_agrees = false;            ///< the law agrees with the expected one
    std::optional<MeasuredWork> work;
    std::optional<KnobPictures> pictures;

    [[nodiscard]] bool has_one_level() const { return !only_level.empty(); }
};

/// True if level `a` is quicker than `b` by more than the noise.
[[nodiscard]] bool is_quicker(const MeasuredKnob& knob, const MeasuredLevel& a, const MeasuredLevel& b);

/// Computes dominated levels and laws from times and errors. A knob with one level has neither.
void judge(const KnobFacts& facts, MeasuredKnob& knob);

/// The quickest offered level whose trusted error is at most the target; null where there is none.
[[nodiscard]] const MeasuredLevel* cheapest_for(const MeasuredKnob& knob, double target_error);

}  // namespace tedavis::host_sim
