/// How well the signs of a layer stand out by their brightness: WCAG 2.1's contrast ratio of each.
///
/// A sign is a connected patch (across corners too) of a layer's pixels. Its surroundings are the pixels of no sign of this layer
/// that lie within kSurroundings_px of it. What a twentieth of its pixels (or 48 of them, where that is less: a stroke on a large
/// panel) are at least as bright, or as dark, as counts as its lightest and its darkest part; of the surroundings a tenth, their
/// middle, and a tenth.
///
///     ratio = the larger of   its lightest part against its darkest,
///                             the least, over the surroundings, of the better of its two parts against them
///
/// So light writing on light ground fails, white writing with a dark rim stands on any ground, and a plain sign must differ from
/// everything that borders on it. A sign of whose surroundings more than half belong to layers in front of its own is covered by
/// them, and is none; nor is a patch of which every pixel borders on them: it is the edge of a sign that they cover. What a patch
/// holds is judged by its strongest parts: weak writing on a panel beside strong writing is not found.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/layer_mask.hpp"
#include "render_core/perception/edge_density.hpp"

namespace tedavis::host_sim {

inline constexpr int kSurroundings_px = 2;

struct SignContrast {
    perception::PixelRegion box;  ///< of its pixels
    std::uint32_t pixels = 0;
    double ratio = 1;  ///< 1..21
};

/// Returns the contrasts of all signs of at least `least_px` pixels, ordered by their uppermost, then leftmost pixel. `layer`
/// counts through the mask's names; picture and mask have one size.
[[nodiscard]] std::vector<SignContrast> sign_contrasts(const RgbaPicture& picture, const LayerMask& mask, std::uint8_t layer,
                                                       std::uint32_t least_px);

}  // namespace tedavis::host_sim
