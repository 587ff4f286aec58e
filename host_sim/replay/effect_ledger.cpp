#include "host_sim/replay/effect_ledger.hpp"

#include <algorithm>

#include "platform/clock/monotonic_clock.hpp"
#include "render_core/display/preroll.hpp"
#include "render_core/effects/design_effects.hpp"
#include "render_core/effects/effect_requests.hpp"

namespace tedavis::host_sim {
namespace {

using display::EffectState;
using effects::Effect;

constexpr int kLedgerRounds = 3, kLedgerWarmUp = 1;  // frames of each side and sample; those that are not counted

Effect effect_named(std::string_view name) {
    for (std::size_t n = 0; n < effects::kEffectCount; ++n)
        if (effects::row_of(static_cast<Effect>(n)).name == name) return static_cast<Effect>(n);
    return Effect::count_;
}

/// Draws samples, and keeps how long it took.
class Side {
public:
    Side(const PictureOptions& options, bool generated_flight) : session_(options, generated_flight) { session_.rest(); }

    void settle(const LedgerSample& sample) {
        session_.make_current();
        display::settle(session_.display(), {sample.aircraft, sample.phase, sample.time});
        session_.rest();
    }
    [[nodiscard]] double draw_ms(const LedgerSample& sample) {
        session_.make_current();
        const base::Time start = platform::monotonic_now();
        session_.display().plan({sample.aircraft, sample.phase, sample.time, &sample.way, sample.legend});
        session_.draw();
        const double ms = (platform::monotonic_now() - start).to_seconds() * 1000;
        session_.rest();
        return ms;
    }
    [[nodiscard]] RgbaView pixels() const { return session_.pixels(); }

private:
    DisplaySession session_;
};

/// Adds samples up to a price.
class Comparison {
public:
    Comparison(const PictureOptions& intended, const PictureOptions& shown, bool generated_flight)
        : intended_(intended, generated_flight), shown_(shown, generated_flight) {}

    /// The frame as the run showed it instead of as the second side draws it, where given.
    void add(const LedgerSample& sample, bool as_the_run_showed_it) {
        intended_.settle(sample);
        shown_.settle(sample);
        for (int n = 0; n < kLedgerRounds + kLedgerWarmUp; ++n) {
            const double intended_ms = intended_.draw_ms(sample), shown_ms = shown_.draw_ms(sample);
            if (n < kLedgerWarmUp) continue;
            intended_ms_.push_back(intended_ms);
            shown_ms_.push_back(shown_ms);
        }
        const RgbaView shown = as_the_run_showed_it ? view_of(sample.shown) : shown_.pixels();
        const PictureDifference difference = picture_difference(intended_.pixels(), shown);
        price_.difference.mean += difference.mean;
        price_.difference.edges += difference.edges;
        price_.difference.largest = std::max(price_.difference.largest, difference.largest);
        if (samples_++ > 0 && difference.mean <= worst_mean_) return;
        worst_mean_ = difference.mean;
        price_.worst_frame = sample.frame;
        price_.intended = upright(intended_.pixels());
        price_.shown = upright(shown);
    }
    [[nodiscard]] LedgerPrice price() {
        price_.saved = paired_cost(intended_ms_, shown_ms_);
        price_.difference.mean /= samples_;
        price_.difference.edges /= samples_;
        return std::move(price_);
    }

private:
    Side intended_, shown_;
    std::vector<double> intended_ms_, shown_ms_;
    LedgerPrice price_;
    double worst_mean_ = 0;
    int samples_ = 0;
};

}  // namespace

bool EffectLedger::wants(std::uint64_t n) const {
    if (frames_ <= kLedgerSamples) return true;
    for (std::uint64_t k = 0; k < kLedgerSamples; ++k)
        if (n == k * (frames_ - 1) / (kLedgerSamples - 1)) return true;
    return false;
}

void EffectLedger::note(const display::FrameRecord& record) {
    for (const display::EffectRecord& effect : record.effects) {
        if (effect.state == EffectState::run || effect.reason.view() == effects::kRemovedByPolicy) continue;
        std::vector<LedgerFate>& fates = fates_[effect_named(effect.name.view())];
        const auto same = std::find_if(fates.begin(), fates.end(), [&](const LedgerFate& fate) {
            return fate.state == effect.state && fate.replaced_by == effect.replaced_by.view() &&
                   fate.reason == effect.reason.view();
        });
        if (same == fates.end())
            fates.push_back({effect.state, std::string(effect.replaced_by.view()), std::string(effect.reason.view()), 1});
        else
            ++same->frames;
    }
}

/// Everything that the design asks for, seen or not, in the size and with the terrain error of the run.
PictureOptions EffectLedger::intended() const {
    PictureOptions options = options_;
    options.device = kLedgerReference;
    options.force_effects = true;
    options.deadline_ms.reset();
    options.costs.clear();
    return options;
}

LedgerPrice EffectLedger::price_of(Effect effect, const std::function<void()>& between) const {
    PictureOptions without = intended();
    without.forbidden.add(effect);
    Comparison comparison(intended(), without, generated_flight_);
    for (const LedgerSample& sample : samples_) {
        comparison.add(sample, false);
        between();
    }
    return comparison.price();
}

LedgerPrice EffectLedger::price_of_all(const std::function<void()>& between) const {
    Comparison comparison(intended(), options_, generated_flight_);
    for (const LedgerSample& sample : samples_) {
        comparison.add(sample, true);
        between();
    }
    return comparison.price();
}

std::vector<LedgerPrice> EffectLedger::prices(const std::function<void(std::size_t, std::size_t)>& progress) const {
    std::vector<LedgerPrice> prices;
    if (samples_.empty()) return prices;
    const std::size_t total = fates_.size() + 1;
    const auto between = [&] { progress(prices.size(), total); };
    between();
    for (const auto& [effect, fates] : fates_) {
        prices.push_back(price_of(effect, between));
        prices.back().effect = effects::row_of(effect).name;
        prices.back().fates = fates;
        progress(prices.size(), total);
    }
    prices.push_back(price_of_all(between));
    progress(total, total);
    return prices;
}

}  // namespace tedavis::host_sim
