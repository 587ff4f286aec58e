/// The contrast of the signs of each role of the symbology's palette with their surroundings: WCAG 2.1's contrast ratio.
///
/// A sign is a connected patch (across corners too) of a layer's pixels that have the color of one role, within kRoleTolerance in
/// each channel: pixels that antialiasing blends with the ground do not belong to it. For each pixel at its border, the best
/// ratio to a pixel of another color within kRimReach_px is taken: that of the rim, or of the ground where there is no rim. The
/// ratio of the sign is the one that at least four fifths of its border have, since other signs may cover a part of its rim.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/layer_mask.hpp"
#include "render_core/design/symbology_palette.hpp"
#include "render_core/perception/edge_density.hpp"

namespace tedavis::host_sim {

inline constexpr int kRoleTolerance = 6;  ///< of 255
inline constexpr int kRimReach_px = 3;

struct RoleContrast {
    design::SymbolRole role = design::SymbolRole::scale;
    perception::PixelRegion box;
    std::uint32_t pixels = 0;
    double ratio = 1;  ///< 1..21
};

/// Returns the contrasts of all signs of at least `least_px` pixels, ordered by role, then by their uppermost, then leftmost
/// pixel. `layer` is an index in the mask's names; picture and mask have the same size.
[[nodiscard]] std::vector<RoleContrast> role_contrasts(const RgbaPicture& picture, const LayerMask& mask, std::uint8_t layer,
                                                       const design::SymbologyPalette& palette, std::uint32_t least_px);

}  // namespace tedavis::host_sim
