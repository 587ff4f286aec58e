/// Spacing of the texels of attribute and drape pages on the ground. Pure; any thread.
#pragma once

#include "render_core/terrain/lattice.hpp"

namespace tedavis::draw {

struct GroundSize {
    double east_m = 0, north_m = 0;
};
/// Spacing of the texels of a chunk's attribute page, at its middle; and of its drape page.
[[nodiscard]] GroundSize texel_size(const terrain::Lattice& lattice, const terrain::ChunkKey& owner);
[[nodiscard]] GroundSize drape_texel_size(const terrain::Lattice& lattice, const terrain::ChunkKey& owner);

}  // namespace tedavis::draw
