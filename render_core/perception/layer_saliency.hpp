/// Which layer of a picture draws the eye: saliency added up by what each pixel shows.
///
/// Saliency is added in 65535ths, in integers: parts that are added apart give the whole, in any order.
#pragma once

#include <array>
#include <cstdint>

#include "render_core/base/span.hpp"
#include "render_core/perception/saliency_model.hpp"

namespace tedavis::perception {

inline constexpr int kMaxLayers = 16;

/// A byte a pixel of the picture, rows from the top without gaps: the number of its layer, 0..kMaxLayers - 1. Higher ones count
/// as the last.
struct LayerView {
    base::Span<const std::uint8_t> layers;
    int width = 0, height = 0;
};

struct LayerSaliency {
    std::uint64_t pixels = 0;
    std::uint64_t saliency_65535ths = 0;  ///< sum over its pixels
    double area = 0;                      ///< share of the picture, 0..1
    double share = 0;                     ///< share of all saliency, 0..1; 0 of all layers where nothing is salient
    double mean = 0;                      ///< 0..1
    double most = 0;                      ///< 0..1
};
using LayerSaliencies = std::array<LayerSaliency, kMaxLayers>;

/// False, with nothing written, where the layers are not those of the map's picture: their size gives another size of map.
[[nodiscard]] bool layer_saliency(const SaliencyMap& map, const LayerView& picture, LayerSaliencies& out) noexcept;

}  // namespace tedavis::perception
