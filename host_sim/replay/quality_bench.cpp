#include "host_sim/replay/quality_bench.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/measure/paired_cost.hpp"
#include "host_sim/measure/picture_difference.hpp"

namespace tedavis::host_sim {
namespace {

using effects::Effect;
using effects::EffectSet;
using effects::QualityLevel;

constexpr double kLevelTauFactors[] = {1, 1.6, 2.5, 4};
constexpr double kDetailFactors[] = {1, 0.5, 0.2};
constexpr std::size_t kGivingUpSteps = 3;  // from nothing to everything that may be given up
constexpr double kPictureShare = 1.0 / QualityBench::kPictures;

/// As exact as the file states it, so that what is read back compares alike.
double as_stated(double value) { return std::round(value * 1e4) / 1e4; }

double saved_ms(const std::vector<MeasuredCost>& costs, Effect effect) {
    for (const MeasuredCost& cost : costs)
        if (cost.name == effects::row_of(effect).name) return cost.ms;
    return 0;
}

bool runs(const display::FrameRecord& record, Effect effect) {
    return std::any_of(record.effects.begin(), record.effects.end(), [&](const display::EffectRecord& noted) {
        return noted.name.view() == effects::row_of(effect).name && noted.state == display::EffectState::run;
    });
}

/// A picture of the place at a level, bottom row first.
struct LevelPicture {
    std::vector<std::uint8_t> bytes;
    std::uint32_t width = 0, height = 0;
    double error_px = 0;
    [[nodiscard]] RgbaView view() const { return {bytes.data(), width, height, true}; }
};

LevelPicture level_picture(const BenchPlace& place, BenchSide& side) {
    static_cast<void>(bench_frame_ms(place, side, 0));
    const RgbaView pixels = side.session->pixels();
    LevelPicture picture;
    picture.width = side.session->width();
    picture.height = side.session->height();
    picture.bytes.assign(pixels.pixels, pixels.pixels + std::size_t{4} * picture.width * picture.height);
    picture.error_px = side.session->display().record().terrain.worst_error_px;
    return picture;
}

/// What giving an effect up saves, and how much of the pictures it changes.
struct Embellishment {
    Effect effect = Effect::count_;
    bool runs = false;
    double ms = 0, error_color = 0;
};

/// Adds what each effect that runs in a picture contributes to it.
void add_contributions(const BenchPlace& place, const PictureOptions& options, std::vector<Embellishment>& all) {
    BenchSide side = open_bench_side(place, options, QualityLevel());
    const LevelPicture own = level_picture(place, side);
    const display::FrameRecord record = side.session->display().record();
    for (Embellishment& one : all) {
        if (!runs(record, one.effect)) continue;
        one.runs = true;
        side.level->given_up = {};
        side.level->given_up.add(one.effect);
        one.error_color += kPictureShare * picture_difference(own.view(), level_picture(place, side).view()).mean;
    }
}

/// All combinations, the design's own picture first.
std::vector<QualityCandidate> combinations(const std::vector<Effect>& order) {
    std::vector<EffectSet> given_up{EffectSet()};
    std::size_t count = 0;
    for (std::size_t step = 1; step <= kGivingUpSteps; ++step) {
        EffectSet effects = given_up.back();
        const std::size_t end = (order.size() * step + kGivingUpSteps - 1) / kGivingUpSteps;
        if (end == count) continue;
        for (; count < end; ++count) effects.add(order[count]);
        given_up.push_back(effects);
    }
    std::vector<QualityCandidate> candidates;
    for (const double tau : kLevelTauFactors)
        for (const double detail : kDetailFactors)
            for (const EffectSet& effects : given_up) candidates.push_back({{tau, detail, effects, 0, 0, 0}, 0});
    return candidates;
}

}  // namespace

std::vector<PictureOptions> QualityBench::pictures() const {
    PictureOptions embellished = place_.picture, glyphs = place_.picture, focus = place_.picture, saliency = place_.picture;
    for (std::size_t n = 0; n < effects::kEffectCount; ++n) {
        const effects::EffectRow& row = effects::row_of(static_cast<Effect>(n));
        if (row.may_be_given_up && row.contribution != effects::Contribution::content) embellished.with.add(row.effect);
    }
    glyphs.design = "data/wind_arrows";
    focus.design = "focus/blur";
    saliency.with.add(Effect::saliency);
    return {embellished, glyphs, focus, saliency};
}

std::vector<Effect> QualityBench::given_up_order(const std::vector<MeasuredCost>& costs) const {
    std::vector<Embellishment> all;
    for (std::size_t n = 0; n < effects::kEffectCount; ++n) {
        const auto effect = static_cast<Effect>(n);
        if (effects::row_of(effect).may_be_given_up) all.push_back({effect, false, saved_ms(costs, effect), 0});
    }
    for (const PictureOptions& picture : pictures()) add_contributions(place_, picture, all);
    std::stable_sort(all.begin(), all.end(), [](const Embellishment& one, const Embellishment& other) {
        return one.ms * other.error_color > other.ms * one.error_color;
    });
    std::vector<Effect> order;
    for (const Embellishment& one : all)
        if (one.runs) order.push_back(one.effect);
    return order;
}

/// One display for each error of the terrain, which its levels share.
void QualityBench::add_picture(const PictureOptions& picture, std::vector<QualityCandidate>& candidates) const {
    std::vector<BenchSide> sides;
    for (const QualityCandidate& candidate : candidates) {
        const bool is_shared = !sides.empty() && sides.back().level->tau_factor == candidate.level.tau_factor;
        if (is_shared)
            sides.push_back({sides.back().session, {}, candidate.level});
        else
            sides.push_back(open_bench_side(place_, picture, candidate.level));
    }
    const std::vector<std::vector<double>> ms = bench_frames_ms(place_, sides, rounds_);
    const LevelPicture own = level_picture(place_, sides.front());
    for (std::size_t n = 0; n < sides.size(); ++n) {
        const LevelPicture drawn = level_picture(place_, sides[n]);
        QualityLevel& level = candidates[n].level;
        level.ms += kPictureShare * median_of(ms[n]);
        level.error_px = std::max(level.error_px, drawn.error_px);
        level.error_color += kPictureShare * picture_difference(own.view(), drawn.view()).mean;
        candidates[n].spread_ms += kPictureShare * paired_cost(ms.front(), ms[n]).spread_ms;
    }
}

std::vector<QualityCandidate> QualityBench::measure(const std::vector<MeasuredCost>& costs,
                                                    const std::function<void()>& progress) const {
    std::vector<QualityCandidate> candidates = combinations(given_up_order(costs));
    for (const PictureOptions& picture : pictures()) {
        add_picture(picture, candidates);
        progress();
    }
    for (QualityCandidate& candidate : candidates) {
        QualityLevel& level = candidate.level;
        for (double* const value : {&level.ms, &level.error_px, &level.error_color}) *value = as_stated(*value);
    }
    return candidates;
}

}  // namespace tedavis::host_sim
