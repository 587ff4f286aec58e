#include "host_sim/terrain_builder/terrain_build.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "host_sim/user_error.hpp"
#include "render_core/terrain/chunk_payload.hpp"
#include "tests/host_sim/terrain_builder/chunk_side.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/terrain/draped_database.hpp"

namespace tedavis::host_sim::test_terrain_build {
namespace {

using namespace terrain;
using test_support::build_image;
using test_support::BuiltDatabase;
using test_support::BuiltMesh;
using test_support::make_raster;
using test_support::part_of_side;
using test_support::side_of;

struct Stop : std::runtime_error {
    Stop() : std::runtime_error("stop") {}
};

/// Hills, a lake at height 0, and voids: single posts, a line along a border, a field.
Raster varied_raster(std::uint32_t columns, std::uint32_t rows) {
    Raster raster = make_raster(columns, rows, [](std::uint32_t i, std::uint32_t j) {
        const bool hole = (i > 35 && i < 60 && j > 10 && j < 25) || (i % 41 == 7 && j % 17 == 3) || (i == 64 && j > 5 && j < 20);
        if (hole) return std::nanf("");
        const float height = 300 * std::sin(i * 0.11f) * std::cos(j * 0.17f) + 25.0f * static_cast<float>((i * 7 + j * 13) % 5);
        return height < 0 ? 0.0f : height;
    });
    for (std::size_t n = 0; n < raster.height_m.size(); ++n)
        if (raster.height_m[n] == 0) raster.post_class[n] = PostClass::sea;
    return raster;
}

TEST(TerrainBuild, GivesTheSameBytesForAnyNumberOfThreads) {
    for (const Raster& raster : {varied_raster(150, 90), varied_raster(1090, 36)}) {
        BuildOptions one, four;
        one.threads = 1;
        four.threads = 4;
        EXPECT_EQ(build_image(raster, one), build_image(raster, four));
    }
}

class Interruption : public ::testing::Test {
protected:
    /// How often the progress of a whole build is told.
    int steps_of(const TerrainSources& sources) {
        int steps = 0;
        BuildOptions options;
        options.progress = [&steps](std::string_view, std::uint64_t, std::uint64_t) { ++steps; };
        whole_ = build_image(sources, options);
        return steps;
    }
    int steps_of(const Raster& raster) { return steps_of(TerrainSources(test_support::posts_of(raster))); }
    /// Stops at step n and again at each n-th step, until the build is whole.
    std::string build_in_pieces(const Raster& raster, int n, std::chrono::milliseconds between_records) {
        return build_in_pieces(TerrainSources(test_support::posts_of(raster)), n, between_records);
    }
    std::string build_in_pieces(const TerrainSources& sources, int n, std::chrono::milliseconds between_records) {
        std::filesystem::remove(folder_.file("t.tdb"));
        BuildOptions options;
        options.threads = 2;
        options.between_records = between_records;
        for (int attempt = 0; attempt < 1000; ++attempt) {
            int left = n;
            options.progress = [&left](std::string_view, std::uint64_t, std::uint64_t) {
                if (--left == 0) throw Stop();
            };
            try {
                build_terrain(sources, folder_.file("t.tdb"), options);
                return folder_.read("t.tdb");
            } catch (const Stop&) {
                EXPECT_FALSE(std::filesystem::exists(folder_.file("t.tdb"))) << "a part of a database";
            }
        }
        return "";
    }

    test_support::TemporaryFolder folder_;
    std::vector<std::uint8_t> whole_;
};

TEST_F(Interruption, AtAnyStageChangesNothing) {
    const Raster raster = varied_raster(1090, 36);
    const int steps = steps_of(raster);
    ASSERT_GT(steps, 40);
    const std::string whole(whole_.begin(), whole_.end());
    for (const int n : {5, 18, steps / 2, steps - 1})
        EXPECT_TRUE(build_in_pieces(raster, n, std::chrono::milliseconds(n % 2 == 0 ? 0 : 100000)) == whole) << n;
    EXPECT_EQ(folder_.entries(), 1u) << "work files are left behind";
}

TEST_F(Interruption, AtEveryStepChangesNothing) {
    const Raster raster = varied_raster(66, 60);
    (void)steps_of(raster);
    EXPECT_TRUE(build_in_pieces(raster, 1, std::chrono::milliseconds(0)) == std::string(whole_.begin(), whole_.end()));
}

TEST_F(Interruption, OfADrapeChangesNothingEither) {
    const Raster raster = varied_raster(150, 90);
    test_support::TemporaryFolder images;
    TerrainSources sources(test_support::posts_of(raster));
    sources.drape = DrapeOptions{test_support::image_over(raster, 2, test_support::wavy(17)).write(images.file("i.tif")), {}, {}};
    const int steps = steps_of(sources);
    const std::string whole(whole_.begin(), whole_.end());
    ASSERT_NE(whole, std::string());
    for (const int n : {7, steps / 2}) EXPECT_TRUE(build_in_pieces(sources, n, std::chrono::milliseconds(0)) == whole) << n;
    BuildOptions one;
    one.threads = 1;
    EXPECT_EQ(build_image(sources, one), whole_);
    const std::vector<std::uint8_t> plain = build_image(raster);
    EXPECT_GT(whole_.size(), plain.size() + sizeof(DrapePage));
    FileHeader header;
    std::memcpy(&header, plain.data(), sizeof header);
    EXPECT_EQ(header.drape_posts, 0);
    std::memcpy(&header, whole_.data(), sizeof header);
    EXPECT_EQ(header.drape_posts, kDrapePosts);
    EXPECT_EQ(header.drape_level, 1) << "half a post a pixel";
}

/// A power loss: the folder as it was at some moment, also in the middle of a record.
TEST_F(Interruption, ByAPowerLossCostsOnlyWhatWasNotRecorded) {
    const Raster raster = varied_raster(150, 90);
    const int steps = steps_of(raster);
    const std::string whole(whole_.begin(), whole_.end());
    const std::string part = folder_.file("t.tdb.part"), kept = folder_.file("kept");
    for (const int n : {2, steps / 3, steps / 2, steps - 2}) {
        BuildOptions options;
        options.between_records = std::chrono::milliseconds(0);
        int left = n;
        options.progress = [&](std::string_view, std::uint64_t, std::uint64_t) {
            if (--left == 0) std::filesystem::copy(part, kept, std::filesystem::copy_options::recursive);
        };
        build_terrain(test_support::posts_of(raster), folder_.file("t.tdb"), options);
        std::filesystem::rename(kept, part);
        std::filesystem::resize_file(part + "/journal", std::filesystem::file_size(part + "/journal") - 5);
        EXPECT_TRUE(build_in_pieces(raster, 100000, std::chrono::milliseconds(1000)) == whole) << n;
    }
}

TEST_F(Interruption, AnotherSourceOrOptionStartsAnew) {
    const Raster first = varied_raster(150, 90), second = make_raster(150, 90, [](auto i, auto j) { return 1.0f * i + j; });
    const std::vector<std::uint8_t> expected = build_image(second);
    BuildOptions options;
    options.identity = "first";
    int left = steps_of(first) / 2;
    options.progress = [&left](std::string_view, std::uint64_t, std::uint64_t) {
        if (--left == 0) throw Stop();
    };
    EXPECT_THROW(build_terrain(test_support::posts_of(first), folder_.file("t.tdb"), options), Stop);
    BuildOptions other;
    other.identity = "second";
    build_terrain(test_support::posts_of(second), folder_.file("t.tdb"), other);
    EXPECT_EQ(folder_.read("t.tdb"), std::string(expected.begin(), expected.end()));
}

/// Neighbours of a level show the same side, bit for bit; what stays of it is the side of the next level.
void expect_borders_agree(const BuiltDatabase& built) {
    const Lattice& lattice = built.lattice();
    for (const ChunkKey& key : built.chunks()) {
        SCOPED_TRACE("chunk " + std::to_string(key.level) + "/" + std::to_string(key.i) + "/" + std::to_string(key.j));
        for (const auto& [side, other] : {std::pair{kEdgeEast, kEdgeWest}, {kEdgeSouth, kEdgeNorth}}) {
            const ChunkKey neighbour = lattice.neighbour(key, side);
            if (neighbour == kNoChunk) continue;
            EXPECT_EQ(side_of(built, key, side, true), side_of(built, neighbour, other, true));
            if (key.level + 1 == lattice.levels() || neighbour.parent() == key.parent()) continue;
            const PostRange posts = lattice.posts_of(key);
            const std::uint32_t first = side == kEdgeEast ? posts.j0 : posts.i0, last = side == kEdgeEast ? posts.j1 : posts.i1;
            EXPECT_EQ(side_of(built, key, side, false),
                      part_of_side(side_of(built, neighbour.parent(), other, true), first, last));
        }
    }
}

TEST(TerrainBuild, BordersOfNeighboursAndLevelsAgreeBitForBit) {
    expect_borders_agree(BuiltDatabase(varied_raster(150, 90)));
    expect_borders_agree(BuiltDatabase(varied_raster(1090, 36)));
    const auto height = [](std::uint32_t i, std::uint32_t j) { return 200.0f * static_cast<float>((i * 7 + j * j) % 13); };
    const Raster earth = make_raster(144, 72, height, -178.75, 88.75, 2.5);  // round the Earth, with both poles
    const BuiltDatabase round(earth);
    EXPECT_TRUE(round.lattice().is_closed());
    EXPECT_EQ(round.lattice().rows(), 74u);
    expect_borders_agree(round);
    expect_borders_agree(BuiltDatabase(make_raster(80, 70, height, 179.2, -16, 0.02)));  // over the antimeridian
}

TEST(TerrainBuild, EveryPayloadIsWhatTheDisplayExpects) {
    const Raster raster = varied_raster(150, 90);
    const BuiltDatabase built(raster);
    for (const ChunkKey& key : built.chunks()) {
        const ChunkEntry entry = built.entry(key);
        EXPECT_TRUE(payload_holds(built.lattice(), entry, {built.image.data() + entry.payload.offset, entry.payload.bytes}))
            << key.level << "/" << key.i << "/" << key.j;
    }
}

TEST(TerrainBuild, MeshesFillTheirChunkBesideAnyNeighbours) {
    const Raster raster = varied_raster(150, 90);
    const BuiltDatabase built(raster);
    for (const ChunkKey& key : built.chunks()) {
        if (key.level == 0 && key.i > 1) continue;
        const PostRange posts = built.lattice().posts_of(key);
        for (const std::uint8_t mask : {0, 1, 2, 4, 8, 9, 6}) {
            const BuiltMesh mesh(built, key, mask);
            EXPECT_EQ(mesh.twice_area(), 2 * std::int64_t{posts.i1 - posts.i0} * (posts.j1 - posts.j0));
        }
    }
}

TEST(TerrainBuild, KeepsEveryPostAndItsClass) {
    const Raster raster = varied_raster(150, 90);
    const BuiltDatabase built(raster);
    for (const ChunkKey& key : built.chunks()) {
        const ChunkEntry entry = built.entry(key);
        const PostRange posts = built.lattice().posts_of(key);
        for (const ChunkVertex& v : built.vertices(entry)) {
            const std::size_t n = raster.at(posts.i0 + v.i, posts.j0 + v.j);
            ASSERT_EQ(v.post_class(), raster.post_class[n]);
            if (v.post_class() != PostClass::void_) {
                ASSERT_EQ(v.height_m, raster.height_m[n]);
            } else {
                ASSERT_TRUE(std::isfinite(v.height_m));
            }
        }
        if (key.level > 0) continue;
        EXPECT_EQ(entry.vertex_count, (posts.i1 - posts.i0 + 1) * (posts.j1 - posts.j0 + 1));
    }
    EXPECT_EQ(built.database.header().void_posts, static_cast<std::uint64_t>(raster.void_posts));
}

/// What is not known is seen to be unknown: at the levels that are made from all posts, inner voids too.
TEST(TerrainBuild, TrianglesWithVoidPostsHaveAVoidCorner) {
    const Raster raster = varied_raster(150, 90);
    const BuiltDatabase built(raster);
    int with_voids = 0;
    for (const ChunkKey& key : built.chunks()) {
        const BuiltMesh mesh(built, key, 0);
        for (std::size_t n = 0; n < mesh.indices.size(); n += 3) {
            bool void_corner = false, void_inside = false;
            const auto [a, b, c] =
                std::tuple{mesh.at(mesh.indices[n]), mesh.at(mesh.indices[n + 1]), mesh.at(mesh.indices[n + 2])};
            for (std::size_t k = 0; k < 3; ++k)
                void_corner = void_corner || mesh.vertices[mesh.indices[n + k]].post_class() == PostClass::void_;
            const auto turn = [](const auto& p, const auto& q, const auto& r) {
                return (r.first - p.first) * (q.second - p.second) - (q.first - p.first) * (r.second - p.second);
            };
            for (auto j = std::min({a.second, b.second, c.second}); j <= std::max({a.second, b.second, c.second}); ++j)
                for (auto i = std::min({a.first, b.first, c.first}); i <= std::max({a.first, b.first, c.first}); ++i) {
                    const test_support::LatticePost p{i, j};
                    const bool inside = turn(a, b, p) > 0 && turn(b, c, p) > 0 && turn(c, a, p) > 0;
                    void_inside =
                        void_inside ||
                        (inside && raster.post_class[raster.at(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j))] ==
                                       PostClass::void_);
                }
            EXPECT_TRUE(void_corner || !void_inside) << key.level << "/" << key.i << "/" << key.j;
            with_voids += void_inside ? 1 : 0;
        }
    }
    EXPECT_GT(with_voids, 10);
}

TEST(TerrainBuild, RefusesWhatHasNoHeights) {
    const Raster raster = make_raster(40, 40, [](std::uint32_t, std::uint32_t) { return std::nanf(""); });
    const test_support::TemporaryFolder folder;
    test_support::expect_user_error([&] { build_terrain(test_support::posts_of(raster), folder.file("t.tdb"), {}); },
                                    "no post has a height");
    EXPECT_FALSE(std::filesystem::exists(folder.file("t.tdb")));
}

}  // namespace
}  // namespace tedavis::host_sim::test_terrain_build
