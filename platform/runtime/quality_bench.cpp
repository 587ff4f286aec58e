#include "platform/runtime/quality_bench.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render_core/design/mean_color_difference.hpp"

namespace tedavis::platform {
namespace {

using effects::Effect;
using effects::EffectSet;
using effects::QualityCandidate;
using effects::QualityCandidates;
using effects::QualityLevel;

constexpr double kLevelTauFactors[] = {1, 1.6, 2.5, 4};
constexpr double kDetailFactors[] = {1, 0.5, 0.2};
constexpr std::size_t kGivingUpSteps = 3;  // from nothing to everything that may be given up

/// As exact as the file states it, so that what is read back compares alike.
double as_stated(double value) { return std::round(value * 1e4) / 1e4; }

double saved_ms(base::Span<const effects::MeasuredCost> costs, Effect effect) {
    for (const effects::MeasuredCost& cost : costs)
        if (cost.name.view() == effects::row_of(effect).name) return cost.ms;
    return 0;
}

bool has_run(const display::FrameRecord& record, Effect effect) {
    return std::any_of(record.effects.begin(), record.effects.end(), [&](const display::EffectRecord& noted) {
        return noted.name.view() == effects::row_of(effect).name && noted.state == display::EffectState::run;
    });
}

/// What is given up, from nothing on, each with what comes before.
using GivenUp = base::FixedVector<EffectSet, kGivingUpSteps + 1>;
GivenUp given_up_steps(base::Span<const Effect> order) {
    GivenUp given_up;
    EffectSet effects;
    static_cast<void>(given_up.try_push_back(effects));
    std::size_t count = 0;
    for (std::size_t step = 1; step <= kGivingUpSteps; ++step) {
        const std::size_t end = (order.size() * step + kGivingUpSteps - 1) / kGivingUpSteps;
        if (end == count) continue;
        for (; count < end; ++count) effects.add(order[count]);
        static_cast<void>(given_up.try_push_back(effects));
    }
    return given_up;
}

/// All combinations, the design's own picture first.
void combine(const GivenUp& given_up, QualityCandidates& candidates) {
    static_assert(std::size(kLevelTauFactors) * std::size(kDetailFactors) * (kGivingUpSteps + 1) ==
                  effects::kMaxQualityCandidates);
    static_assert(std::size(kLevelTauFactors) <= BenchFrames::kMaxDisplays);
    candidates.clear();
    for (const double tau : kLevelTauFactors)
        for (const double detail : kDetailFactors)
            for (const EffectSet& effects : given_up)
                static_cast<void>(candidates.try_push_back({{tau, detail, effects, 0, 0, 0}, 0}));
}

}  // namespace

bool QualityBench::comes_before(const Embellishment& a, const Embellishment& b) {
    if (a.error_color <= 0 || b.error_color <= 0) return a.error_color <= 0 && (b.error_color > 0 || a.ms > b.ms);
    return a.ms * b.error_color > b.ms * a.error_color;
}

/// As large as the pictures of the displays that are open.
base::Error QualityBench::reserve_pictures() {
    if (!own_.empty()) return {};
    const base::Surface& surface = frames_.surface(0);
    const std::size_t bytes = std::size_t{4} * surface.width() * surface.height();
    auto reserved = reserve_memory(2 * bytes, Residency::lazy);
    if (!reserved.ok()) return reserved.error();
    reservation_ = std::move(reserved.value());
    base::Arena arena = reservation_.arena();
    auto* const first = static_cast<std::uint8_t*>(arena.allocate(2 * bytes, 1));
    own_ = {first, bytes};
    other_ = {first + bytes, bytes};
    return {};
}

base::Error QualityBench::add_contribution(Embellishment& one) {
    double ms = 0;
    one.runs = true;
    frames_.level(0)->given_up = {};
    frames_.level(0)->given_up.add(one.effect);
    if (!frames_.draw(0, 0, ms, other_)) return frames_.fault();
    one.error_color += share() * design::mean_color_difference(own_, other_);
    return {};
}

/// Adds what each effect that runs in the picture contributes to it.
base::Error QualityBench::add_contributions(Embellishments& all) {
    frames_.close();
    if (base::Error error = frames_.open(picture_, QualityLevel())) return error;
    if (base::Error error = reserve_pictures()) return error;
    double ms = 0;
    if (!frames_.draw(0, 0, ms, own_)) return frames_.fault();
    const display::FrameRecord record = frames_.display(0).record();
    for (Embellishment& one : all)
        if (has_run(record, one.effect))
            if (base::Error error = add_contribution(one)) return error;
    return {};
}

/// Leaves those that run in a picture, in the order in which they are given up.
base::Error QualityBench::find_order(base::Span<const effects::MeasuredCost> costs, Embellishments& all) {
    Embellishments every;
    for (std::size_t n = 0; n < effects::kEffectCount; ++n) {
        const auto effect = static_cast<Effect>(n);
        if (effects::row_of(effect).may_be_given_up)
            static_cast<void>(every.try_push_back({effect, false, saved_ms(costs, effect), 0}));
    }
    for (std::size_t n = 0; n < displays_.quality_pictures(); ++n) {
        displays_.quality_picture(n, picture_);
        if (base::Error error = add_contributions(every)) return error;
    }
    for (const Embellishment& one : every)
        if (one.runs) static_cast<void>(all.try_push_back(one));
    for (std::size_t n = 1; n < all.size(); ++n)
        for (std::size_t at = n; at > 0 && comes_before(all[at], all[at - 1]); --at) std::swap(all[at], all[at - 1]);
    return {};
}

/// One display for each error of the terrain, which its levels share.
base::Error QualityBench::open_sides(const QualityCandidates& candidates) {
    frames_.close();
    for (std::size_t n = 0; n < candidates.size(); ++n) {
        const QualityLevel& level = candidates[n].level;
        if (n > 0 && candidates[n - 1].level.tau_factor == level.tau_factor)
            frames_.share({}, level);
        else if (base::Error error = frames_.open(picture_, level))
            return error;
    }
    return {};
}

base::Error QualityBench::add_candidate(std::size_t n, QualityCandidate& candidate) {
    double ms = 0;
    if (!frames_.draw(n, 0, ms, other_)) return frames_.fault();
    QualityLevel& level = candidate.level;
    level.ms += share() * frames_.median_ms(n);
    level.error_px = std::max(level.error_px, frames_.display(n).record().terrain.worst_error_px);
    level.error_color += share() * design::mean_color_difference(own_, other_);
    candidate.spread_ms += share() * frames_.cost_between(0, n).spread_ms;
    return {};
}

base::Error QualityBench::add_picture(QualityCandidates& candidates) {
    if (base::Error error = open_sides(candidates)) return error;
    double ms = 0;
    if (!frames_.take_times(rounds_) || !frames_.draw(0, 0, ms, own_)) return frames_.fault();
    for (std::size_t n = 0; n < candidates.size(); ++n)
        if (base::Error error = add_candidate(n, candidates[n])) return error;
    return {};
}

base::Error QualityBench::measure(base::Span<const effects::MeasuredCost> costs, QualityCandidates& candidates, std::size_t done,
                                  std::size_t total) {
    Embellishments given_up;
    if (base::Error error = find_order(costs, given_up)) return error;
    base::FixedVector<Effect, effects::kEffectCount> order;
    for (const Embellishment& one : given_up) static_cast<void>(order.try_push_back(one.effect));
    combine(given_up_steps({order.data(), order.size()}), candidates);
    for (std::size_t n = 0; n < displays_.quality_pictures(); ++n) {
        displays_.quality_picture(n, picture_);
        if (base::Error error = add_picture(candidates)) return error;
        displays_.progress(++done, total);
    }
    frames_.close();
    for (QualityCandidate& candidate : candidates) {
        QualityLevel& level = candidate.level;
        for (double* const value : {&level.ms, &level.error_px, &level.error_color}) *value = as_stated(*value);
    }
    return {};
}

}  // namespace tedavis::platform
