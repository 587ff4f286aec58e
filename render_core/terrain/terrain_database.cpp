#include "render_core/terrain/terrain_database.hpp"

#include <cmath>
#include <cstddef>
#include <cstring>

#include "render_core/base/hash.hpp"
#include "render_core/base/units.hpp"
#include "render_core/terrain/regular_chunk.hpp"

namespace tedavis::terrain {
namespace {

constexpr std::uint32_t kMaxPosts = 1u << 24;  // a side; 2^24 posts of 1" circle the Earth twelve times
constexpr std::uint32_t kMaxUndulationSide = 1u << 13;
constexpr double kHighest_m = 12000, kFarthest_m = 1e7;
constexpr double kLargestError_m = 1e31;  // above what the builder states where every post is needed
constexpr double kRounding_deg = 1e-6;
constexpr std::uint32_t kLatticeFlags = kLatticeClosed | kLatticeNorthPole | kLatticeSouthPole;
constexpr std::uint8_t kChunkFlags = kChunkRegular | kChunkHasVoid | kChunkHasSea | kChunkHasLand;
constexpr std::uint32_t kFewestVertices = 4, kFewestTriangles = 2;

// Comparisons are written so that NaN fails them.
bool within(double value, double low, double high) { return value >= low && value <= high; }

/// Latitude of the last row that is no pole.
double last_regular_deg(const FileHeader& h) {
    const std::uint32_t poles =
        ((h.lattice_flags & kLatticeNorthPole) != 0 ? 1u : 0u) + ((h.lattice_flags & kLatticeSouthPole) != 0 ? 1u : 0u);
    return h.north_deg - h.step_lat_deg * (h.rows - 1.0 - poles);
}

bool lattice_holds(const FileHeader& h) {
    const bool sizes =
        h.columns >= 2 && h.rows >= 2 && h.columns <= kMaxPosts && h.rows <= kMaxPosts && h.levels >= 1 && h.levels <= kMaxLevels;
    const bool steps = h.step_lon_deg > 0 && h.step_lat_deg > 0 && h.step_lon_deg <= 90 && h.step_lat_deg <= 90;
    const bool flags = (h.lattice_flags & ~kLatticeFlags) == 0;
    if (!sizes || !steps || !flags) return false;
    const bool closed = (h.lattice_flags & kLatticeClosed) != 0, north = (h.lattice_flags & kLatticeNorthPole) != 0,
               south = (h.lattice_flags & kLatticeSouthPole) != 0;
    const double width_deg = h.step_lon_deg * (h.columns - 1.0), last_deg = last_regular_deg(h);
    const bool width = closed ? within(width_deg, 360 - kRounding_deg, 360 + kRounding_deg) : width_deg <= 360 + kRounding_deg;
    const bool first_row = north ? h.north_deg < 90 && h.rows >= 3 : h.north_deg <= 90;
    const bool last_row = south ? last_deg > -90 && h.rows >= 3 : last_deg >= -90 - kRounding_deg;
    return width && first_row && last_row && std::abs(h.west_deg) <= 360 && std::abs(h.north_deg) <= 90 &&
           last_deg <= h.north_deg;
}

bool grid_holds(const FileHeader& h) {
    return within(h.undulation_west_deg, -720, 720) && within(h.undulation_north_deg, -91, 91) &&
           within(h.undulation_step_deg, 1e-3, 10) && h.undulation_columns >= 2 && h.undulation_rows >= 2 &&
           h.undulation_columns <= kMaxUndulationSide && h.undulation_rows <= kMaxUndulationSide;
}

bool ranges_hold(const FileHeader& h) {
    const bool heights = h.min_height_m >= -kHighest_m && h.max_height_m <= kHighest_m && h.min_height_m <= h.max_height_m;
    bool errors = within(h.le90_m, 0, kHighest_m);
    for (std::uint32_t level = 0; level < kMaxLevels; ++level)
        errors = errors && (level >= h.levels || within(h.tolerance_m[level], 0, kLargestError_m));
    const bool names = h.source[sizeof h.source - 1] == 0 && h.vertical_datum[sizeof h.vertical_datum - 1] == 0;
    const bool pictures = (h.drape_posts == 0 || (h.drape_posts == kDrapePosts && h.drape_level < h.levels)) &&
                          within(h.light_azimuth_deg, -360, 360) && within(h.light_elevation_deg, -90, 90);
    return h.header_bytes == sizeof h && heights && errors && names && pictures &&
           h.void_posts <= std::uint64_t{h.columns} * h.rows;
}

std::uint32_t parts_across(std::uint32_t parts, std::uint32_t side) { return (parts + side - 1) / side; }

/// In 64 bits: what a lattice would count only if the header is sound.
bool counts_hold(const FileHeader& h) {
    std::uint64_t chunks = 0, pages = 0;
    for (std::uint32_t level = 0; level < h.levels; ++level) {
        const std::uint32_t across = parts_across(h.columns - 1, kChunkCells << level),
                            down = parts_across(h.rows - 1, kChunkCells << level);
        chunks += std::uint64_t{across} * down;
        pages += std::uint64_t{parts_across(across, kPageChunks)} * parts_across(down, kPageChunks);
    }
    return h.chunk_count >= 1 && h.chunk_count <= chunks && h.page_count == pages;
}

bool lies_inside(std::uint64_t offset, std::uint64_t bytes, const FileHeader& h) {
    return offset >= sizeof h && offset <= h.file_bytes && bytes <= h.file_bytes - offset;
}

bool part_fits(const PartPlace& place, std::uint64_t bytes, const FileHeader& h) {
    return place.bytes == 0 || (place.bytes == bytes && lies_inside(place.offset, bytes, h));
}

bool measures_hold(const ChunkEntry& e) {
    const float errors[] = {e.above_m, e.below_m, e.strip_above_m, e.strip_below_m, e.bound_m};
    bool hold = within(e.min_height_m, -kHighest_m, kHighest_m) && within(e.max_height_m, e.min_height_m, kHighest_m) &&
                within(e.le90_m, 0, kHighest_m) && e.bound_m >= e.above_m && e.bound_m >= e.below_m;
    for (const float x : errors) hold = hold && within(x, 0, kLargestError_m);
    for (const double x : e.centre_m) hold = hold && within(x, -kFarthest_m, kFarthest_m);
    for (const float x : e.axes) hold = hold && within(x, -1.001, 1.001);
    for (const float x : e.half_extent_m) hold = hold && within(x, 0, kFarthest_m);
    return hold;
}

bool counts_hold(const ChunkEntry& e, const Lattice& lattice) {
    const bool few = e.vertex_count >= kFewestVertices && e.vertex_count <= kMaxChunkVertices &&
                     e.border_count >= kFewestVertices && e.border_count <= e.vertex_count &&
                     e.triangle_count >= kFewestTriangles && e.triangle_count <= kMaxChunkTriangles &&
                     e.strip_count <= e.triangle_count;
    if (!few || (e.flags & kChunkRegular) == 0) return few;
    const PostRange posts = lattice.posts_of(key_of(e));
    const RegularGrid grid = regular_grid(posts.i1 - posts.i0, posts.j1 - posts.j0, e.level);
    return e.vertex_count == grid.vertex_count() && e.border_count == grid.border_count() &&
           e.triangle_count == grid.triangle_count();
}

/// All that the lattice has room for, or none; a chunk without children is exact, and thus regular.
bool children_hold(const ChunkEntry& e, const Lattice& lattice) {
    if (e.children == 0) return (e.flags & kChunkRegular) != 0;
    if (e.level == 0) return false;
    std::uint8_t possible = 0;
    for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant)
        if (lattice.contains(key_of(e).child(quadrant))) possible = static_cast<std::uint8_t>(possible | (1u << quadrant));
    return e.children == possible;
}

bool parts_hold(const ChunkEntry& e, const FileHeader& h) {
    const bool regular = (e.flags & kChunkRegular) != 0;
    const std::uint64_t payload =
        e.vertex_count * sizeof(ChunkVertex) + (regular ? 0 : e.triangle_count * 3 * sizeof(std::uint16_t));
    return e.payload.bytes != 0 && part_fits(e.payload, payload, h) &&
           part_fits(e.attributes, e.level == 0 ? 0 : sizeof(AttributePage), h) &&
           part_fits(e.drape, h.drape_posts == 0 || e.level < h.drape_level ? 0 : sizeof(DrapePage), h);
}

bool entry_holds(const ChunkEntry& e, const ChunkKey& key, const FileHeader& h, const Lattice& lattice) {
    if (e.vertex_count == 0) return true;
    return lattice.contains(key) && key_of(e) == key && (e.flags & ~kChunkFlags) == 0 && counts_hold(e, lattice) &&
           children_hold(e, lattice) && parts_hold(e, h) && measures_hold(e);
}

TdbError header_error(const FileHeader& h) {
    if (std::memcmp(h.magic, kTdbMagic, sizeof kTdbMagic) != 0) return TdbError::not_a_tdb;
    if (h.version != kTdbVersion) return TdbError::wrong_version;
    const bool holds = base::crc32(&h, offsetof(FileHeader, header_crc)) == h.header_crc && lattice_holds(h) && grid_holds(h) &&
                       ranges_hold(h) && counts_hold(h);
    return holds ? TdbError::none : TdbError::header_damaged;
}

const char* remedy(TdbError error) {
    switch (error) {
        case TdbError::unreadable: return "check the medium that holds it";
        case TdbError::not_a_tdb: return "name a file that 'tedavis terrain build' wrote";
        case TdbError::wrong_version: return "build it again with 'tedavis terrain build'";
        case TdbError::too_large: return "raise the budget lines for terrain in the device file";
        case TdbError::too_many_roots: return "raise 'max_chunk_slots' in the device file";
        default: return "get a whole copy, or build it again with 'tedavis terrain build'";
    }
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
        case TdbError::too_large: return "does not fit the memory budget for terrain";
        case TdbError::too_many_roots: return "has more chunks at its top level than there are slots for";
    }
    return "is unknown";
}

base::FaultText describe(const TdbFailure& failure) noexcept {
    return base::fault_text(to_string(failure.error), failure.offset, remedy(failure.error));
}

base::Result<TerrainDatabase, TdbFailure> TerrainDatabase::open(base::ByteSource& source, base::Arena& arena) {
    TerrainDatabase db;
    db.source_ = &source;
    FileHeader& h = db.header_;
    if (source.size() < sizeof h) return base::fail(TdbFailure{TdbError::not_a_tdb, 0});
    if (!source.read(0, &h, sizeof h)) return base::fail(TdbFailure{TdbError::unreadable, 0});
    if (const TdbError error = header_error(h); error != TdbError::none)
        return base::fail(TdbFailure{error, error == TdbError::wrong_version ? offsetof(FileHeader, version) : 0});
    if (source.size() != h.file_bytes) return base::fail(TdbFailure{TdbError::truncated, source.size()});
    db.lattice_ = Lattice(h);

    const std::uint64_t grid_count = std::uint64_t{h.undulation_columns} * h.undulation_rows;
    const std::uint64_t grid_bytes = grid_count * sizeof(float), table_bytes = h.page_count * sizeof(std::uint64_t);
    if (!lies_inside(h.undulation_offset, grid_bytes, h) || !lies_inside(h.page_table_offset, table_bytes, h))
        return base::fail(TdbFailure{TdbError::header_damaged, 0});
    // What fits into the arena fits into a size.
    db.page_table_ = arena.allocate_array<std::uint64_t>(h.page_count);
    db.undulation_ = arena.allocate_array<float>(static_cast<std::size_t>(grid_count));
    if (db.page_table_.empty() || db.undulation_.empty()) return base::fail(TdbFailure{TdbError::too_large, 0});
    if (const TdbFailure failure = db.read_tables(); failure.error != TdbError::none) return base::fail(failure);
    return db;
}

TdbFailure TerrainDatabase::read_tables() {
    const FileHeader& h = header_;
    const std::size_t grid_bytes = undulation_.size() * sizeof(float), table_bytes = page_table_.size() * sizeof(std::uint64_t);
    if (!source_->read(h.undulation_offset, undulation_.data(), grid_bytes)) return {TdbError::unreadable, h.undulation_offset};
    if (!source_->read(h.page_table_offset, page_table_.data(), table_bytes)) return {TdbError::unreadable, h.page_table_offset};
    if (base::crc32(undulation_.data(), grid_bytes) != h.undulation_crc)
        return {TdbError::directory_damaged, h.undulation_offset};
    if (base::crc32(page_table_.data(), table_bytes) != h.page_table_crc)
        return {TdbError::directory_damaged, h.page_table_offset};
    for (const float undulation : undulation_)
        if (!within(undulation, -kHighest_m, kHighest_m)) return {TdbError::directory_damaged, h.undulation_offset};
    for (const std::uint64_t offset : page_table_)
        if (offset != 0 && !lies_inside(offset, sizeof(DirectoryPage), h))
            return {TdbError::directory_damaged, h.page_table_offset};
    return {};
}

std::uint32_t TerrainDatabase::root_count() const { return lattice_.grid_columns(top_level()) * lattice_.grid_rows(top_level()); }

TdbFailure TerrainDatabase::read_page(std::uint32_t page_index, DirectoryPage& page) const {
    if (!source_->read(page_offset(page_index), &page, sizeof page)) return {TdbError::unreadable, page_offset(page_index)};
    return check_page(page_index, page);
}

TdbFailure TerrainDatabase::check_page(std::uint32_t page_index, const DirectoryPage& page) const {
    const TdbFailure damaged{TdbError::directory_damaged, page_offset(page_index)};
    constexpr std::size_t kStart = offsetof(DirectoryPage, level);
    if (base::crc32(&page.level, sizeof page - kStart) != page.crc) return damaged;
    if (page.level >= levels() || page.i >= lattice_.page_columns(page.level) || page.j >= lattice_.page_rows(page.level) ||
        lattice_.page_index({page.level, page.i * kPageChunks, page.j * kPageChunks}) != page_index)
        return damaged;
    for (std::uint32_t n = 0; n < kPageChunks * kPageChunks; ++n) {
        const ChunkKey key{page.level, page.i * kPageChunks + n % kPageChunks, page.j * kPageChunks + n / kPageChunks};
        if (!entry_holds(page.entries[n], key, header_, lattice_))
            return {TdbError::directory_damaged,
                    page_offset(page_index) + offsetof(DirectoryPage, entries) + n * sizeof(ChunkEntry)};
    }
    return {};
}

TdbFailure TerrainDatabase::read_part(const PartPlace& place, base::Span<std::uint8_t> destination) const {
    TEDAVIS_CHECK(destination.size() >= place.bytes);
    if (!source_->read(place.offset, destination.data(), place.bytes)) return {TdbError::unreadable, place.offset};
    return check_part(place, destination);
}

TdbFailure TerrainDatabase::check_part(const PartPlace& place, base::Span<const std::uint8_t> bytes) {
    TEDAVIS_CHECK(bytes.size() >= place.bytes);
    if (base::crc32(bytes.data(), place.bytes) != place.crc) return {TdbError::chunk_damaged, place.offset};
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

}  // namespace tedavis::terrain
