#include "render_core/terrain/terrain_database.hpp"

#include <cmath>
#include <cstddef>
#include <cstring>

#include "render_core/base/hash.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::terrain {
namespace {

constexpr std::uint32_t kMaxPosts = 1u << 24;  // a side; 2^24 posts of 1" circle the Earth twelve times
constexpr std::uint32_t kMaxUndulationSide = 1u << 13;
constexpr double kHighest_m = 12000, kFarthest_m = 1e7;
constexpr double kLargestError_m = 1e31;  // above what the builder states where every post is needed

std::uint32_t chunks_across(std::uint32_t posts, std::uint32_t level) {
    const std::uint32_t cells = kChunkCells << level;
    return (posts - 1 + cells - 1) / cells;
}

// Comparisons are written so that NaN fails them.
bool within(double value, double low, double high) { return value >= low && value <= high; }

bool ranges_hold(const FileHeader& h) {
    const bool sizes =
        h.columns >= 2 && h.rows >= 2 && h.columns <= kMaxPosts && h.rows <= kMaxPosts && h.levels >= 1 && h.levels <= kMaxLevels;
    const bool steps = h.step_lon_deg > 0 && h.step_lat_deg > 0 && h.step_lon_deg <= 10 && h.step_lat_deg <= 10;
    const bool place =
        std::abs(h.west_deg) <= 360 && std::abs(h.north_deg) <= 90 && h.north_deg - h.step_lat_deg * (h.rows - 1) >= -90.000001;
    const bool grid = within(h.undulation_west_deg, -720, 720) && within(h.undulation_north_deg, -91, 91) &&
                      within(h.undulation_step_deg, 1e-3, 10) && h.undulation_columns >= 2 && h.undulation_rows >= 2 &&
                      h.undulation_columns <= kMaxUndulationSide && h.undulation_rows <= kMaxUndulationSide;
    const bool heights = h.min_height_m >= -kHighest_m && h.max_height_m <= kHighest_m && h.min_height_m <= h.max_height_m;
    bool errors = within(h.le90_m, 0, kHighest_m);
    for (std::uint32_t level = 0; level < kMaxLevels; ++level)
        errors = errors && (level >= h.levels || within(h.tolerance_m[level], 0, kLargestError_m));
    const bool names = h.source[sizeof h.source - 1] == 0 && h.vertical_datum[sizeof h.vertical_datum - 1] == 0;
    return sizes && steps && place && grid && heights && errors && names && h.max_chunk_vertices <= kMaxChunkVertices;
}

std::uint64_t expected_chunks(const FileHeader& h) {
    std::uint64_t count = 0;
    for (std::uint32_t level = 0; level < h.levels; ++level)
        count += std::uint64_t{chunks_across(h.columns, level)} * chunks_across(h.rows, level);
    return count;
}

bool measures_hold(const ChunkEntry& entry) {
    bool hold = within(entry.above_m, 0, kLargestError_m) && within(entry.below_m, 0, kLargestError_m) &&
                within(entry.bound_m, 0, kLargestError_m) && within(entry.min_height_m, -kHighest_m, kHighest_m) &&
                within(entry.max_height_m, -kHighest_m, kHighest_m);
    for (const double x : entry.centre_m) hold = hold && within(x, -kFarthest_m, kFarthest_m);
    for (const float x : entry.axes) hold = hold && within(x, -1.001, 1.001);
    for (const float x : entry.half_extent_m) hold = hold && within(x, 0, kFarthest_m);
    return hold;
}

bool entry_holds(const ChunkEntry& entry, const FileHeader& h) {
    const std::size_t expected = entry.vertex_count * sizeof(ChunkVertex) + (entry.level == 0 ? kLeafPostBytes : 0);
    return entry.vertex_count <= kMaxChunkVertices && entry.bytes == expected && entry.offset <= h.file_bytes &&
           entry.bytes <= h.file_bytes - entry.offset && measures_hold(entry);
}

}  // namespace

const char* to_string(TdbError error) noexcept {
    switch (error) {
        case TdbError::none: return "is sound";
        case TdbError::unreadable: return "cannot be read";
        case TdbError::not_a_tdb: return "is not a terrain database";
        case TdbError::wrong_version: return "was written by another version of the terrain builder";
        case TdbError::truncated: return "is shorter than its header says";
        case TdbError::header_damaged: return "has a damaged header";
        case TdbError::directory_damaged: return "has a damaged directory";
        case TdbError::chunk_damaged: return "has a damaged chunk";
        case TdbError::too_large: return "does not fit the memory budget for terrain directories";
    }
    return "is unknown";
}

base::Result<TerrainDatabase, TdbFailure> TerrainDatabase::open(base::ByteSource& source, base::Arena& arena) {
    TerrainDatabase db;
    db.source_ = &source;
    FileHeader& h = db.header_;
    if (source.size() < sizeof h) return base::fail(TdbFailure{TdbError::not_a_tdb, 0});
    if (!source.read(0, &h, sizeof h)) return base::fail(TdbFailure{TdbError::unreadable, 0});
    if (std::memcmp(h.magic, kTdbMagic, sizeof kTdbMagic) != 0) return base::fail(TdbFailure{TdbError::not_a_tdb, 0});
    if (h.version != kTdbVersion) return base::fail(TdbFailure{TdbError::wrong_version, offsetof(FileHeader, version)});
    if (base::crc32(&h, offsetof(FileHeader, header_crc)) != h.header_crc || !ranges_hold(h) ||
        expected_chunks(h) != h.chunk_count)
        return base::fail(TdbFailure{TdbError::header_damaged, 0});
    if (source.size() != h.file_bytes) return base::fail(TdbFailure{TdbError::truncated, source.size()});

    const std::uint64_t directory_bytes = std::uint64_t{h.chunk_count} * sizeof(ChunkEntry);
    const std::uint64_t grid_count = std::uint64_t{h.undulation_columns} * h.undulation_rows;
    if (sizeof h + directory_bytes > h.file_bytes || h.undulation_offset > h.file_bytes ||
        grid_count * sizeof(float) > h.file_bytes - h.undulation_offset)
        return base::fail(TdbFailure{TdbError::truncated, h.file_bytes});
    // What fits into the arena fits into a size.
    const auto entries_size = static_cast<std::size_t>(directory_bytes),
               grid_size = static_cast<std::size_t>(grid_count * sizeof(float));
    db.entries_ = arena.allocate_array<ChunkEntry>(h.chunk_count);
    db.undulation_ = arena.allocate_array<float>(static_cast<std::size_t>(grid_count));
    if (db.entries_.empty() || db.undulation_.empty()) return base::fail(TdbFailure{TdbError::too_large, 0});
    if (!source.read(sizeof h, db.entries_.data(), entries_size)) return base::fail(TdbFailure{TdbError::unreadable, sizeof h});
    if (!source.read(h.undulation_offset, db.undulation_.data(), grid_size))
        return base::fail(TdbFailure{TdbError::unreadable, h.undulation_offset});
    if (base::crc32(db.entries_.data(), entries_size) != h.directory_crc)
        return base::fail(TdbFailure{TdbError::directory_damaged, sizeof h});
    if (base::crc32(db.undulation_.data(), grid_size) != h.undulation_crc)
        return base::fail(TdbFailure{TdbError::directory_damaged, h.undulation_offset});
    for (std::uint32_t level = 0; level < h.levels; ++level)
        db.level_first_[level + 1] = db.level_first_[level] + db.grid_columns(level) * db.grid_rows(level);
    for (std::uint32_t index = 0; index < h.chunk_count; ++index) {
        const ChunkEntry& entry = db.entries_[index];
        if (!entry_holds(entry, h) || db.at(entry.level, entry.i, entry.j) != index)
            return base::fail(TdbFailure{TdbError::directory_damaged, sizeof h + std::uint64_t{index} * sizeof(ChunkEntry)});
    }
    return db;
}

std::uint32_t TerrainDatabase::grid_columns(std::uint32_t level) const { return chunks_across(header_.columns, level); }
std::uint32_t TerrainDatabase::grid_rows(std::uint32_t level) const { return chunks_across(header_.rows, level); }

ChunkIndex TerrainDatabase::at(std::uint32_t level, std::int64_t i, std::int64_t j) const {
    if (level >= header_.levels || i < 0 || j < 0 || i >= grid_columns(level) || j >= grid_rows(level)) return kNoChunk;
    return static_cast<ChunkIndex>(level_first_[level] + j * grid_columns(level) + i);
}

ChunkIndex TerrainDatabase::parent(ChunkIndex index) const {
    const ChunkEntry& e = entry(index);
    return at(e.level + 1u, e.i / 2, e.j / 2);
}

ChunkIndex TerrainDatabase::child(ChunkIndex index, std::uint32_t quadrant) const {
    const ChunkEntry& e = entry(index);
    return e.level == 0 ? kNoChunk
                        : at(e.level - 1u, std::int64_t{e.i} * 2 + (quadrant & 1u), std::int64_t{e.j} * 2 + (quadrant >> 1));
}

TdbFailure TerrainDatabase::read_chunk(ChunkIndex index, base::Span<std::uint8_t> destination) const {
    const ChunkEntry& e = entry(index);
    TEDAVIS_CHECK(destination.size() >= e.bytes);
    if (!source_->read(e.offset, destination.data(), e.bytes)) return {TdbError::unreadable, e.offset};
    if (base::crc32(destination.data(), e.bytes) != e.crc) return {TdbError::chunk_damaged, e.offset};
    return {};
}

earth::GeoidUndulation TerrainDatabase::undulation(double latitude_rad, double longitude_rad) const {
    const FileHeader& h = header_;
    // About the grid's middle, so that a grid of any width is met from either side.
    const double half_width_deg = 0.5 * h.undulation_step_deg * (h.undulation_columns - 1.0);
    const double west_offset_deg =
        std::remainder(base::degrees(longitude_rad) - h.undulation_west_deg - half_width_deg, 360.0) + half_width_deg;
    const double last_i = h.undulation_columns - 1.0, last_j = h.undulation_rows - 1.0;
    const double x = std::fmin(std::fmax(west_offset_deg / h.undulation_step_deg, 0.0), last_i);
    const double y =
        std::fmin(std::fmax((h.undulation_north_deg - base::degrees(latitude_rad)) / h.undulation_step_deg, 0.0), last_j);
    const double i = std::fmin(std::floor(x), last_i - 1), j = std::fmin(std::floor(y), last_j - 1);
    const auto corner = static_cast<std::size_t>(j) * h.undulation_columns + static_cast<std::size_t>(i);
    const double u = x - i, v = y - j;
    const double north = (1 - u) * undulation_[corner] + u * undulation_[corner + 1];
    const double south =
        (1 - u) * undulation_[corner + h.undulation_columns] + u * undulation_[corner + h.undulation_columns + 1];
    return {(1 - v) * north + v * south};
}

TerrainDatabase::LatticePoint TerrainDatabase::lattice_point(double latitude_rad, double longitude_rad) const {
    const FileHeader& h = header_;
    const double width_deg = h.step_lon_deg * (h.columns - 1);
    // The equal of the longitude nearest to the middle of the database, so that a database across the antimeridian works.
    const double middle_deg = h.west_deg + 0.5 * width_deg;
    const double east_deg = std::remainder(base::degrees(longitude_rad) - middle_deg, 360.0) + 0.5 * width_deg;
    LatticePoint point{east_deg / h.step_lon_deg, (h.north_deg - base::degrees(latitude_rad)) / h.step_lat_deg, false};
    // Degrees and radians do not convert back exactly: a border post asked for by its own place must count as inside.
    constexpr double kRounding = 1e-6;
    const double last_i = h.columns - 1.0, last_j = h.rows - 1.0;
    point.inside =
        point.i >= -kRounding && point.j >= -kRounding && point.i <= last_i + kRounding && point.j <= last_j + kRounding;
    if (point.inside) {
        point.i = std::fmin(std::fmax(point.i, 0.0), last_i);
        point.j = std::fmin(std::fmax(point.j, 0.0), last_j);
    }
    return point;
}

}  // namespace tedavis::terrain
