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
    if (facts.only_level) measured.only_level = facts.only_level->text();
    return measured;
}

/// Times by level: of each round, and of each sample of each round.
using RoundTimes = std::vector<std::vector<double>>;
struct MeasuredTimes {
    RoundTimes rounds, samples;
    std::vector<double> moments;  ///< of the level in the middle, in each round
};

double timed_ms(Knob& knob, std::size_t level, std::size_t sample, const MeasuringPlan& plan) {
    knob.prepare(level, sample);
    const double begun = plan.clock_ms();
    knob.run(level, sample);
    return plan.clock_ms() - begun;
}

/// One round of one level.
void take_round(Knob& knob, std::size_t level, const MeasuringPlan& plan, MeasuredTimes& times) {
    double all_ms = 0;
    for (std::size_t sample = 0; sample < knob.samples(); ++sample) {
        times.samples[level].push_back(timed_ms(knob, level, sample, plan));
        all_ms += times.samples[level].back();
    }
    times.rounds[level].push_back(all_ms);
}

/// The level that begins a round is the next one in each round, so each level begins about equally often.
MeasuredTimes time_rounds(Knob& knob, const MeasuringPlan& plan) {
    const std::size_t levels = knob.facts().levels.size(), rounds = std::max(plan.rounds, MeasuringPlan::kMinRounds);
    MeasuredTimes times{RoundTimes(levels), RoundTimes(levels), {}};
    const double begun = plan.clock_ms();
    for (std::size_t round = 0; round < rounds; ++round) {
        plan.progress(round, rounds);
        if (round >= MeasuringPlan::kMinRounds && plan.most_s > 0 && plan.clock_ms() - begun > plan.most_s * 1000) break;
        for (std::size_t n = 0; n < levels; ++n) take_round(knob, (n + round) % levels, plan, times);
        for (std::size_t n = 0; n < knob.moments(); ++n)
            times.moments.push_back(timed_ms(knob, levels / 2, knob.samples() + n, plan));
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

double dearest_of(const Knob& knob, const MeasuredTimes& times) {
    const double moment_ms = slowest_median(times.moments, knob.moments());
    const double sample_ms = slowest_median(times.samples[times.samples.size() / 2], knob.samples());
    return sample_ms > 0 ? std::max(1.0, moment_ms / sample_ms) : 1;
}

/// Times of each level and what follows from those of all.
void add_times(const Knob& knob, const MeasuredTimes& times, MeasuredKnob& measured) {
    std::vector<double> ratios;
    for (const std::vector<double>& samples : times.samples) {
        const std::vector<double> own = run_ratios(samples, knob.samples());
        ratios.insert(ratios.end(), own.begin(), own.end());
    }
    for (std::size_t n = 0; n < measured.levels.size(); ++n) {
        MeasuredLevel& level = measured.levels[n];
        level.ms = spread_of(times.rounds[n]);
        level.sample_ms = spread_of(times.samples[n]);
        const KeptTimes kept = kept_times(times.samples[n], knob.samples(), ratios);
        level.kept_ms = kept.of_95;
        level.kept_99_ms = kept.of_99;
    }
    measured.rounds = times.rounds.empty() ? 0 : times.rounds.front().size();
    measured.noise = noise_of(times.rounds);
    measured.moments = knob.moments();
    measured.dearest = dearest_of(knob, times);
}

/// Of the first level and of the most accurate one, where the first is worst; nothing for a knob that draws none.
std::optional<KnobPictures> pictures_of(Knob& knob, const std::vector<MeasuredLevel>& levels) {
    const MeasuredLevel& cheap = levels.front();
    const auto exact =
        std::min_element(levels.begin(), levels.end(), [](const auto& a, const auto& b) { return a.error.mean < b.error.mean; });
    if (!cheap.worst_pixel || exact == levels.begin()) return std::nullopt;
    const std::optional<RgbaPicture> first = knob.picture(0, cheap.worst_sample);
    if (!first) return std::nullopt;
    const std::optional<RgbaPicture> last = knob.picture(static_cast<std::size_t>(exact - levels.begin()), cheap.worst_sample);
    if (!last || first->width != last->width || first->height != last->height) return std::nullopt;
    KnobPictures pictures =
        compare_pictures(knob.facts().name.text(), view_of(*first), view_of(*last),
                         {cheap.worst_place, cheap.worst_command, cheap.worst_pixel->x, cheap.worst_pixel->y});
    std::vector<double> errors;
    std::vector<KnobPixel> pixels;
    knob.find_errors(0, cheap.worst_sample, errors);
    for (std::size_t n = 0; n < errors.size(); ++n) pixels.push_back(knob.pixel_of(cheap.worst_sample, n).value_or(KnobPixel{}));
    pictures.metric_map = {knob.facts().name.text() + "-metric.png",
                           encode_small_png(view_of(metric_map(errors, pixels, {first->width, first->height})))};
    pictures.metric = knob.facts().metric.text() + ", " + knob.facts().unit.text();
    pictures.metric_max = cheap.error.max;
    pictures.cheap_level = cheap.name;
    pictures.exact_level = exact->name;
    return pictures;
}

}  // namespace

MeasuredLevel level_errors(Knob& knob, std::size_t number) {
    const KnobLevel& level = knob.facts().levels[number];
    MeasuredLevel measured;
    measured.name = level.name.text();
    measured.amount = level.amount;
    measured.is_offered = number == 0 || !knob.facts().only_level;
    std::vector<double> all, errors;
    double worst = -1;
    for (std::size_t sample = 0; sample < knob.samples(); ++sample) {
        errors.clear();
        knob.find_errors(number, sample, errors);
        const auto greatest = std::max_element(errors.begin(), errors.end());
        if (greatest != errors.end() && *greatest > worst) {
            worst = *greatest;
            const auto error = static_cast<std::size_t>(greatest - errors.begin());
            measured.worst_place = knob.place_of(sample, error);
            measured.worst_command = knob.command(number, sample);
            measured.worst_sample = sample;
            measured.worst_pixel = knob.pixel_of(sample, error);
        }
        all.insert(all.end(), errors.begin(), errors.end());
    }
    measured.error = distribution_of(std::move(all));
    measured.options = knob.options(number);
    measured.bytes = knob.bytes(number);
    measured.build_ms = knob.build_ms(number);
    return measured;
}

MeasuredKnob measure_knob(Knob& knob, const MeasuringPlan& plan) {
    MeasuredKnob measured = described(knob.facts());
    measured.samples = knob.samples();
    for (std::size_t level = 0; level < knob.facts().levels.size(); ++level) {
        plan.progress(0, plan.rounds);
        measured.levels.push_back(level_errors(knob, level));
        if (measured.work) measured.work->counts.push_back(knob.work(level));
    }
    add_times(knob, time_rounds(knob, plan), measured);
    for (std::size_t level = 0; level < measured.levels.size(); ++level) {
        measured.levels[level].uploaded_bytes = knob.uploaded_bytes(level);
        measured.levels[level].proven = knob.proven(level);
    }
    measured.pictures = pictures_of(knob, measured.levels);
    judge(knob.facts(), measured);
    return measured;
}

}  // namespace tedavis::host_sim
