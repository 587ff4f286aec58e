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

void add(const float* __restrict from, double weight, std::size_t count, float* __restrict to) {
    const auto factor = static_cast<float>(weight);
    for (std::size_t n = 0; n < count; ++n) to[n] += factor * from[n];
}

/// out = sum of weight * map, a part after the other, each of which stays in the first cache while all maps are added.
void add_weighted(const Plane* maps, const double* weights, int count, const Plane& out) {
    constexpr std::size_t kPart = 2048;
    for (std::size_t first = 0; first < out.size(); first += kPart) {
        const std::size_t pixels = std::min(kPart, out.size() - first);
        std::fill_n(out.values + first, pixels, 0.0f);
        for (int n = 0; n < count; ++n)
            if (weights[n] > 0) add(maps[n].values + first, weights[n], pixels, out.values + first);
    }
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
    return most < kMinAmplitude ? 0 : rarity_above(map, most / 2) * most;
}

bool combine(const SaliencyMaps& maps, SaliencyScale scale) noexcept {
    std::fill_n(maps.saliency.values, maps.saliency.size(), 0.0f);
    for (std::size_t kind = 0; kind + 1 < kFirstOfConspicuity.size(); ++kind) {
        const int first = kFirstOfConspicuity[kind], count = kFirstOfConspicuity[kind + 1] - first;
        double weights[kFeatureMaps] = {}, sum = 0;
        for (int n = 0; n < count; ++n) sum += weights[n] = feature_weight(maps.features[first + n], scale);
        if (sum <= 0) continue;
        add_weighted(&maps.features[first], weights, count, maps.conspicuity);
        add(maps.conspicuity.values, conspicuity_weight(maps.conspicuity, scale), maps.saliency.size(), maps.saliency.values);
    }
    const float most = maximum(maps.saliency);
    if (most > 0) scale_by(maps.saliency, scale == SaliencyScale::fixed ? kFixedGain : 1 / most);
    return most > 0;
}

}  // namespace tedavis::perception
