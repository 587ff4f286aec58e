#include "host_sim/accuracy/uncalled_effects.hpp"

#include <algorithm>
#include <cstdlib>

#include "host_sim/accuracy/knobs/flown_pictures.hpp"
#include "host_sim/replay/load_design.hpp"
#include "platform/clock/monotonic_clock.hpp"
#include "render_core/effects/design_effects.hpp"

namespace tedavis::host_sim {
namespace {

using display::EffectRecord;
using display::EffectState;
using effects::Effect;

enum Side : std::size_t { kCalled, kForced };

std::uint32_t largest_channel_difference(const RgbaView& a, const RgbaView& b) {
    int largest = 0;
    for (std::uint32_t y = 0; y < a.height; ++y) {
        const std::uint8_t *const p = a.row(y), *const q = b.row(y);
        for (std::size_t n = 0; n < std::size_t{a.width} * 4; ++n) largest = std::max(largest, std::abs(p[n] - q[n]));
    }
    return static_cast<std::uint32_t>(largest);
}

/// One effect over all poses.
class EffectFlight {
public:
    EffectFlight(const PictureOptions& options, Effect effect, const std::vector<AircraftPose>& poses)
        : pictures_(sides(options, effect), poses) {
        use_.name = effects::row_of(effect).name;
        use_.contribution = effects::kContributionNames[static_cast<std::size_t>(effects::row_of(effect).contribution)];
    }

    [[nodiscard]] EffectUse use(std::size_t rounds) {
        for (std::size_t pose = 0; pose < pictures_.poses().size(); ++pose)
            if (const EffectRecord* const record = record_of(pose)) count(*record, pose, rounds);
        use_.saved = paired_cost(forced_ms_, called_ms_);
        return use_;
    }

private:
    static std::vector<FlownLevel> sides(PictureOptions options, Effect effect) {
        FlownLevel called, forced;
        options.with.add(effect);
        called.picture = options;
        options.force_effects = true;
        forced.picture = options;
        return {called, forced};
    }

    /// Null where the frame did not ask for it.
    [[nodiscard]] const EffectRecord* record_of(std::size_t pose) {
        for (const EffectRecord& record : pictures_.display(kCalled, pose).record().effects)
            if (record.name.view() == use_.name) return &record;
        return nullptr;
    }

    void count(const EffectRecord& record, std::size_t pose, std::size_t rounds) {
        use_.add(record);
        if (record.state == EffectState::run) return;
        for (std::size_t round = 0; round < rounds; ++round) {
            forced_ms_.push_back(drawn_ms(kForced, pose));
            called_ms_.push_back(drawn_ms(kCalled, pose));
        }
        if (record.state == EffectState::skipped) compare(pose);
    }

    void compare(std::size_t pose) {
        const std::uint32_t difference =
            largest_channel_difference(pictures_.picture(kCalled, pose), pictures_.picture(kForced, pose));
        if (difference <= use_.largest_difference) return;
        use_.largest_difference = difference;
        use_.worst_pose = pose_text(pictures_.poses()[pose]) + phase_option(pictures_.poses()[pose]);
    }

    [[nodiscard]] double drawn_ms(std::size_t side, std::size_t pose) {
        pictures_.show(side, pose);
        const base::Time begun = platform::monotonic_now();
        pictures_.draw(side, pose);
        return (platform::monotonic_now() - begun).to_seconds() * 1000;
    }

    FlownPictures pictures_;
    EffectUse use_;
    std::vector<double> called_ms_, forced_ms_;
};

/// The effects that a design can be made to ask for, and those that it asks for.
std::vector<Effect> askable(const PictureOptions& options) {
    const effects::EffectSet asked = effects::asked_effects(load_design(options));
    std::vector<Effect> all;
    for (std::size_t n = 0; n < effects::kEffectCount; ++n) {
        const auto effect = static_cast<Effect>(n);
        if (asked.has(effect) || effects::row_of(effect).ask != nullptr) all.push_back(effect);
    }
    return all;
}

}  // namespace

bool EffectUse::keeps_promise() const {
    constexpr std::uint32_t kOneStep = 1;
    return skipped_work == 0 && (contribution != "color" || largest_difference <= kOneStep);
}

bool UncalledEffects::keep_promise() const {
    return std::all_of(uses.begin(), uses.end(), [](const EffectUse& use) { return use.keeps_promise(); });
}

UncalledEffects measure_uncalled(const KnobFlight& flight, const PictureOptions& options, const UncalledPlan& plan) {
    UncalledEffects measured;
    measured.design = options.design;
    measured.device = options.device;
    const std::vector<AircraftPose> poses = flight.poses(plan.poses);
    measured.frames = poses.size();
    const std::vector<Effect> all = plan.only.empty() ? askable(options) : plan.only;
    for (std::size_t n = 0; n < all.size(); ++n) {
        plan.progress(n, all.size());
        measured.uses.push_back(EffectFlight(options, all[n], poses).use(plan.rounds));
    }
    return measured;
}

}  // namespace tedavis::host_sim
