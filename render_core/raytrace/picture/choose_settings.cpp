#include "render_core/raytrace/picture/choose_settings.hpp"

#include <algorithm>

namespace tedavis::raytrace {
namespace {

constexpr float kMinCost = 1e-6f;  // of a step, ms: a better level that costs no more is taken first

}  // namespace

std::uint64_t SettingsChooser::bytes_needed(std::uint32_t regions) {
    return std::uint64_t{regions} * (TraceCosts::kMaxLevels - 1) * sizeof(Step) + alignof(Step);
}

bool SettingsChooser::start(std::uint32_t regions, base::Arena& arena) {
    steps_ = arena.allocate_array<Step>(std::size_t{regions} * (TraceCosts::kMaxLevels - 1));
    return regions > 0 && !steps_.empty();
}

std::uint32_t SettingsChooser::list_steps(base::Span<const RegionView> regions, const TraceCosts& costs,
                                          const ChoiceLimits& limits, base::Span<const std::uint8_t> last) {
    std::uint32_t count = 0;
    for (std::uint32_t n = 0; n < regions.size(); ++n) {
        float before = std::numeric_limits<float>::infinity();
        for (std::uint32_t level = 1; level < limits.levels; ++level) {
            Step step = {};
            step.region = n;
            step.level = static_cast<std::uint8_t>(level);
            step.is_new = level > last[n];
            step.cost = costs.of(level, regions[n].kind) - costs.of(level - 1, regions[n].kind);
            step.gain = regions[n].weight * (limits.error[level - 1] - limits.error[level]);
            const float counted = step.is_new ? step.gain : step.gain * (1 + limits.hysteresis);
            // No step is worth more than the one that must come before it.
            step.worth = before = std::min(before, counted / std::max(step.cost, kMinCost));
            if (step.gain > 0) steps_[count++] = step;
        }
    }
    return count;
}

Choice SettingsChooser::choose(base::Span<const RegionView> regions, const TraceCosts& costs, const ChoiceLimits& limits,
                               base::Span<std::uint8_t> levels) {
    TEDAVIS_CHECK(regions.size() == levels.size() && regions.size() * (TraceCosts::kMaxLevels - 1) <= steps_.size());
    TEDAVIS_CHECK(limits.levels > 0 && limits.levels <= TraceCosts::kMaxLevels);
    const std::uint32_t count = list_steps(regions, costs, limits, {levels.data(), levels.size()});
    std::sort(steps_.begin(), steps_.begin() + count, [](const Step& a, const Step& b) {
        if (a.worth != b.worth) return a.worth > b.worth;
        return a.region != b.region ? a.region < b.region : a.level < b.level;
    });
    Choice choice;
    double weights = 0;
    for (std::size_t n = 0; n < regions.size(); ++n) {
        levels[n] = 0;
        weights += double{regions[n].weight};
        choice.cost_ms += double{costs.of(0, regions[n].kind)};
        choice.error += double{regions[n].weight} * double{limits.error[0]};
    }
    const double scale = weights > 0 ? 1 / weights : 0, deadline = limits.deadline_ms;
    choice.keeps_deadline = deadline <= 0 || choice.cost_ms <= deadline;
    for (std::uint32_t n = 0; n < count; ++n) {
        const Step& step = steps_[n];
        if (limits.most_error > 0 && choice.error * scale <= double{limits.most_error}) break;
        const double room = step.is_new ? deadline * (1 - double{limits.hysteresis}) : deadline;
        if (deadline > 0 && choice.cost_ms + double{step.cost} > room) continue;
        if (levels[step.region] + 1u != step.level) continue;
        levels[step.region] = step.level;
        choice.cost_ms += double{step.cost};
        choice.error -= double{step.gain};
    }
    choice.error = std::max(choice.error * scale, 0.0);
    return choice;
}

}  // namespace tedavis::raytrace
