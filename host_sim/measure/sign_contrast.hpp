/// The luminance contrast of the signs of a layer: WCAG 2.1's contrast ratio of each.
///
/// A sign is a connected patch (across corners too) of a layer's pixels. Its surroundings are the pixels of no sign of this layer
/// that lie within kSurroundings_px of it. Its lightest and darkest part are the luminances that a twentieth of its pixels (at
/// most 48, for a stroke on a large panel) reach at least, or at most. The surroundings are represented by their median and by
/// the luminances that a tenth of them reach at least, or at most.
///
///     ratio = the larger of   its lightest part against its darkest,
///                             the least, over the surroundings, of the better of its two parts against them
///
/// So light text on light ground fails, white text with a dark rim passes on any ground, and a plain sign must differ from
/// everything around it. A sign is ignored as covered if more than half of its surroundings belong to layers in front of its own;
/// so is a patch of which every pixel borders on them, the edge of a covered sign. A patch is judged by its strongest parts:
/// faint text on a panel beside strong text is not found.
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

/// Returns the contrasts of all signs of at least `least_px` pixels, ordered by their uppermost, then leftmost pixel. `layer` is
/// an index in the mask's names; picture and mask have the same size.
[[nodiscard]] std::vector<SignContrast> sign_contrasts(const RgbaPicture& picture, const LayerMask& mask, std::uint8_t layer,
                                                       std::uint32_t least_px);

}  // namespace tedavis::host_sim
