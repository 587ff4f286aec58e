#include "host_sim/comparison/run_comparison.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::host_sim {
namespace {

double median_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// On the runway everything is close to the ground.
bool counts_for_least(const ComparedFrame& frame, std::size_t quantity) {
    if (quantity != kHeightAboveTerrain && quantity != kClearance) return true;
    return knows_phase(frame) && frame.phase != "ground" && frame.phase != "takeoff.start" && frame.phase != "approach.landing";
}

void take_least(double value, std::size_t instant, bool counts, double& least, std::size_t& least_at) {
    if (!counts || least <= value) return;  // the first value is compared with NaN
    least = value;
    least_at = instant;
}

std::optional<QuantityDifference> difference_of(const RunComparison& runs, std::size_t quantity) {
    QuantityDifference found;
    found.quantity = quantity;
    std::vector<double> all_a, all_b;
    for (std::size_t n = 0; n < runs.aligned.instants.size(); ++n) {
        const double a = runs.value_a(n, quantity), b = runs.value_b(n, quantity);
        if (!std::isfinite(a) || !std::isfinite(b)) continue;
        take_least(a, n, counts_for_least(runs.frame_a(n), quantity), found.least_a, found.least_a_at);
        take_least(b, n, counts_for_least(runs.frame_b(n), quantity), found.least_b, found.least_b_at);
        if (all_a.empty() || std::abs(b - a) > std::abs(found.greatest)) found.greatest = b - a, found.greatest_at = n;
        all_a.push_back(a);
        all_b.push_back(b);
        found.mean_a += a;
        found.mean_b += b;
    }
    if (all_a.empty()) return std::nullopt;
    found.count = all_a.size();
    found.mean_a /= static_cast<double>(found.count);
    found.mean_b /= static_cast<double>(found.count);
    found.median_a = median_of(all_a);
    found.median_b = median_of(all_b);
    return found;
}

EffectDifference& effect_named(std::vector<EffectDifference>& effects, const std::string& name) {
    for (EffectDifference& effect : effects)
        if (effect.name == name) return effect;
    effects.push_back({name, 0, 0});
    return effects.back();
}

void count_effects(RunComparison& runs) {
    for (std::size_t n = 0; n < runs.aligned.instants.size(); ++n) {
        for (const std::string& name : runs.frame_a(n).effects) ++effect_named(runs.effects, name).instants_a;
        for (const std::string& name : runs.frame_b(n).effects) ++effect_named(runs.effects, name).instants_b;
    }
    const auto apart = [](const EffectDifference& effect) {
        return effect.instants_a > effect.instants_b ? effect.instants_a - effect.instants_b
                                                     : effect.instants_b - effect.instants_a;
    };
    std::stable_sort(runs.effects.begin(), runs.effects.end(),
                     [&](const EffectDifference& one, const EffectDifference& other) { return apart(one) > apart(other); });
}

void count_states(RunComparison& runs) {
    for (std::size_t n = 0; n < runs.aligned.instants.size(); ++n) {
        const ComparedFrame &a = runs.frame_a(n), &b = runs.frame_b(n);
        ++runs.terrain_a[static_cast<std::size_t>(a.terrain_alert)];
        ++runs.terrain_b[static_cast<std::size_t>(b.terrain_alert)];
        ++runs.obstacles_a[static_cast<std::size_t>(a.obstacle_alert)];
        ++runs.obstacles_b[static_cast<std::size_t>(b.obstacle_alert)];
        const bool is_known = knows_picture(a) && knows_picture(b);
        runs.known_pictures += is_known ? 1 : 0;
        runs.equal_pictures += is_known && a.hash == b.hash ? 1 : 0;
        if (a.phase == b.phase) continue;
        if (!runs.first_other_phase) runs.first_other_phase = n;
        ++runs.other_phase;
    }
}

void count_known_by_one(RunComparison& runs) {
    for (std::size_t n = 0; n < runs.aligned.instants.size(); ++n)
        for (std::size_t quantity = 0; quantity < kQuantityCount; ++quantity)
            if (std::isfinite(runs.value_a(n, quantity)) != std::isfinite(runs.value_b(n, quantity)))
                ++runs.known_by_one[quantity];
}

void list_settings(RunComparison& runs) {
    const auto add = [&](const char* name, const std::string& a, const std::string& b) {
        if (a != b) runs.settings.push_back({name, a, b});
    };
    add("design", runs.a.design, runs.b.design);
    add("device", runs.a.device, runs.b.device);
    add("aircraft", runs.a.aircraft, runs.b.aircraft);
    add("light", runs.a.light, runs.b.light);
    add("palette", runs.a.palette, runs.b.palette);
    add("terrain", runs.a.terrain, runs.b.terrain);
    add("scene", runs.a.scene, runs.b.scene);
    add("size", runs.a.size, runs.b.size);
    add("version", runs.a.version, runs.b.version);
}

}  // namespace

const QuantityDifference* RunComparison::find(std::size_t quantity) const {
    for (const QuantityDifference& one : quantities)
        if (one.quantity == quantity) return &one;
    return nullptr;
}

bool RunComparison::has_equal(std::size_t quantity) const {
    const QuantityDifference* const one = find(quantity);
    return known_by_one[quantity] == 0 && (one == nullptr || one->greatest == 0);
}

bool RunComparison::is_equal() const {
    const auto is_drawn_alike = [&](std::size_t n) { return frame_a(n).effects == frame_b(n).effects; };
    for (std::size_t n = 0; n < aligned.instants.size(); ++n)
        if (!is_drawn_alike(n)) return false;
    for (std::size_t quantity = 0; quantity < kQuantityCount; ++quantity)
        if (quantity != kFrameTime && !has_equal(quantity)) return false;
    return terrain_a == terrain_b && obstacles_a == obstacles_b && other_phase == 0 && equal_pictures == known_pictures;
}

RunComparison compared_runs(ComparedRun a, ComparedRun b, const AlignmentRequest& request) {
    RunComparison runs;
    runs.a = std::move(a);
    runs.b = std::move(b);
    runs.aligned = aligned(runs.a, runs.b, request);
    for (std::size_t quantity = 0; quantity < kQuantityCount; ++quantity)
        if (const auto difference = difference_of(runs, quantity)) runs.quantities.push_back(*difference);
    count_known_by_one(runs);
    count_effects(runs);
    count_states(runs);
    list_settings(runs);
    return runs;
}

}  // namespace tedavis::host_sim
