/// The warning bands that a chunk of terrain may intersect, in the shader's format.
#pragma once

#include <cstdint>

#include "render_core/design/warning_bands.hpp"

namespace tedavis::draw {

struct TerrainBands {
    float lower_m[design::kMaxWarningBands];    ///< heights above MSL at which a band begins, ascending; 1e9 where unused
    float color[design::kMaxWarningBands * 4];  ///< red, green, blue, strength; 0..1
    std::size_t count = 0;

    TerrainBands();
};

/// Returns those of `bands` (the highest first) that apply somewhere between two heights above MSL. At a height the last one
/// applies whose lower limit is not above it. An empty result means that no warning colour is due.
[[nodiscard]] TerrainBands bands_within(const design::WarningBands& bands, double aircraft_msl_m, bool gear_down,
                                        float least_height_m, float greatest_height_m);

}  // namespace tedavis::draw
