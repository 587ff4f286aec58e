/// How many triangles the chunks of each level have, borders included, against one greedy Delaunay triangulation of the whole
/// raster that is as near at the posts: to the level's tolerance, or to what its meshes reach where that is worse. Takes a .tdb
/// whose posts all lie at level 0; without one, the shipped terrain is built. `--json` prints the lines as a list.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "platform/files/file_byte_source.hpp"
#include "render_core/terrain/chunk_mesh.hpp"
#include "render_core/terrain/terrain_database.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/bench/reference_triangulation.hpp"
#include "tests/support/files/memory_bytes.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/terrain/terrain_image.hpp"

namespace {

using namespace tedavis;
using namespace tedavis::terrain;
using bench::BenchResult;

constexpr double kMaxMore = 1.25;  ///< of the reference's triangles
constexpr std::size_t kIndexBytes = 64u << 20;

struct Failure {
    std::string message;
};

/// An opened database; chunks are read where they are asked for.
class Terrain {
public:
    Terrain(base::ByteSource& source, const std::string& name) : memory_(kIndexBytes), arena_(memory_.data(), memory_.size()) {
        auto opened = TerrainDatabase::open(source, arena_);
        if (!opened.ok()) throw Failure{name + ": " + to_string(opened.error().error)};
        database_ = opened.value();
    }

    [[nodiscard]] const FileHeader& header() const { return database_.header(); }

    struct Chunk {
        ChunkEntry entry{};
        PostRange posts;
        std::vector<ChunkVertex> vertices;
        std::vector<std::uint16_t> triangles;
    };

    template <class F>
    void for_each_chunk(std::uint32_t level, F f) {
        const Lattice& lattice = database_.lattice();
        for (std::uint32_t j = 0; j < lattice.grid_rows(level); ++j)
            for (std::uint32_t i = 0; i < lattice.grid_columns(level); ++i) f(read({level, i, j}));
    }

private:
    [[nodiscard]] Chunk read(const ChunkKey& key) {
        const std::uint32_t page = database_.lattice().page_index(key);
        if (page != page_index_) check(database_.has_page(page) ? database_.read_page(page, *page_).error : TdbError::none);
        page_index_ = page;
        Chunk chunk;
        if (database_.has_page(page)) chunk.entry = page_->entries[Lattice::index_in_page(key)];
        if (chunk.entry.vertex_count == 0)
            throw Failure{"level " + std::to_string(key.level) + " has gaps; give a database of one raster"};
        chunk.posts = database_.lattice().posts_of(key);
        payload_.resize(chunk.entry.payload.bytes);
        check(database_.read_part(chunk.entry.payload, {payload_.data(), payload_.size()}).error);
        chunk.vertices.resize(chunk.entry.vertex_count);
        const std::size_t vertex_bytes = chunk.vertices.size() * sizeof(ChunkVertex);
        std::memcpy(chunk.vertices.data(), payload_.data(), vertex_bytes);
        chunk.triangles.resize((payload_.size() - vertex_bytes) / sizeof(std::uint16_t));
        if (!chunk.triangles.empty())
            std::memcpy(chunk.triangles.data(), payload_.data() + vertex_bytes, payload_.size() - vertex_bytes);
        return chunk;
    }

    static void check(TdbError error) {
        if (error != TdbError::none) throw Failure{std::string("the database ") + to_string(error)};
    }

    std::vector<std::uint8_t> memory_, payload_;
    base::Arena arena_;
    TerrainDatabase database_;
    std::unique_ptr<DirectoryPage> page_ = std::make_unique<DirectoryPage>();
    std::uint32_t page_index_ = 0xFFFFFFFFu;
};

/// The true surface, from the exact chunks of level 0. Above MSL: undulation bends less than any tolerance.
bench::HeightField field_of(Terrain& terrain) {
    bench::HeightField field;
    field.columns = static_cast<std::int32_t>(terrain.header().columns);
    field.rows = static_cast<std::int32_t>(terrain.header().rows);
    field.height_m.resize(std::size_t{terrain.header().columns} * terrain.header().rows);
    field.valid.resize(field.height_m.size());
    terrain.for_each_chunk(0, [&](const Terrain::Chunk& chunk) {
        for (const ChunkVertex& v : chunk.vertices) {
            const std::size_t post = std::size_t{chunk.posts.j0 + v.j} * terrain.header().columns + chunk.posts.i0 + v.i;
            field.height_m[post] = v.height_m;
            field.valid[post] = v.post_class() == PostClass::void_ ? 0 : 1;
        }
    });
    return field;
}

struct LevelMeshes {
    std::uint32_t level = 0;
    double triangles = 0;
    double error_m = 0;  ///< at posts, or the level's tolerance where that is more
};

LevelMeshes meshes_of(Terrain& terrain, const bench::HeightField& field, std::uint32_t level) {
    LevelMeshes meshes{level, 0, terrain.header().tolerance_m[level]};
    terrain.for_each_chunk(level, [&](const Terrain::Chunk& chunk) {
        meshes.triangles += chunk.entry.triangle_count;
        const auto post = [&](std::size_t n) {
            const ChunkVertex& v = chunk.vertices[chunk.triangles[n]];
            return bench::FieldPost{static_cast<std::int32_t>(chunk.posts.i0 + v.i),
                                    static_cast<std::int32_t>(chunk.posts.j0 + v.j)};
        };
        for (std::size_t n = 0; n < chunk.triangles.size(); n += 3)
            meshes.error_m = std::max(meshes.error_m, bench::worst_post(field, post(n), post(n + 1), post(n + 2)).error_m);
    });
    return meshes;
}

/// Level 1 and above, the reference as near as each level is.
std::vector<BenchResult> compare(Terrain& terrain) {
    const bench::HeightField field = field_of(terrain);
    std::vector<LevelMeshes> levels;
    for (std::uint32_t level = 1; level < terrain.header().levels; ++level) levels.push_back(meshes_of(terrain, field, level));
    std::sort(levels.begin(), levels.end(), [](const LevelMeshes& a, const LevelMeshes& b) { return a.error_m > b.error_m; });
    bench::ReferenceTriangulation reference(field);
    std::vector<BenchResult> lines;
    for (const LevelMeshes& level : levels) {
        const auto expected = static_cast<double>(reference.refine(level.error_m));
        const double ratio = level.triangles / expected;
        char name[64];
        std::snprintf(name, sizeof name, "level %u, %.4g m: triangles", level.level, level.error_m);
        lines.push_back({name, level.triangles, "triangles", kMaxMore * expected, ratio <= kMaxMore, expected});
        lines.push_back({std::string(name) + " / reference", ratio, "ratio", kMaxMore, ratio <= kMaxMore, 1});
    }
    return lines;
}

std::vector<BenchResult> compare_file(const std::string& path) {
    auto file = platform::open_file(path.c_str());
    if (!file.ok()) throw Failure{std::string(file.error().message.view())};
    platform::FileByteSource source = std::move(file.value());
    Terrain terrain(source, path);
    return compare(terrain);
}

std::vector<BenchResult> compare_shipped() {
    std::vector<std::uint8_t> image =
        test_support::build_image_of_file(test_support::source_dir() + "/configs/data/jacksboro_srtm3.tif");
    test_support::MemoryBytes source(image);
    Terrain terrain(source, "shipped terrain");
    return compare(terrain);
}

}  // namespace

int main(int argc, char** argv) {
    bool json = false;
    std::string path;
    for (int n = 1; n < argc; ++n) {
        if (std::strcmp(argv[n], "--json") == 0) {
            json = true;
        } else if (argv[n][0] != '-' && path.empty()) {
            path = argv[n];
        } else {
            std::fprintf(stderr, "bench_terrain_mesh: unknown argument '%s'; one database and --json are known\n", argv[n]);
            return 2;
        }
    }
    try {
        return bench::report(path.empty() ? compare_shipped() : compare_file(path), json);
    } catch (const Failure& failure) {
        std::fprintf(stderr, "bench_terrain_mesh: %s\n", failure.message.c_str());
        return 2;
    }
}
