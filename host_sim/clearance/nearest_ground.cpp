#include "host_sim/clearance/nearest_ground.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <queue>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kMaxKeptPages = 1024, kMaxKeptChunks = 768;
/// Axes and sizes of the database's boxes are floats.
constexpr double kBoxSlack = 1e-6, kBoxSlack_m = 0.1;

/// An entry's box relative to the eye, along the box's axes.
struct SeenBox {
    GroundBox box;
    glm::dmat3 axes{1};

    SeenBox(const terrain::ChunkEntry& entry, const glm::dvec3& eye) {
        for (int n = 0; n < 3; ++n) axes[n] = {entry.axes[3 * n], entry.axes[3 * n + 1], entry.axes[3 * n + 2]};
        const glm::dvec3 centre = glm::dvec3(entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]) - eye;
        const glm::dvec3 middle = centre * axes;
        const glm::dvec3 half = glm::dvec3(entry.half_extent_m[0], entry.half_extent_m[1], entry.half_extent_m[2]) + kBoxSlack_m +
                                kBoxSlack * glm::length(centre);
        box = {middle - half, middle + half};
    }
};

/// The region in other axes.
Region turned(const Region& region, const glm::dmat3& axes) {
    Region result;
    for (const HalfSpace& half : region) result.push_back({half.normal * axes, half.offset});
    return result;
}

struct ChunkAhead {
    double bound_m;
    terrain::ChunkKey key;
    [[nodiscard]] bool operator<(const ChunkAhead& other) const { return bound_m > other.bound_m; }  // the nearest on top
};

template <class Visit>
void for_roots(const terrain::TerrainDatabase& database, const Visit& visit) {
    const std::uint32_t top = database.top_level();
    for (std::uint32_t j = 0; j < database.lattice().grid_rows(top); ++j)
        for (std::uint32_t i = 0; i < database.lattice().grid_columns(top); ++i) visit(terrain::ChunkKey{top, i, j});
}

template <class Visit>
void for_children(const terrain::ChunkEntry& entry, const Visit& visit) {
    for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant)
        if ((entry.children >> quadrant & 1u) != 0) visit(terrain::key_of(entry).child(quadrant));
}

}  // namespace

struct NearestGround::Search {
    glm::dvec3 eye;
    Region region;  ///< ECEF, relative to the eye
    double distance_m;
    glm::dvec3 nearest{};  ///< ECEF, relative to the eye
    bool is_found = false;
};

const terrain::ChunkEntry* NearestGround::entry_of(const terrain::ChunkKey& key) {
    const std::uint32_t index = database_.lattice().page_index(key);
    auto kept = pages_.find(index);
    if (kept == pages_.end()) {
        if (!database_.has_page(index)) return nullptr;
        if (pages_.size() >= kMaxKeptPages) pages_.clear();
        auto page = std::make_unique<terrain::DirectoryPage>();
        if (database_.read_page(index, *page).error != terrain::TdbError::none) page = nullptr;
        is_damaged_ = is_damaged_ || page == nullptr;
        kept = pages_.emplace(index, std::move(page)).first;
    }
    if (kept->second == nullptr) return nullptr;
    const terrain::ChunkEntry& entry = kept->second->entries[terrain::Lattice::index_in_page(key)];
    return entry.vertex_count == 0 ? nullptr : &entry;
}

const GroundChunk* NearestGround::chunk_of(const terrain::ChunkEntry& entry) {
    const std::uint64_t packed = terrain::key_of(entry).packed();
    const auto kept = chunks_.find(packed);
    if (kept != chunks_.end()) return kept->second.get();
    if (chunks_.size() >= kMaxKeptChunks) chunks_.clear();
    const GroundChunk* const chunk = chunks_.emplace(packed, GroundChunk::read(database_, entry)).first->second.get();
    is_damaged_ = is_damaged_ || chunk == nullptr;
    return chunk;
}

void NearestGround::search(Search& search) {
    std::priority_queue<ChunkAhead> ahead;
    const auto add = [&](const terrain::ChunkKey& key) {
        const terrain::ChunkEntry* const entry = entry_of(key);
        if (entry == nullptr) return;
        const SeenBox seen(*entry, search.eye);
        const double bound_m = seen.box.distance_m({});
        if (bound_m < search.distance_m && seen.box.may_reach(turned(search.region, seen.axes))) ahead.push({bound_m, key});
    };
    for_roots(database_, add);
    while (!ahead.empty() && ahead.top().bound_m < search.distance_m) {
        const terrain::ChunkEntry* const found = entry_of(ahead.top().key);
        ahead.pop();
        if (found == nullptr) continue;
        const terrain::ChunkEntry entry = *found;  // its page may be replaced
        for_children(entry, add);
        const GroundChunk* const chunk = entry.children == 0 ? chunk_of(entry) : nullptr;
        if (chunk == nullptr) continue;
        glm::dvec3 nearest{};
        if (!chunk->find_nearer((search.eye - chunk->centre()) * chunk->axes(), turned(search.region, chunk->axes()),
                                search.distance_m, nearest))
            continue;
        search.nearest = chunk->axes() * nearest;
        search.is_found = true;
    }
}

std::optional<GroundPlace> NearestGround::find(const earth::Geodetic& from, double within_m, const Region& region) {
    const glm::dmat3 axes = earth::north_east_down(from.latitude_rad, from.longitude_rad);
    Search found{earth::to_ecef(from), {}, within_m};
    for (const HalfSpace& half : region) found.region.push_back({axes * half.normal, half.offset});
    search(found);
    if (!found.is_found) return std::nullopt;
    const glm::dvec3 way = found.nearest * axes;
    GroundPlace ground;
    ground.distance_m = found.distance_m;
    ground.bearing_rad = earth::wrap_heading(std::atan2(way.y, way.x));
    ground.elevation_rad = std::atan2(-way.z, std::hypot(way.x, way.y));
    ground.place = earth::from_ecef(found.eye + found.nearest);
    ground.height_msl_m = ground.place.height.m - database_.undulation(ground.place.latitude_rad, ground.place.longitude_rad).m;
    return ground;
}

/// By the shorter of the radii of curvature, so that the way to the end is never taken for longer than it is.
bool NearestGround::is_beside_end(const earth::Geodetic& from, double within_m) const {
    const terrain::Lattice& lattice = database_.lattice();
    const terrain::LatticePoint point = lattice.point(from.latitude_rad, from.longitude_rad);
    if (!point.inside) return true;
    const terrain::FileHeader& header = database_.header();
    const double row_m = base::radians(header.step_lat_deg) * earth::kMinCurvatureRadius_m;
    const double column_m = base::radians(header.step_lon_deg) * earth::kMinCurvatureRadius_m * std::cos(from.latitude_rad);
    const bool ends_north = (lattice.flags() & terrain::kLatticeNorthPole) == 0,
               ends_south = (lattice.flags() & terrain::kLatticeSouthPole) == 0;
    if (ends_north && point.j * row_m < within_m) return true;
    if (ends_south && (lattice.rows() - 1 - point.j) * row_m < within_m) return true;
    return !lattice.is_closed() && std::min(point.i, lattice.columns() - 1 - point.i) * column_m < within_m;
}

bool NearestGround::has_void(const terrain::ChunkKey& key, const glm::dvec3& eye, double within_m) {
    const terrain::ChunkEntry* const found = entry_of(key);
    if (found == nullptr) return true;
    const terrain::ChunkEntry entry = *found;
    if ((entry.flags & terrain::kChunkHasVoid) == 0) return false;
    if (!(SeenBox(entry, eye).box.level_distance_m({}) < within_m)) return false;
    bool is_found = false;
    for_children(entry, [&](const terrain::ChunkKey& child) { is_found = is_found || has_void(child, eye, within_m); });
    if (is_found || entry.children != 0) return is_found;
    const GroundChunk* const chunk = chunk_of(entry);
    return chunk == nullptr || chunk->has_void_within((eye - chunk->centre()) * chunk->axes(), within_m);
}

bool NearestGround::may_be_unknown(const earth::Geodetic& from, double within_m) {
    if (is_damaged_ || is_beside_end(from, within_m)) return true;
    bool is_found = false;
    for_roots(database_,
              [&](const terrain::ChunkKey& key) { is_found = is_found || has_void(key, earth::to_ecef(from), within_m); });
    return is_found;
}

}  // namespace tedavis::host_sim
