/// Sums a picture's saliency by the layer that each pixel shows.
///
/// Saliency is added in integers, in 65535ths, so the sum does not depend on the order.
#pragma once

#include <array>
#include <cstdint>

#include "render_core/base/span.hpp"
#include "render_core/perception/saliency_model.hpp"

namespace tedavis::perception {

inline constexpr int kMaxLayers = 16;

/// One byte per pixel of the picture, rows from the top without gaps: the number of its layer, 0..kMaxLayers - 1. Higher
/// numbers count as the last layer.
struct LayerView {
    base::Span<const std::uint8_t> layers;
    int width = 0, height = 0;
};

struct LayerSaliency {
    std::uint64_t pixels = 0;
    std::uint64_t saliency_65535ths = 0;  ///< sum over its pixels
    double area = 0;                      ///< share of the picture, 0..1
    double share = 0;                     ///< share of the total saliency, 0..1; 0 where nothing is salient
    double mean = 0;                      ///< 0..1
    double most = 0;                      ///< 0..1
};
using LayerSaliencies = std::array<LayerSaliency, kMaxLayers>;

/// Returns false, and writes nothing, where the layers' size does not match the map's.
[[nodiscard]] bool layer_saliency(const SaliencyMap& map, const LayerView& picture, LayerSaliencies& out) noexcept;

}  // namespace tedavis::perception
