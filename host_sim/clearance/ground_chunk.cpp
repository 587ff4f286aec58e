#include "host_sim/clearance/ground_chunk.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render_core/earth/wgs84.hpp"
#include "render_core/terrain/chunk_payload.hpp"
#include "render_core/terrain/regular_chunk.hpp"

namespace tedavis::host_sim {

void GroundBox::include(const glm::dvec3& place) {
    low = glm::min(low, place);
    high = glm::max(high, place);
}

double GroundBox::distance_m(const glm::dvec3& from) const {
    return glm::length(glm::max(glm::max(low - from, from - high), glm::dvec3(0)));
}

double GroundBox::level_distance_m(const glm::dvec3& from) const {
    const glm::dvec3 beside = glm::max(glm::max(low - from, from - high), glm::dvec3(0));
    return std::hypot(beside.x, beside.y);
}

bool GroundBox::may_reach(const Region& region) const {
    return std::all_of(region.begin(), region.end(), [this](const HalfSpace& half) {
        const glm::dvec3 farthest(half.normal.x > 0 ? high.x : low.x, half.normal.y > 0 ? high.y : low.y,
                                  half.normal.z > 0 ? high.z : low.z);
        return glm::dot(half.normal, farthest) >= half.offset;
    });
}

std::unique_ptr<GroundChunk> GroundChunk::read(const terrain::TerrainDatabase& database, const terrain::ChunkEntry& entry) {
    std::vector<std::uint8_t> payload(entry.payload.bytes);
    const base::Span<std::uint8_t> bytes(payload.data(), payload.size());
    if (database.read_part(entry.payload, bytes).error != terrain::TdbError::none ||
        !terrain::payload_holds(database.lattice(), entry, bytes))
        return nullptr;
    const base::Span<const terrain::ChunkVertex> vertices = terrain::payload_vertices(entry, bytes);
    const terrain::PostRange range = database.lattice().posts_of(terrain::key_of(entry));
    const terrain::RegularGrid grid = terrain::regular_grid(range.i1 - range.i0, range.j1 - range.j0, entry.level);
    if (vertices.size() != grid.vertex_count()) return nullptr;
    auto chunk = std::make_unique<GroundChunk>();
    chunk->columns_ = grid.columns;
    chunk->rows_ = grid.rows;
    chunk->centre_ = {entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]};
    const earth::Geodetic centre = earth::from_ecef(chunk->centre_);
    chunk->axes_ = earth::north_east_down(centre.latitude_rad, centre.longitude_rad);
    for (std::uint32_t row = 0; row < grid.rows; ++row)
        for (std::uint32_t column = 0; column < grid.columns; ++column) {
            const terrain::ChunkVertex& vertex = vertices[grid.index_of(column, row)];
            chunk->posts_.push_back(glm::dvec3(vertex.x, vertex.y, vertex.z) * chunk->axes_);  // their transpose times it
            chunk->is_void_.push_back(vertex.post_class() == terrain::PostClass::void_);
        }
    chunk->add_blocks();
    return chunk;
}

void GroundChunk::add_blocks() {
    for (std::uint32_t row = 0; row + 1 < rows_; row += kBlockCells)
        for (std::uint32_t column = 0; column + 1 < columns_; column += kBlockCells) {
            Block block;
            block.column = column;
            block.row = row;
            for (std::uint32_t b = row; b <= std::min(row + kBlockCells, rows_ - 1); ++b)
                for (std::uint32_t a = column; a <= std::min(column + kBlockCells, columns_ - 1); ++a) {
                    block.box.include(posts_[post(a, b)]);
                    block.has_void = block.has_void || is_void_[post(a, b)];
                }
            blocks_.push_back(block);
        }
}

/// Two triangles with the diagonal from north-east to south-west.
bool GroundChunk::find_in_cell(std::uint32_t column, std::uint32_t row, const glm::dvec3& eye, const Region& region,
                               double& distance_m, glm::dvec3& nearest) const {
    const std::size_t nw = post(column, row), ne = nw + 1, sw = post(column, row + 1), se = sw + 1;
    if (is_void_[nw] || is_void_[ne] || is_void_[sw] || is_void_[se]) return false;
    bool is_found = false;
    for (const std::size_t corner : {nw, se}) {
        const auto place = nearest_to_origin(posts_[corner] - eye, posts_[sw] - eye, posts_[ne] - eye, region);
        if (!place || !(glm::length(*place) < distance_m)) continue;
        distance_m = glm::length(*place);
        nearest = *place;
        is_found = true;
    }
    return is_found;
}

bool GroundChunk::find_nearer(const glm::dvec3& eye, const Region& region, double& distance_m, glm::dvec3& nearest) const {
    bool is_found = false;
    for (const Block& block : blocks_) {
        const GroundBox seen{block.box.low - eye, block.box.high - eye};
        if (!(seen.distance_m({}) < distance_m) || !seen.may_reach(region)) continue;
        for (std::uint32_t b = block.row; b < std::min(block.row + kBlockCells, rows_ - 1); ++b)
            for (std::uint32_t a = block.column; a < std::min(block.column + kBlockCells, columns_ - 1); ++a)
                is_found = find_in_cell(a, b, eye, region, distance_m, nearest) || is_found;
    }
    return is_found;
}

bool GroundChunk::has_void_within(const glm::dvec3& eye, double distance_m) const {
    return std::any_of(blocks_.begin(), blocks_.end(),
                       [&](const Block& block) { return block.has_void && block.box.level_distance_m(eye) < distance_m; });
}

}  // namespace tedavis::host_sim
