/// A knob whose errors and times are made up, and a clock that only its work moves.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/accuracy/accuracy_report.hpp"
#include "host_sim/accuracy/measure_knob.hpp"

namespace tedavis::test_support {

inline host_sim::KnobFacts made_facts(std::vector<host_sim::KnobLevel> levels) {
    return {"made",
            "A made-up knob",
            "nowhere",
            "distance",
            "m",
            {"the truth", 1e-9, "it is made up"},
            "none: there is only one truth",
            "nothing",
            "steps",
            host_sim::ExpectedLaw{-1, 0.1, "made up"},
            std::move(levels),
            std::nullopt,
            host_sim::KnobWork{"steps taken", {1, 0.1, "made up"}}};
}

/// Level n has 2^n steps: errors are 1 / steps and half of it, and a sample takes steps milliseconds.
class MadeKnob final : public host_sim::Knob {
public:
    explicit MadeKnob(std::size_t levels) : Knob(made_facts(levels_of(levels))) {}
    explicit MadeKnob(host_sim::KnobFacts facts) : Knob(std::move(facts)) {}

    [[nodiscard]] std::size_t samples() const override { return 3; }
    void prepare(std::size_t, std::size_t) override { now_ms += preparation_ms; }
    [[nodiscard]] std::size_t moments() const override { return moment_times.size(); }
    void run(std::size_t level, std::size_t sample) override {
        if (sample >= samples()) {
            now_ms += steps(level) * moment_times[sample - samples()];
            return;
        }
        runs.emplace_back(level, sample);
        now_ms += steps(level) * slowness(runs.size() / (samples() * facts().levels.size()));
    }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        errors = {0.5 / steps(level), (sample == 1 ? 1.0 : 0.75) / steps(level)};
    }
    [[nodiscard]] double work(std::size_t level) const override { return steps(level); }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        return "sample " + std::to_string(sample) + ", error " + std::to_string(error);
    }

    [[nodiscard]] host_sim::MeasuringPlan plan(std::size_t rounds) {
        host_sim::MeasuringPlan plan;
        plan.rounds = rounds;
        plan.clock_ms = [this] { return now_ms; };
        plan.progress = [](std::size_t, std::size_t) {};
        return plan;
    }

    double now_ms = 0, preparation_ms = 0;
    std::vector<double> moment_times;  ///< over those of samples
    std::vector<std::pair<std::size_t, std::size_t>> runs;
    std::function<double(std::size_t round)> slowness = [](std::size_t) { return 1.0; };

private:
    static double steps(std::size_t level) { return std::ldexp(1.0, static_cast<int>(level)); }
    static std::vector<host_sim::KnobLevel> levels_of(std::size_t count) {
        std::vector<host_sim::KnobLevel> levels;
        for (std::size_t n = 0; n < count; ++n) levels.push_back({std::to_string(1u << n) + " steps", steps(n)});
        return levels;
    }
};

/// Levels of which the product has the first only.
inline host_sim::KnobFacts made_facts_of_one_level(std::vector<host_sim::KnobLevel> levels) {
    host_sim::KnobFacts facts = made_facts(std::move(levels));
    facts.name = "alone";
    facts.title = "A made-up setting with one level";
    facts.law = std::nullopt;
    facts.work = std::nullopt;
    facts.only_level = "one is enough";
    return facts;
}

/// Of a knob whose alternatives are more accurate and slower.
inline host_sim::MeasuredKnob made_knob_of_one_level() {
    MadeKnob knob(made_facts_of_one_level({{"ours", 0}, {"finer", 0}, {"finest", 0}}));
    return host_sim::measure_knob(knob, knob.plan(7));
}

/// Of one made-up knob, measured quickly and whole.
inline host_sim::AccuracyReport made_report() {
    MadeKnob knob(5);
    host_sim::AccuracyReport report;
    host_sim::MeasuredInputs inputs;
    inputs.terrain = "alps.tdb";
    inputs.terrain_identity = 7;
    inputs.size = "640 x 360";
    inputs.device = "es3-mid";
    inputs.design = "default";
    inputs.is_quick = true;
    report.conditions = host_sim::conditions_now("tedavis accuracy -o x", "a renderer", inputs);
    report.knobs.push_back(host_sim::measure_knob(knob, knob.plan(7)));
    return report;
}

}  // namespace tedavis::test_support
