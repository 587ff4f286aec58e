#include "host_sim/accuracy/measure_knob.hpp"

#include <algorithm>

namespace tedavis::host_sim {
namespace {

MeasuredKnob described(const KnobFacts& facts) {
    MeasuredKnob measured;
    measured.name = facts.name.text();
    measured.title = facts.title.text();
    measured.setting = facts.setting.text();
    measured.metric = facts.metric.text();
    measured.unit = facts.unit.text();
    measured.amount = facts.amount.text();
    measured.reference = facts.reference.what();
    measured.reference_reason = facts.reference.reason();
    measured.reference_bound = facts.reference.error_bound();
    measured.second_oracle = facts.second_oracle.text();
    measured.never_trades = facts.never_trades.text();
    if (facts.work) measured.work.emplace().thing = facts.work->thing.text();
    return measured;
}

MeasuredLevel errors_of(Knob& knob, std::size_t number) {
    const KnobLevel& level = knob.facts().levels[number];
    MeasuredLevel measured;
    measured.name = level.name.text();
    measured.amount = level.amount;
    std::vector<double> all, errors;
    double worst = -1;
    for (std::size_t sample = 0; sample < knob.samples(); ++sample) {
        errors.clear();
        knob.find_errors(number, sample, errors);
        const auto greatest = std::max_element(errors.begin(), errors.end());
        if (greatest != errors.end() && *greatest > worst) {
            worst = *greatest;
            measured.worst_place = knob.place_of(sample, static_cast<std::size_t>(greatest - errors.begin()));
        }
        all.insert(all.end(), errors.begin(), errors.end());
    }
    measured.error = distribution_of(std::move(all));
    measured.bytes = knob.bytes(number);
    measured.build_ms = knob.build_ms(number);
    return measured;
}

double run_ms(Knob& knob, std::size_t level, const MeasuringPlan& plan) {
    double ms = 0;
    for (std::size_t sample = 0; sample < knob.samples(); ++sample) {
        knob.prepare(level, sample);
        const double begun = plan.clock_ms();
        knob.run(level, sample);
        ms += plan.clock_ms() - begun;
    }
    return ms;
}

/// Times of the rounds, by level.
using RoundTimes = std::vector<std::vector<double>>;

/// The level that begins a round is the next one in each round, so each level begins about equally often.
RoundTimes time_rounds(Knob& knob, const MeasuringPlan& plan) {
    const std::size_t levels = knob.facts().levels.size(), rounds = std::max(plan.rounds, MeasuringPlan::kMinRounds);
    RoundTimes times(levels);
    const double begun = plan.clock_ms();
    for (std::size_t round = 0; round < rounds; ++round) {
        plan.progress(round, rounds);
        if (round >= MeasuringPlan::kMinRounds && plan.most_s > 0 && plan.clock_ms() - begun > plan.most_s * 1000) break;
        for (std::size_t n = 0; n < levels; ++n) {
            const std::size_t level = (n + round) % levels;
            times[level].push_back(run_ms(knob, level, plan));
        }
    }
    return times;
}

/// Of every second round, from the first or the second one on.
double half_median(const std::vector<double>& times, std::size_t first) {
    std::vector<double> half;
    for (std::size_t n = first; n < times.size(); n += 2) half.push_back(times[n]);
    return spread_of(std::move(half)).median;
}

double noise_of(const RoundTimes& times) {
    double noise = 0;
    for (const std::vector<double>& level : times) {
        const double a = half_median(level, 0), b = half_median(level, 1);
        if (a > 0 && b > 0) noise = std::max(noise, std::max(a, b) / std::min(a, b) - 1);
    }
    return noise;
}

}  // namespace

MeasuredKnob measure_knob(Knob& knob, const MeasuringPlan& plan) {
    MeasuredKnob measured = described(knob.facts());
    measured.samples = knob.samples();
    for (std::size_t level = 0; level < knob.facts().levels.size(); ++level) {
        plan.progress(0, plan.rounds);
        measured.levels.push_back(errors_of(knob, level));
        if (measured.work) measured.work->counts.push_back(knob.work(level));
    }
    const RoundTimes times = time_rounds(knob, plan);
    for (std::size_t level = 0; level < times.size(); ++level) measured.levels[level].ms = spread_of(times[level]);
    measured.rounds = times.empty() ? 0 : times.front().size();
    measured.noise = noise_of(times);
    judge(knob.facts(), measured);
    return measured;
}

}  // namespace tedavis::host_sim
