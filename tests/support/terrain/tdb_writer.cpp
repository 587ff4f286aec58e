#include "tests/support/terrain/tdb_writer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <glm/geometric.hpp>
#include <unordered_set>

#include "render_core/base/hash.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/terrain/chunk_mesh.hpp"
#include "render_core/terrain/regular_chunk.hpp"
#include "tests/support/terrain/surface_gap.hpp"

namespace tedavis::test_support {

using namespace terrain;

namespace {

constexpr double kGridStep_deg = 10;
constexpr std::uint32_t kGridColumns = 37, kGridRows = 19;

void append(std::vector<std::uint8_t>& bytes, const void* data, std::size_t count) {
    const std::size_t at = bytes.size();
    bytes.resize(at + count);
    if (count > 0) std::memcpy(bytes.data() + at, data, count);
}

std::uint64_t packed(const std::uint16_t* corners) {
    return (std::uint64_t{corners[0]} << 32) | (std::uint64_t{corners[1]} << 16) | corners[2];
}

/// Those triangles that are not among others.
std::vector<std::uint16_t> without(const std::vector<std::uint16_t>& indices, const std::unordered_set<std::uint64_t>& others) {
    std::vector<std::uint16_t> left;
    for (auto corners = indices.begin(); corners != indices.end(); corners += 3)
        if (others.count(packed(&*corners)) == 0) left.insert(left.end(), corners, corners + 3);
    return left;
}

}  // namespace

TdbSpec whole_earth(std::uint32_t columns, std::uint32_t rows) {
    TdbSpec spec;
    spec.columns = columns;
    spec.rows = rows;
    spec.west_deg = -180;
    spec.step_lon_deg = 360.0 / (columns - 1);
    spec.step_lat_deg = 180.0 / (rows - 1);
    spec.north_deg = 90 - spec.step_lat_deg;
    spec.lattice_flags = kLatticeClosed | kLatticeNorthPole | kLatticeSouthPole;
    return spec;
}

double WrittenTdb::undulation_m(double latitude_rad) { return 20 + 0.1 * base::degrees(latitude_rad); }

WrittenTdb::WrittenTdb(TdbSpec spec) : spec_(std::move(spec)) {
    header_.columns = spec_.columns;
    header_.rows = spec_.rows;
    header_.west_deg = spec_.west_deg;
    header_.north_deg = spec_.north_deg;
    header_.step_lon_deg = spec_.step_lon_deg;
    header_.step_lat_deg = spec_.step_lat_deg;
    header_.lattice_flags = spec_.lattice_flags;
    header_.levels = spec_.levels;
    while (spec_.levels == 0) {
        const std::uint32_t cells = kChunkCells << header_.levels++;
        if (cells >= spec_.columns - 1 && cells >= spec_.rows - 1) break;
    }
    lattice_ = Lattice(header_);
    // The largest chunk's coordinates must fit the 24 bits of a float.
    const double extent_m = 111320.0 * std::max(spec_.step_lon_deg, spec_.step_lat_deg) * (kChunkCells << (header_.levels - 1));
    while (std::min(extent_m, 1.3e7) > 8000 * 1024 * quantum_m_) quantum_m_ *= 2;
    find_chunks();
    sample_heights();
    for (const ChunkKey& key : keys_) make_chunk(key);
    if (spec_.measured) {
        for (const ChunkKey& key : keys_) measure(key);
        for (const ChunkKey& key : keys_) bound(key);
    }
    assemble();
    memory_.resize(1 << 20);
    EXPECT_EQ(reopen().error, TdbError::none);
}

TdbFailure WrittenTdb::reopen() {
    base::Arena arena(memory_.data(), memory_.size());
    auto opened = TerrainDatabase::open(source_, arena);
    if (!opened.ok()) return opened.error();
    database_ = std::make_unique<TerrainDatabase>(opened.value());
    return {};
}

void WrittenTdb::find_chunks() {
    const std::uint32_t top = header_.levels - 1;
    for (std::uint32_t j = 0; j < lattice_.grid_rows(top); ++j)
        for (std::uint32_t i = 0; i < lattice_.grid_columns(top); ++i) keys_.push_back({top, i, j});
    for (std::size_t n = 0; n < keys_.size(); ++n) {
        const ChunkKey key = keys_[n];
        Chunk& chunk = chunks_[key.packed()];
        if (key.level == 0 || (spec_.is_exact && spec_.is_exact(key))) continue;
        for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant) {
            if (!lattice_.contains(key.child(quadrant))) continue;
            chunk.entry.children = static_cast<std::uint8_t>(chunk.entry.children | (1u << quadrant));
            keys_.push_back(key.child(quadrant));
        }
    }
}

void WrittenTdb::sample_heights() {
    heights_.resize(std::size_t{spec_.columns} * spec_.rows);
    const auto at = [&](std::uint32_t i, std::uint32_t j) -> double& { return heights_[std::size_t{j} * spec_.columns + i]; };
    for (std::uint32_t j = 0; j < spec_.rows; ++j)
        for (std::uint32_t i = 0; i < spec_.columns; ++i) {
            const bool pole = ((spec_.lattice_flags & kLatticeNorthPole) != 0 && j == 0) ||
                              ((spec_.lattice_flags & kLatticeSouthPole) != 0 && j == spec_.rows - 1);
            const std::uint32_t column = pole || (lattice_.is_closed() && i == spec_.columns - 1) ? 0 : i;
            at(i, j) = double{static_cast<float>(spec_.height_m(column, j))};
        }
    for (const ChunkKey& key : keys_)
        if (key.level != 0 && chunks_.at(key.packed()).entry.children == 0) flatten_exact_chunk(key);
    for (std::uint32_t j = 0; j < spec_.rows; ++j)
        for (std::uint32_t i = 0; i < spec_.columns; ++i) {
            const double surface_m = at(i, j) + undulation_m(lattice_.latitude_rad(j));
            positions_.push_back(lattice_.position(i, j, surface_m));
            ups_.push_back(glm::normalize(lattice_.position(i, j, 10000) - lattice_.position(i, j, 0)));
        }
}

/// Between its own posts the surface of an exact chunk above level 0 is flat.
void WrittenTdb::flatten_exact_chunk(const ChunkKey& key) {
    const PostRange posts = lattice_.posts_of(key);
    const std::uint32_t side = 1u << key.level;
    const auto at = [&](std::uint32_t i, std::uint32_t j) -> double& { return heights_[std::size_t{j} * spec_.columns + i]; };
    for (std::uint32_t j = posts.j0; j < posts.j1; j += side)
        for (std::uint32_t i = posts.i0; i < posts.i1; i += side)
            for (std::uint32_t b = 0; b <= side; ++b)
                for (std::uint32_t a = 0; a <= side; ++a) {
                    const double u = double(a) / side, v = double(b) / side;
                    const double nw = at(i, j), ne = at(i + side, j), sw = at(i, j + side), se = at(i + side, j + side);
                    const bool corner = (a % side) == 0 && (b % side) == 0;
                    if (corner) continue;
                    at(i + a, j + b) =
                        u + v <= 1 ? nw + u * (ne - nw) + v * (sw - nw) : se + (1 - u) * (sw - se) + (1 - v) * (ne - se);
                }
}

void WrittenTdb::make_chunk(const ChunkKey& key) {
    Chunk& chunk = chunks_.at(key.packed());
    ChunkEntry& entry = chunk.entry;
    const PostRange posts = lattice_.posts_of(key);
    const std::uint32_t cells_i = posts.i1 - posts.i0, cells_j = posts.j1 - posts.j0;
    const RegularGrid grid = regular_grid(cells_i, cells_j, key.level);
    entry.level = static_cast<std::uint8_t>(key.level);
    entry.i = key.i;
    entry.j = key.j;
    entry.vertex_count = static_cast<std::uint16_t>(grid.vertex_count());
    entry.border_count = static_cast<std::uint16_t>(grid.border_count());
    entry.triangle_count = static_cast<std::uint16_t>(grid.triangle_count());
    entry.flags = entry.children == 0 ? kChunkRegular : 0;
    make_box(chunk, posts);
    chunk.vertices.resize(grid.vertex_count());
    float low = 1e9f, high = -1e9f;
    for (std::uint32_t b = 0; b < grid.rows; ++b)
        for (std::uint32_t a = 0; a < grid.columns; ++a) {
            const std::uint32_t i = regular_post(a, cells_i, key.level), j = regular_post(b, cells_j, key.level);
            const std::uint32_t global_i = posts.i0 + i, global_j = posts.j0 + j, coarser = (2u << key.level) - 1;
            const bool side = i == 0 || j == 0 || i == cells_i || j == cells_j;
            const bool kept = ((global_i & coarser) == 0 || global_i == spec_.columns - 1) &&
                              ((global_j & coarser) == 0 || global_j == spec_.rows - 1);
            const earth::Ecef place = position(global_i, global_j);
            ChunkVertex& v = chunk.vertices[grid.index_of(a, b)];
            v.x = static_cast<float>(std::round(place.x / quantum_m_) * quantum_m_ - entry.centre_m[0]);
            v.y = static_cast<float>(std::round(place.y / quantum_m_) * quantum_m_ - entry.centre_m[1]);
            v.z = static_cast<float>(std::round(place.z / quantum_m_) * quantum_m_ - entry.centre_m[2]);
            v.height_m = static_cast<float>(height_m(global_i, global_j));
            const earth::Ecef& up = ups_[std::size_t{global_j} * spec_.columns + global_i];
            for (int n = 0; n < 3; ++n) v.normal[n] = static_cast<std::int8_t>(std::lround(127 * up[n]));
            const PostClass kind = spec_.post_class ? spec_.post_class(global_i, global_j) : PostClass::land;
            v.kind = static_cast<std::uint8_t>(static_cast<unsigned>(kind) | (side && kept ? 4u : 0u));
            v.i = static_cast<std::uint16_t>(i);
            v.j = static_cast<std::uint16_t>(j);
            entry.flags = static_cast<std::uint8_t>(entry.flags | (kind == PostClass::land  ? kChunkHasLand
                                                                   : kind == PostClass::sea ? kChunkHasSea
                                                                                            : kChunkHasVoid));
            low = std::min(low, v.height_m);
            high = std::max(high, v.height_m);
        }
    entry.min_height_m = low;
    entry.max_height_m = high;
    make_triangles(chunk);
}

void WrittenTdb::make_box(Chunk& chunk, const PostRange& posts) const {
    ChunkEntry& entry = chunk.entry;
    const std::uint32_t middle_i = (posts.i0 + posts.i1) / 2, middle_j = (posts.j0 + posts.j1) / 2;
    const glm::dmat3 axes = earth::north_east_down(lattice_.latitude_rad(middle_j), lattice_.longitude_rad(middle_i));
    glm::dvec3 low(1e12), high(-1e12);
    for (std::uint32_t j = posts.j0; j <= posts.j1; ++j)
        for (std::uint32_t i = posts.i0; i <= posts.i1; ++i) {
            const glm::dvec3 along = glm::transpose(axes) * position(i, j);
            low = glm::dvec3(std::min(low.x, along.x), std::min(low.y, along.y), std::min(low.z, along.z));
            high = glm::dvec3(std::max(high.x, along.x), std::max(high.y, along.y), std::max(high.z, along.z));
        }
    const glm::dvec3 centre = axes * (0.5 * (low + high));
    const double whole_m = std::max(1.0, quantum_m_);
    for (int n = 0; n < 3; ++n) {
        entry.centre_m[n] = std::round(centre[n] / whole_m) * whole_m;
        entry.half_extent_m[n] = static_cast<float>(0.5 * (high[n] - low[n]) + 2 * whole_m);
        for (int m = 0; m < 3; ++m) entry.axes[3 * n + m] = static_cast<float>(axes[n][m]);
    }
}

/// Those of the regular grid, strips first.
void WrittenTdb::make_triangles(Chunk& chunk) const {
    ChunkEntry regular = chunk.entry;
    regular.flags |= kChunkRegular;
    const auto scratch = std::make_unique<ChunkMeshScratch>();
    std::vector<std::uint16_t> all(std::size_t{chunk.entry.triangle_count} * 3), strips, others;
    const PostRange posts = lattice_.posts_of(key_of(regular));
    const RegularGrid grid = regular_grid(posts.i1 - posts.i0, posts.j1 - posts.j0, regular.level);
    all.clear();
    for (std::uint32_t b = 0; b + 1 < grid.rows; ++b)
        for (std::uint32_t a = 0; a + 1 < grid.columns; ++a)
            for (const auto& [da, db] : {std::pair{0u, 0u}, {0u, 1u}, {1u, 0u}, {1u, 0u}, {0u, 1u}, {1u, 1u}})
                all.push_back(static_cast<std::uint16_t>(grid.index_of(a + da, b + db)));
    for (std::size_t n = 0; n < all.size(); n += 3) {
        const bool touches = std::any_of(all.begin() + n, all.begin() + n + 3, [&](std::uint16_t index) {
            return index < regular.border_count && !chunk.vertices[index].stays_beside_coarser();
        });
        std::vector<std::uint16_t>& to = touches ? strips : others;
        to.insert(to.end(), all.begin() + n, all.begin() + n + 3);
    }
    chunk.entry.strip_count = static_cast<std::uint16_t>(strips.size() / 3);
    if (chunk.entry.children == 0) return;
    chunk.stored = strips;
    chunk.stored.insert(chunk.stored.end(), others.begin(), others.end());
}

earth::Ecef WrittenTdb::position(std::uint32_t i, std::uint32_t j) const {
    return positions_[std::size_t{j} * spec_.columns + i];
}

std::vector<ChunkKey> WrittenTdb::keys() const { return keys_; }
std::vector<ChunkVertex> WrittenTdb::vertices(const ChunkKey& key) const { return chunks_.at(key.packed()).vertices; }

std::vector<std::uint16_t> WrittenTdb::indices(const ChunkKey& key, std::uint8_t coarser_edges) const {
    const Chunk& chunk = chunks_.at(key.packed());
    static const auto scratch = std::make_unique<ChunkMeshScratch>();
    std::vector<std::uint16_t> indices(kMaxChunkTriangles * 3);
    const MeshCount count = build_chunk_indices(chunk.entry, {chunk.vertices.data(), chunk.vertices.size()},
                                                {chunk.stored.data(), chunk.stored.size()}, coarser_edges, *scratch,
                                                {indices.data(), indices.size()});
    EXPECT_TRUE(count.sound);
    indices.resize(count.indices);
    return indices;
}

void WrittenTdb::measure(const ChunkKey& key) {
    Chunk& chunk = chunks_.at(key.packed());
    ChunkEntry& entry = chunk.entry;
    const auto gap_of = [&](const std::vector<std::uint16_t>& indices) {
        return surface_gap({lattice_, spec_.columns, positions_, ups_}, entry, chunk.vertices, indices);
    };
    const auto stored = [](double error_m) { return std::nextafter(static_cast<float>(error_m), 1e30f); };
    const std::vector<std::uint16_t> all = indices(key, 0);
    const SurfaceGap own = gap_of(all);
    SurfaceGap strips = own;
    std::unordered_set<std::uint64_t> known;
    for (std::size_t n = 0; n < all.size(); n += 3) known.insert(packed(&all[n]));
    for (std::uint8_t edges = 1; edges < 16; ++edges) {
        const SurfaceGap gap = gap_of(without(indices(key, edges), known));
        strips.above_m = std::max(strips.above_m, gap.above_m);
        strips.below_m = std::max(strips.below_m, gap.below_m);
    }
    entry.above_m = stored(own.above_m);
    entry.below_m = stored(own.below_m);
    entry.strip_above_m = stored(strips.above_m);
    entry.strip_below_m = stored(strips.below_m);
}

void WrittenTdb::bound(const ChunkKey& key) {
    ChunkEntry& entry = chunks_.at(key.packed()).entry;
    entry.bound_m = std::max(entry.above_m, entry.below_m);
    for (const EdgeBit side : {kEdgeNorth, kEdgeEast, kEdgeSouth, kEdgeWest}) {
        const ChunkKey beside = lattice_.neighbour(key, side);
        for (std::uint32_t quadrant = 0; key.level > 0 && beside != kNoChunk && quadrant < 4; ++quadrant) {
            if (!has(beside.child(quadrant))) continue;
            const ChunkEntry& finer = this->entry(beside.child(quadrant));
            entry.bound_m = std::max({entry.bound_m, finer.strip_above_m, finer.strip_below_m});
        }
    }
}

void WrittenTdb::assemble() {
    std::memcpy(header_.magic, kTdbMagic, sizeof kTdbMagic);
    header_.version = kTdbVersion;
    header_.header_bytes = sizeof(FileHeader);
    header_.chunk_count = keys_.size();
    header_.min_height_m = static_cast<float>(*std::min_element(heights_.begin(), heights_.end()));
    header_.max_height_m = static_cast<float>(*std::max_element(heights_.begin(), heights_.end()));
    header_.page_count = lattice_.page_count();
    header_.drape_posts = spec_.drape_level ? kDrapePosts : 0;
    header_.drape_level = static_cast<std::uint16_t>(spec_.drape_level.value_or(0));
    header_.undulation_west_deg = -180;
    header_.undulation_north_deg = 90;
    header_.undulation_step_deg = kGridStep_deg;
    header_.undulation_columns = kGridColumns;
    header_.undulation_rows = kGridRows;
    std::strcpy(header_.source, "test");
    std::strcpy(header_.vertical_datum, "egm96");
    bytes.assign(sizeof(FileHeader), 0);

    std::vector<float> grid;
    for (std::uint32_t j = 0; j < kGridRows; ++j)
        grid.insert(grid.end(), kGridColumns, static_cast<float>(undulation_m(base::radians(90 - kGridStep_deg * j))));
    header_.undulation_offset = bytes.size();
    append(bytes, grid.data(), grid.size() * sizeof(float));
    header_.undulation_crc = base::crc32(grid.data(), grid.size() * sizeof(float));

    std::vector<std::uint64_t> table(header_.page_count);
    std::map<std::uint32_t, std::unique_ptr<DirectoryPage>> pages;
    for (const ChunkKey& key : keys_) {
        Chunk& chunk = chunks_.at(key.packed());
        std::vector<std::uint8_t> payload;
        append(payload, chunk.vertices.data(), chunk.vertices.size() * sizeof(ChunkVertex));
        append(payload, chunk.stored.data(), chunk.stored.size() * sizeof(std::uint16_t));
        chunk.entry.payload = {bytes.size(), static_cast<std::uint32_t>(payload.size()),
                               base::crc32(payload.data(), payload.size())};
        append(bytes, payload.data(), payload.size());
        if (spec_.attributes && key.level > 0) {
            const std::vector<std::uint8_t> page(sizeof(AttributePage), static_cast<std::uint8_t>(key.packed() % 251));
            chunk.entry.attributes = {bytes.size(), static_cast<std::uint32_t>(page.size()),
                                      base::crc32(page.data(), page.size())};
            append(bytes, page.data(), page.size());
        }
        if (spec_.drape_level && key.level >= *spec_.drape_level) {
            const std::vector<std::uint8_t> page(sizeof(DrapePage), drape_code(key));
            chunk.entry.drape = {bytes.size(), static_cast<std::uint32_t>(page.size()), base::crc32(page.data(), page.size())};
            append(bytes, page.data(), page.size());
        }
        auto& page = pages[lattice_.page_index(key)];
        if (page == nullptr) {
            page = std::make_unique<DirectoryPage>();
            page->level = key.level;
            page->i = key.i / kPageChunks;
            page->j = key.j / kPageChunks;
        }
        page->entries[Lattice::index_in_page(key)] = chunk.entry;
    }
    for (auto& [index, page] : pages) {
        page->crc = base::crc32(&page->level, sizeof(DirectoryPage) - offsetof(DirectoryPage, level));
        bytes.resize((bytes.size() + 7) / 8 * 8);
        table[index] = bytes.size();
        append(bytes, page.get(), sizeof(DirectoryPage));
    }
    header_.page_table_offset = bytes.size();
    append(bytes, table.data(), table.size() * sizeof(std::uint64_t));
    header_.page_table_crc = base::crc32(table.data(), table.size() * sizeof(std::uint64_t));
    header_.file_bytes = bytes.size();
    std::memcpy(bytes.data(), &header_, sizeof header_);
    sign_header();
}

void WrittenTdb::sign_header() { header().header_crc = base::crc32(bytes.data(), offsetof(FileHeader, header_crc)); }

DirectoryPage& WrittenTdb::page(const ChunkKey& key) {
    std::uint64_t offset = 0;
    std::memcpy(&offset, bytes.data() + header().page_table_offset + lattice_.page_index(key) * sizeof offset, sizeof offset);
    return *reinterpret_cast<DirectoryPage*>(bytes.data() + offset);
}

ChunkEntry& WrittenTdb::entry_in_file(const ChunkKey& key) { return page(key).entries[Lattice::index_in_page(key)]; }

void WrittenTdb::sign_page(const ChunkKey& key) {
    DirectoryPage& signed_page = page(key);
    signed_page.crc = base::crc32(&signed_page.level, sizeof(DirectoryPage) - offsetof(DirectoryPage, level));
}

}  // namespace tedavis::test_support
