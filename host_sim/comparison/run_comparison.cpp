#include "host_sim/comparison/run_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tedavis::host_sim {
namespace {

double median_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

bool counts_for_least(const ComparedFrame& frame, std::size_t quantity) {
    return (quantity != kHeightAboveTerrain && quantity != kClearance) || is_known_to_fly(frame);
}

void take_least(double value, std::size_t instant, bool counts, double& least, std::size_t& least_at) {
    if (!counts || least <= value) return;  // the first value is compared with NaN
    least = value;
    least_at = instant;
}

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void summarize(const std::vector<double>& all_a, const std::vector<double>& all_b, QuantityDifference& found) {
    found.values_a = all_a.size();
    found.values_b = all_b.size();
    found.mean_a = mean_of(all_a);
    found.mean_b = mean_of(all_b);
    found.median_a = median_of(all_a);
    found.median_b = median_of(all_b);
}

std::optional<QuantityDifference> difference_of(const RunComparison& runs, std::size_t quantity) {
    QuantityDifference found;
    found.quantity = quantity;
    std::vector<double> all_a, all_b;
    std::vector<bool> is_taken(runs.b.frames.size());
    for (std::size_t n = 0; n < runs.aligned.instants.size(); ++n) {
        const double a = runs.value_a(n, quantity), b = runs.value_b(n, quantity);
        if (!std::isfinite(a) || !std::isfinite(b)) continue;
        take_least(a, n, counts_for_least(runs.frame_a(n), quantity), found.least_a, found.least_a_at);
        take_least(b, n, counts_for_least(runs.frame_b(n), quantity), found.least_b, found.least_b_at);
        if (all_a.empty() || std::abs(b - a) > std::abs(found.greatest)) found.greatest = b - a, found.greatest_at = n;
        all_a.push_back(a);
        const std::size_t nearest = runs.aligned.instants[n].nearest_b();
        if (kQuantities[quantity].is_flown || !is_taken[nearest]) all_b.push_back(b);
        is_taken[nearest] = true;
    }
    found.count = all_a.size();
    if (all_a.empty()) return std::nullopt;
    summarize(all_a, all_b, found);
    return found;
}

EffectDifference& effect_named(std::vector<EffectDifference>& effects, const std::string& name) {
    for (EffectDifference& effect : effects)
        if (effect.name == name) return effect;
    effects.push_back({name});
    return effects.back();
}

/// A record has an effect once for each layer of data that is drawn with it.
std::vector<std::string> distinct(std::vector<std::string> names) {
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

void count_effects(RunComparison& runs) {
    for (const std::size_t n : runs.compared_a)
        for (const std::string& name : distinct(runs.a.frames[n].effects)) ++effect_named(runs.effects, name).frames_a;
    for (const std::size_t n : runs.compared_b)
        for (const std::string& name : distinct(runs.b.frames[n].effects)) ++effect_named(runs.effects, name).frames_b;
    for (EffectDifference& effect : runs.effects) {
        effect.share_a = static_cast<double>(effect.frames_a) / static_cast<double>(runs.compared_a.size());
        effect.share_b = static_cast<double>(effect.frames_b) / static_cast<double>(runs.compared_b.size());
    }
    const auto apart = [](const EffectDifference& effect) { return std::abs(effect.share_a - effect.share_b); };
    std::stable_sort(runs.effects.begin(), runs.effects.end(),
                     [&](const EffectDifference& one, const EffectDifference& other) { return apart(one) > apart(other); });
}

void list_compared_frames(RunComparison& runs) {
    for (const AlignedInstant& instant : runs.aligned.instants) {
        runs.compared_a.push_back(instant.a);
        runs.compared_b.push_back(instant.nearest_b());
    }
    for (std::vector<std::size_t>* const frames : {&runs.compared_a, &runs.compared_b}) {
        std::sort(frames->begin(), frames->end());
        frames->erase(std::unique(frames->begin(), frames->end()), frames->end());
    }
}

void count_alerts(const ComparedRun& run, const std::vector<std::size_t>& frames, AlertLevels& terrain, AlertLevels& obstacles) {
    for (const std::size_t n : frames) {
        ++terrain[static_cast<std::size_t>(run.frames[n].terrain_alert)];
        ++obstacles[static_cast<std::size_t>(run.frames[n].obstacle_alert)];
    }
}

void count_states(RunComparison& runs) {
    count_alerts(runs.a, runs.compared_a, runs.terrain_a, runs.obstacles_a);
    count_alerts(runs.b, runs.compared_b, runs.terrain_b, runs.obstacles_b);
    for (std::size_t n = 0; n < runs.aligned.instants.size(); ++n) {
        const ComparedFrame &a = runs.frame_a(n), &b = runs.frame_b(n);
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
    const auto is_alike = [](const ComparedFrame& one, const ComparedFrame& other) {
        return one.effects == other.effects && one.terrain_alert == other.terrain_alert &&
               one.obstacle_alert == other.obstacle_alert;
    };
    for (std::size_t n = 0; n < aligned.instants.size(); ++n)
        if (!is_alike(frame_a(n), frame_b(n))) return false;
    for (std::size_t quantity = 0; quantity < kQuantityCount; ++quantity)
        if (quantity != kFrameTime && !has_equal(quantity)) return false;
    return other_phase == 0 && equal_pictures == known_pictures;
}

RunComparison compared_runs(ComparedRun a, ComparedRun b, const AlignmentRequest& request) {
    RunComparison runs;
    runs.a = std::move(a);
    runs.b = std::move(b);
    runs.aligned = aligned(runs.a, runs.b, request);
    runs.closest_a = closest_of_run(runs.a);
    runs.closest_b = closest_of_run(runs.b);
    list_compared_frames(runs);
    for (std::size_t quantity = 0; quantity < kQuantityCount; ++quantity)
        if (const auto difference = difference_of(runs, quantity)) runs.quantities.push_back(*difference);
    count_known_by_one(runs);
    count_effects(runs);
    count_states(runs);
    list_settings(runs);
    return runs;
}

}  // namespace tedavis::host_sim
