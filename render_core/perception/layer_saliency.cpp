#include "render_core/perception/layer_saliency.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::perception {
namespace {

constexpr float kSteps = 65535;

struct LayerSums {
    std::uint64_t sum = 0, pixels = 0;
    std::uint32_t most = 0;
};

std::uint32_t steps_of(float saliency) { return static_cast<std::uint32_t>(std::lround(saliency * kSteps)); }

/// Pixels of one layer follow each other mostly: a run is added at once.
void add_run(std::array<LayerSums, kMaxLayers>& sums, std::uint8_t layer, std::uint32_t saliency, int pixels) {
    LayerSums& of = sums[std::min<std::size_t>(layer, kMaxLayers - 1)];
    of.sum += std::uint64_t{saliency} * static_cast<std::uint64_t>(pixels);
    of.pixels += static_cast<std::uint64_t>(pixels);
    of.most = std::max(of.most, saliency);
}

void add_row(std::array<LayerSums, kMaxLayers>& sums, const float* map_row, int level, const std::uint8_t* layers, int width) {
    const int block = 1 << level;
    for (int x = 0, column = 0; x < width; x += block, ++column) {
        const std::uint32_t saliency = steps_of(map_row[column]);
        const int end = std::min(x + block, width);
        int first = x;
        for (int n = x + 1; n <= end; ++n) {
            if (n < end && layers[n] == layers[first]) continue;
            add_run(sums, layers[first], saliency, n - first);
            first = n;
        }
    }
}

}  // namespace

bool layer_saliency(const SaliencyMap& map, const LayerView& picture, LayerSaliencies& out) noexcept {
    if (picture.width < 1 || picture.height < 1 || level_side(picture.width, map.level) != map.width ||
        level_side(picture.height, map.level) != map.height || picture.layers.size() < pixels_of(picture.width, picture.height))
        return false;
    std::array<LayerSums, kMaxLayers> sums{};
    for (int y = 0; y < picture.height; ++y)
        add_row(sums, map.values.data() + pixels_of(map.width, y >> map.level), map.level,
                picture.layers.data() + pixels_of(picture.width, y), picture.width);
    std::uint64_t all = 0;
    for (const LayerSums& layer : sums) all += layer.sum;
    const auto pixels = static_cast<double>(pixels_of(picture.width, picture.height));
    for (std::size_t n = 0; n < kMaxLayers; ++n) {
        const auto sum = static_cast<double>(sums[n].sum), count = static_cast<double>(sums[n].pixels);
        out[n] = {sums[n].pixels,
                  sums[n].sum,
                  count / pixels,
                  all == 0 ? 0 : sum / static_cast<double>(all),
                  count == 0 ? 0 : sum / (kSteps * count),
                  static_cast<double>(sums[n].most) / kSteps};
    }
    return true;
}

}  // namespace tedavis::perception
