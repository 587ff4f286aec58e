#include "render_core/terrain/height_query.hpp"

#include <cmath>
#include <cstring>

namespace tedavis::terrain {
namespace {

constexpr std::size_t kPayloadBytes = kMaxChunkVertices * sizeof(ChunkVertex) + kLeafPostBytes;

struct Cell {
    float height[4];  // north-west, north-east, south-west, south-east
    PostClass kind[4];
};

Cell cell_of(const std::uint8_t* posts, std::uint32_t i, std::uint32_t j) {
    const std::uint8_t* classes = posts + std::size_t{kChunkPosts} * kChunkPosts * sizeof(float);
    Cell cell;
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
        const std::size_t at = std::size_t{j + corner / 2} * kChunkPosts + i + corner % 2;
        std::memcpy(&cell.height[corner], posts + at * sizeof(float), sizeof(float));
        cell.kind[corner] = static_cast<PostClass>(classes[at]);
    }
    return cell;
}

bool any(const Cell& cell, PostClass kind) {
    return cell.kind[0] == kind || cell.kind[1] == kind || cell.kind[2] == kind || cell.kind[3] == kind;
}

/// u east, v south, both 0..1; the diagonal runs from north-east to south-west.
double interpolate(const Cell& cell, double u, double v) {
    const double nw = cell.height[0], ne = cell.height[1], sw = cell.height[2], se = cell.height[3];
    return u + v <= 1 ? nw + u * (ne - nw) + v * (sw - nw) : se + (1 - u) * (sw - se) + (1 - v) * (ne - se);
}

}  // namespace

std::uint64_t HeightQuery::bytes_needed() { return kKept * kLeafPostBytes + kPayloadBytes + 128; }

bool HeightQuery::start(const TerrainDatabase& database, base::Arena& arena) {
    database_ = &database;
    posts_ = arena.allocate_array<std::uint8_t>(kKept * kLeafPostBytes);
    payload_ = arena.allocate_array<std::uint8_t>(kPayloadBytes);
    return !posts_.empty() && !payload_.empty();
}

const std::uint8_t* HeightQuery::posts_of(ChunkIndex chunk) {
    ++asked_;
    std::uint32_t oldest = 0;
    for (std::uint32_t n = 0; n < kKept; ++n) {
        if (kept_[n].chunk == chunk) {
            kept_[n].asked = asked_;
            return posts_.data() + n * kLeafPostBytes;
        }
        if (kept_[n].asked < kept_[oldest].asked) oldest = n;
    }
    if (database_->read_chunk(chunk, payload_).error != TdbError::none) return nullptr;
    const ChunkEntry& entry = database_->entry(chunk);
    std::uint8_t* posts = posts_.data() + oldest * kLeafPostBytes;
    std::memcpy(posts, payload_.data() + entry.bytes - kLeafPostBytes, kLeafPostBytes);
    kept_[oldest] = {chunk, asked_};
    return posts;
}

HeightAnswer HeightQuery::at(double latitude_rad, double longitude_rad) {
    HeightAnswer answer;
    answer.undulation = database_->undulation(latitude_rad, longitude_rad);
    const TerrainDatabase::LatticePoint point = database_->lattice_point(latitude_rad, longitude_rad);
    if (!point.inside) return answer;
    const double i = std::fmin(std::floor(point.i), database_->header().columns - 2.0);
    const double j = std::fmin(std::floor(point.j), database_->header().rows - 2.0);
    const auto post_i = static_cast<std::uint32_t>(i), post_j = static_cast<std::uint32_t>(j);
    const std::uint8_t* posts = posts_of(database_->at(0, post_i / kChunkCells, post_j / kChunkCells));
    if (posts == nullptr) {
        answer.status = HeightStatus::damaged;
        return answer;
    }
    const Cell cell = cell_of(posts, post_i % kChunkCells, post_j % kChunkCells);
    if (any(cell, PostClass::void_)) {
        answer.status = HeightStatus::void_;
        return answer;
    }
    answer.status = any(cell, PostClass::land) ? HeightStatus::land : HeightStatus::sea;
    answer.height.m = interpolate(cell, point.i - i, point.j - j);
    return answer;
}

}  // namespace tedavis::terrain
