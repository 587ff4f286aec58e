/// Sets the entry's summary of a chunk's posts: heights, classes and existing children.
#pragma once

#include "host_sim/terrain_builder/lattice_window.hpp"
#include "render_core/terrain/lattice.hpp"

namespace tedavis::host_sim {

/// For a chunk of level 0, from its posts. A chunk without valid posts has heights 0.
void summarise_posts(const terrain::Lattice& lattice, const LatticeWindow& window, terrain::ChunkEntry& entry);

/// For a chunk of a higher level; to be called once for each child that exists.
void summarise_child(const terrain::ChunkEntry& child, terrain::ChunkEntry& entry);

}  // namespace tedavis::host_sim
