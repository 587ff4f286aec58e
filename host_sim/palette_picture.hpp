/// Pictures of few colors, for pages: their PNG files have a third of the bytes.
#pragma once

#include <cstddef>

#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

inline constexpr std::size_t kMaxPaletteColors = 256;

/// Returns the picture without alpha, in at most `max_colors` colors (1 to 256), without dithering; unchanged where it has no
/// more. The box of colors with the greatest squared error is divided, at its mean and across the channel in which it varies
/// most, until there are `max_colors` boxes (Wan, Prusinkiewicz, Wong 1990). Equal pictures give equal results.
[[nodiscard]] PalettePicture with_palette(const RgbaView& view, std::size_t max_colors = kMaxPaletteColors);

}  // namespace tedavis::host_sim
