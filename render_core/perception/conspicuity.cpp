#include "render_core/perception/conspicuity.hpp"

#include <algorithm>

#include "render_core/perception/entropy.hpp"

namespace tedavis::perception {
namespace {

/// Eight at a time: a maximum has no order.
float maximum(const Plane& map) {
    constexpr std::size_t kLanes = 8;
    float lanes[kLanes] = {};
    const std::size_t whole = map.size() / kLanes * kLanes;
    for (std::size_t n = 0; n < whole; n += kLanes)
        for (std::size_t k = 0; k < kLanes; ++k) lanes[k] = lanes[k] > map.values[n + k] ? lanes[k] : map.values[n + k];
    float most = 0;
    for (std::size_t n = whole; n < map.size(); ++n) most = std::max(most, map.values[n]);
    for (const float lane : lanes) most = std::max(most, lane);
    return most;
}

std::uint64_t count_above(const Plane& map, float threshold) {
    std::int32_t count = 0;  // pictures have fewer pixels
    for (std::size_t n = 0; n < map.size(); ++n) count += map.values[n] > threshold ? 1 : 0;
    return static_cast<std::uint64_t>(count);
}

double rarity_above(const Plane& map, float threshold) { return information(count_above(map, threshold), map.size()); }

/// out = weight * map, or that added to it.
void add(const Plane& map, double weight, bool is_first, const Plane& out) {
    const auto factor = static_cast<float>(weight);
    const float* __restrict from = map.values;
    float* __restrict to = out.values;
    const std::size_t count = map.size();
    if (is_first)
        for (std::size_t n = 0; n < count; ++n) to[n] = factor * from[n];
    else
        for (std::size_t n = 0; n < count; ++n) to[n] += factor * from[n];
}

void scale_by(const Plane& map, float factor) {
    for (std::size_t n = 0; n < map.size(); ++n) map.values[n] = std::min(factor * map.values[n], 1.0f);
}

}  // namespace

double conspicuity_weight(const Plane& map, SaliencyScale scale) noexcept {
    return scale == SaliencyScale::fixed ? 1 : rarity_above(map, maximum(map) / 2);
}

double feature_weight(const Plane& map, SaliencyScale scale) noexcept {
    const float most = maximum(map);
    if (scale == SaliencyScale::fixed)
        return most > kNoticeable ? rarity_above(map, kNoticeable) / most_information(map.size()) : 0;
    return most < kLeastAmplitude ? 0 : rarity_above(map, most / 2) * most;
}

bool combine(const SaliencyMaps& maps, SaliencyScale scale) noexcept {
    bool has_any = false;
    for (std::size_t kind = 0; kind + 1 < kFirstOfConspicuity.size(); ++kind) {
        bool is_first = true;
        for (int n = kFirstOfConspicuity[kind]; n < kFirstOfConspicuity[kind + 1]; ++n) {
            const double weight = feature_weight(maps.features[n], scale);
            if (weight <= 0) continue;
            add(maps.features[n], weight, is_first, maps.conspicuity);
            is_first = false;
        }
        if (is_first) continue;
        add(maps.conspicuity, conspicuity_weight(maps.conspicuity, scale), !has_any, maps.saliency);
        has_any = true;
    }
    const float most = has_any ? maximum(maps.saliency) : 0;
    if (most <= 0) {
        std::fill_n(maps.saliency.values, maps.saliency.size(), 0.0f);
        return false;
    }
    scale_by(maps.saliency, scale == SaliencyScale::fixed ? kFixedGain : 1 / most);
    return true;
}

}  // namespace tedavis::perception
