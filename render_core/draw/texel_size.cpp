#include "render_core/draw/texel_size.hpp"

#include <algorithm>
#include <cmath>
#include "render_core/earth/wgs84.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::draw {

namespace {

/// Of so many posts, in the middle of a chunk.
GroundSize post_size(const terrain::Lattice& lattice, const terrain::ChunkKey& chunk, double posts) {
    const terrain::PostRange range = lattice.posts_of(chunk);
    const std::uint32_t j = std::max((range.j0 + range.j1) / 2, 1u);
    const double latitude = lattice.latitude_rad(j);
    const double step_lon = lattice.longitude_rad(1) - lattice.longitude_rad(0);
    const double step_lat = lattice.latitude_rad(j - 1) - latitude;
    // At a pole columns meet; a millimetre keeps the azimuths defined.
    const double east_m = step_lon * earth::prime_vertical_radius_m(latitude) * std::cos(latitude);
    return {posts * std::fmax(east_m, 1e-3), posts * step_lat * earth::meridian_radius_m(latitude)};
}

}  // namespace

GroundSize texel_size(const terrain::Lattice& lattice, const terrain::ChunkKey& owner) {
    return post_size(lattice, owner, std::ldexp(0.5, static_cast<int>(owner.level)));
}

GroundSize drape_texel_size(const terrain::Lattice& lattice, const terrain::ChunkKey& owner) {
    constexpr double kPostsPerTexel = terrain::kChunkCells / double{terrain::kDrapeSteps};
    return post_size(lattice, owner, std::ldexp(kPostsPerTexel, static_cast<int>(owner.level)));
}

}  // namespace tedavis::draw
