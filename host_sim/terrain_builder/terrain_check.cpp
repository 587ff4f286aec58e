#include "host_sim/terrain_builder/terrain_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>

#include "host_sim/atomic_file.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/terrain_builder/mesh_difference.hpp"
#include "host_sim/terrain_builder/part_store.hpp"
#include "host_sim/terrain_builder/terrain_build.hpp"
#include "host_sim/terrain_builder/verify_database.hpp"
#include "host_sim/terrain_builder/work_file.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/check.hpp"
#include "render_core/terrain/height_query.hpp"
#include "render_core/terrain/regular_chunk.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

std::string chunk_name(const ChunkEntry& e) {
    return std::to_string(e.level) + "/" + std::to_string(e.i) + "/" + std::to_string(e.j);
}

using Bytes = std::vector<std::uint8_t>;

/// Heights of posts from the exact chunks of a database that holds.
class ExactHeights {
public:
    explicit ExactHeights(const TerrainDatabase& database) : memory_(HeightQuery::bytes_needed()) {
        base::Arena arena(memory_.data(), memory_.size());
        TEDAVIS_CHECK(query_.start(database, arena));
    }

    /// None where the rasters have a coarser grid than the lattice and no post there.
    [[nodiscard]] std::optional<float> at(std::uint32_t i, std::uint32_t j) {
        const Lattice& lattice = query_.lattice();
        const ExactChunk chunk = query_.exact_chunk(std::min(i, lattice.columns() - 2), std::min(j, lattice.rows() - 2));
        if (chunk.entry == nullptr) return std::nullopt;
        const std::uint32_t level = chunk.entry->level;
        const PostRange posts = lattice.posts_of(key_of(*chunk.entry));
        const std::uint32_t cells_i = posts.i1 - posts.i0, cells_j = posts.j1 - posts.j0;
        const auto column = place_on_grid(i - posts.i0, cells_i, level), row = place_on_grid(j - posts.j0, cells_j, level);
        if (!column || !row) return std::nullopt;
        return chunk.vertices[regular_grid(cells_i, cells_j, level).index_of(*column, *row)].height_m;
    }

private:
    static std::optional<std::uint32_t> place_on_grid(std::uint32_t post, std::uint32_t cells, std::uint32_t level) {
        const std::uint32_t n = post == cells ? (cells + (1u << level) - 1) >> level : post >> level;
        return regular_post(n, cells, level) == post ? std::optional(n) : std::nullopt;
    }

    std::vector<std::uint8_t> memory_;
    HeightQuery query_;
};

/// Compares one chunk of the file with the same chunk built again. An empty reason means no difference.
class ChunkComparison {
public:
    ChunkComparison(const WorkFile& file, const OpenDatabase& fresh, ExactHeights& heights, const ChunkEntry& stated,
                    const ChunkEntry& expected)
        : file_(file), fresh_(fresh), heights_(heights), stated_(stated), expected_(expected), name_(chunk_name(expected)) {}

    [[nodiscard]] ChunkViolation run() const {
        if (stated_.vertex_count == 0) return {name_, "is missing", 0};
        Bytes payload;
        if (const char* fault = read(stated_.payload, payload); *fault != 0) return {name_, fault, 0};
        const Bytes expected = fresh_.read_part(expected_.payload);
        if (payload != expected) return difference(payload, expected);
        const double excess_m = largest_excess_m();
        if (excess_m > 0) return {name_, "its mesh is farther from the true surface than it states", excess_m};
        return same_description() ? attributes()
                                  : ChunkViolation{name_, "its entry in the directory differs from the rasters", 0};
    }

private:
    const char* read(const PartPlace& place, Bytes& bytes) const {
        const std::uint64_t size = file_.size();
        if (place.offset > size || place.bytes > size - place.offset) return "lies beyond the end of the file";
        bytes.resize(place.bytes);
        file_.read(place.offset, bytes.data(), bytes.size());
        return checksum(bytes.data(), bytes.size()) == place.crc ? "" : "checksum does not match its bytes";
    }
    [[nodiscard]] ChunkViolation difference(const Bytes& payload, const Bytes& expected) const {
        const auto vertices = [](const ChunkEntry& entry, const Bytes& bytes) {
            const std::size_t count = std::min<std::size_t>(entry.vertex_count, bytes.size() / sizeof(ChunkVertex));
            return ChunkVertices{{reinterpret_cast<const ChunkVertex*>(bytes.data()), count}, entry.centre_m};
        };
        const MeshDifference mesh = mesh_difference(vertices(stated_, payload), vertices(expected_, expected),
                                                    fresh_.database().lattice().posts_of(key_of(expected_)),
                                                    [this](std::uint32_t i, std::uint32_t j) { return heights_.at(i, j); });
        return {name_, mesh.has_other_posts ? "its mesh has other vertices than the rasters give" : "differs from the rasters",
                mesh.largest_m};
    }
    [[nodiscard]] double largest_excess_m() const {
        return std::max({expected_.above_m - stated_.above_m, expected_.below_m - stated_.below_m,
                         expected_.strip_above_m - stated_.strip_above_m, expected_.strip_below_m - stated_.strip_below_m,
                         expected_.bound_m - stated_.bound_m});
    }
    /// Everything of the entry but where its bytes lie.
    [[nodiscard]] bool same_description() const {
        ChunkEntry a = stated_, b = expected_;
        for (ChunkEntry* e : {&a, &b}) e->payload = e->attributes = e->drape = {};
        return std::memcmp(&a, &b, sizeof a) == 0;  // the bytes count. NOLINT(bugprone-suspicious-memory-comparison)
    }
    [[nodiscard]] ChunkViolation attributes() const {
        Bytes bytes;
        if (const char* fault = read(stated_.attributes, bytes); *fault != 0) return {name_ + " attributes", fault, 0};
        if (bytes != fresh_.read_part(expected_.attributes)) return {name_ + " attributes", "differ from the rasters", 0};
        return drape();
    }
    [[nodiscard]] ChunkViolation drape() const {
        Bytes bytes;
        if (const char* fault = read(stated_.drape, bytes); *fault != 0) return {name_ + " drape", fault, 0};
        // Without the image the drape cannot be compared.
        const bool is_known = fresh_.database().header().drape_posts != 0;
        if (is_known && bytes != fresh_.read_part(expected_.drape)) return {name_ + " drape", "differs from the image", 0};
        return {name_, "", 0};
    }

    const WorkFile& file_;
    const OpenDatabase& fresh_;
    ExactHeights& heights_;
    const ChunkEntry& stated_;
    const ChunkEntry& expected_;
    const std::string name_;
};

/// The file as bytes, before anything of it is believed.
struct StatedFile {
    WorkFile file;
    FileHeader header{};
    std::vector<std::uint64_t> table;

    explicit StatedFile(const std::string& path) : file(opened(path)) {
        if (file.size() < sizeof header) refuse_database(path, {TdbError::not_a_tdb, 0});
        file.read(0, &header, sizeof header);
        if (std::memcmp(header.magic, kTdbMagic, sizeof kTdbMagic) != 0) refuse_database(path, {TdbError::not_a_tdb, 0});
        if (header.version != kTdbVersion) refuse_database(path, {TdbError::wrong_version, offsetof(FileHeader, version)});
        const std::uint64_t end = header.page_table_offset + std::uint64_t{header.page_count} * sizeof(std::uint64_t);
        const bool has_table = header.page_count != 0 && header.page_table_offset <= file.size() && end <= file.size();
        if (!has_table || (sound_header() && header.file_bytes != file.size()))
            refuse_database(path, {TdbError::truncated, file.size()});
        table.resize(header.page_count);
        file.read(header.page_table_offset, table.data(), table.size() * sizeof(std::uint64_t));
    }
    [[nodiscard]] bool sound_header() const { return checksum(&header, offsetof(FileHeader, header_crc)) == header.header_crc; }
    [[nodiscard]] bool sound_table() const {
        return checksum(table.data(), table.size() * sizeof(std::uint64_t)) == header.page_table_crc;
    }
    static WorkFile opened(const std::string& path) {
        require_regular_file(path);
        return WorkFile::existing(path);
    }
    /// Of zeros where there is none.
    void read_page(std::uint32_t n, DirectoryPage& page) const {
        page = DirectoryPage{};
        const std::uint64_t size = file.size();
        if (table[n] != 0 && table[n] <= size && sizeof page <= size - table[n]) file.read(table[n], &page, sizeof page);
    }
};

/// Places, names and what the user said of the sources are the file's own; everything else follows from the rasters.
bool same_header(FileHeader stated, FileHeader expected) {
    if (expected.drape_posts == 0 && stated.drape_posts != 0) {  // the image was not given: its pages are the file's own
        stated.drape_posts = stated.drape_level = 0;
        stated.file_bytes = expected.file_bytes;
    }
    for (FileHeader* h : {&stated, &expected}) {
        h->page_table_crc = h->header_crc = 0;
        std::memset(h->source, 0, sizeof h->source);
        std::memset(h->vertical_datum, 0, sizeof h->vertical_datum);
    }
    return std::memcmp(&stated, &expected, sizeof stated) == 0;  // the bytes count. NOLINT(bugprone-suspicious-memory-comparison)
}

class Comparison {
public:
    Comparison(const StatedFile& stated, const OpenDatabase& fresh)
        : stated_(stated), fresh_(fresh), heights_(fresh.database()) {}

    TerrainCheck run() {
        check_frame();
        const auto page = std::make_unique<DirectoryPage>(), expected = std::make_unique<DirectoryPage>();
        for (std::uint32_t n = 0; n < stated_.header.page_count; ++n) {
            stated_.read_page(n, *page);
            *expected = DirectoryPage{};
            const bool exists = fresh_.database().has_page(n);
            if (exists) fresh_.read_page(n, *expected);
            constexpr std::size_t kStart = offsetof(DirectoryPage, level);
            const bool sound = checksum(&page->level, sizeof *page - kStart) == page->crc;
            expect(sound || (!exists && stated_.table[n] == 0), "directory page " + std::to_string(n),
                   "checksum does not match its bytes");
            for (std::uint32_t e = 0; e < kPageChunks * kPageChunks; ++e) compare(page->entries[e], expected->entries[e]);
        }
        return std::move(check_);
    }

private:
    void add(const ChunkViolation& violation) {
        ++check_.violations;
        check_.worst_excess_m = std::max(check_.worst_excess_m, violation.excess_m);
        if (check_.first.size() < kMaxReported) check_.first.push_back(violation);
    }
    void expect(bool holds, const std::string& part, const char* reason) {
        if (!holds) add({part, reason, 0});
    }

    void check_frame() {
        const FileHeader &h = stated_.header, &f = fresh_.database().header();
        expect(stated_.sound_header(), "header", "checksum does not match its bytes");
        expect(stated_.sound_table(), "page table", "checksum does not match its bytes");
        expect(same_header(h, f), "header", "differs from the rasters");
        const PartPlace expected{f.undulation_offset, f.undulation_columns * f.undulation_rows * 4, f.undulation_crc};
        Bytes grid(expected.bytes);
        const bool inside = h.undulation_offset <= h.file_bytes && grid.size() <= h.file_bytes - h.undulation_offset;
        if (inside) stated_.file.read(h.undulation_offset, grid.data(), grid.size());
        expect(inside && grid == fresh_.read_part(expected), "geoid undulation", "differs from EGM96");
    }

    void compare(const ChunkEntry& stated, const ChunkEntry& expected) {
        if (expected.vertex_count == 0) {
            expect(stated.vertex_count == 0, chunk_name(stated), "is no chunk of this terrain");
            return;
        }
        ++check_.chunks;
        const ChunkViolation violation = ChunkComparison(stated_.file, fresh_, heights_, stated, expected).run();
        if (!violation.reason.empty()) add(violation);
    }

    const StatedFile& stated_;
    const OpenDatabase& fresh_;
    ExactHeights heights_;
    TerrainCheck check_;
};

void require_same_lattice(const FileHeader& h, const TerrainSources& sources, const BuildOptions& options,
                          const std::string& name) {
    const FileHeader f = TerrainPlan(sources, options).fine.header;
    const bool same = h.columns == f.columns && h.rows == f.rows && std::abs(h.west_deg - f.west_deg) < 1e-9 &&
                      std::abs(h.north_deg - f.north_deg) < 1e-9 && std::abs(h.step_lon_deg - f.step_lon_deg) < 1e-12;
    if (!same)
        throw UserError(name + ": was not built from these rasters (other posts); name the rasters and options of its build");
}

/// Removes the folder in any case.
struct CheckFolder {
    std::string path;

    explicit CheckFolder(std::string folder) : path(std::move(folder)) { make_folder(path); }
    ~CheckFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    CheckFolder(const CheckFolder&) = delete;
    CheckFolder& operator=(const CheckFolder&) = delete;
};

}  // namespace

TerrainCheck check_terrain(const std::string& database, const TerrainSources& sources, const BuildOptions& options) {
    const StatedFile stated(database);
    require_same_lattice(stated.header, sources, options, database);
    const CheckFolder folder(database + ".check");
    const std::string fresh_path = folder.path + "/fresh.tdb";
    BuildOptions fresh = options;
    // Rasters do not tell their accuracy: where the caller does not either, what is stated stands.
    if (!fresh.le90_m && stated.sound_header()) fresh.le90_m = double{stated.header.le90_m};
    build_terrain(sources, fresh_path, fresh);
    return Comparison(stated, OpenDatabase(fresh_path)).run();
}

}  // namespace tedavis::host_sim
