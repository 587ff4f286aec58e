#include "render_core/raytrace/ground/ground_reader.hpp"

#include <gtest/gtest.h>

#include <random>

#include "platform/threads/thread_workers.hpp"
#include "render_core/terrain/regular_chunk.hpp"
#include "tests/support/terrain/ground_files.hpp"

namespace tedavis::raytrace::test_ground_reader {
namespace {

using terrain::HeightStatus;
using test_support::mixed_file;
using test_support::OpenedGround;
using test_support::ReadGround;
using test_support::rough_file;

constexpr float kNone = HeightGrid<float>::kVoid;

/// As it is stored: of the exact chunk south-east of a post, where that is of level 0.
const terrain::ChunkVertex* stored_post(OpenedGround& ground, std::uint32_t i, std::uint32_t j) {
    const terrain::Lattice& lattice = ground.database.lattice();
    const terrain::ExactChunk chunk =
        ground.query.exact_chunk(std::min(i, lattice.columns() - 2), std::min(j, lattice.rows() - 2));
    if (chunk.entry == nullptr || chunk.entry->level != 0) return nullptr;
    const terrain::PostRange posts = lattice.posts_of(key_of(*chunk.entry));
    const auto grid = terrain::regular_grid(posts.i1 - posts.i0, posts.j1 - posts.j0, 0);
    return &chunk.vertices[grid.index_of(i - posts.i0, j - posts.j0)];
}

/// Two triangles of the grid; NaN without a surface.
double surface_of(const ReadGround<float>& ground, double i, double j) {
    const auto a = static_cast<std::uint32_t>(i), b = static_cast<std::uint32_t>(j);
    const double u = i - a, v = j - b;
    const float nw = ground.at(a, b), ne = ground.at(a + 1, b), sw = ground.at(a, b + 1), se = ground.at(a + 1, b + 1);
    for (const float height : {nw, ne, sw, se})
        if (height == kNone) return std::nan("");
    return u + v <= 1 ? nw + u * (double{ne} - nw) + v * (double{sw} - nw)
                      : se + (1 - u) * (double{sw} - se) + (1 - v) * (double{ne} - se);
}

struct Agreement {
    int same = 0, voids = 0, wrong = 0;
};

Agreement agreement(OpenedGround& ground, const ReadGround<float>& heights, std::uint32_t seed) {
    Agreement all;
    std::mt19937 random(seed);
    const terrain::PostRange& window = heights.window.window;
    std::uniform_real_distribution<double> across(window.i0, window.i1), down(window.j0, window.j1);
    for (int n = 0; n < 6000; ++n) {
        const double i = across(random), j = down(random);
        const terrain::HeightAnswer answer = ground.ask(i, j);
        const double height = surface_of(heights, i, j);
        if (answer.status == HeightStatus::void_ || answer.status == HeightStatus::damaged)
            std::isnan(height) ? ++all.voids : ++all.wrong;
        else  // places in radians and back are off by a millionth of a cell or so
            std::abs(height - answer.height.m) < 0.0003 ? ++all.same : ++all.wrong;
    }
    return all;
}

TEST(GroundReader, PostsAreThoseStoredAndTheSurfaceIsTheTrueOne) {
    OpenedGround ground(rough_file(200, 150));
    base::SerialWorkers workers;
    const ReadGround<float> heights(ground.database, ground.all(), 1, workers, 1);
    EXPECT_EQ(heights.reading.void_posts, 0u);
    EXPECT_EQ(heights.reading.damaged_parts, 0u);
    EXPECT_TRUE(heights.reading.rounding.are_whole());
    for (std::uint32_t j = 0; j < 150; ++j)
        for (std::uint32_t i = 0; i < 200; ++i)
            ASSERT_EQ(heights.at(i, j), stored_post(ground, i, j)->height_m) << i << ", " << j;
    const Agreement all = agreement(ground, heights, 1);
    EXPECT_EQ(all.wrong, 0);
    EXPECT_EQ(all.same, 6000);
}

TEST(GroundReader, CoarserExactChunksAreFilledOnTheirOwnTriangles) {
    for (const bool has_voids : {false, true}) {
        OpenedGround ground(mixed_file(has_voids));
        base::SerialWorkers workers;
        const ReadGround<float> heights(ground.database, ground.all(), 1, workers, 3);
        const Agreement all = agreement(ground, heights, 2);
        EXPECT_EQ(all.wrong, 0);
        EXPECT_GT(all.same, 5000);
        EXPECT_EQ(all.voids > 30, has_voids);
        EXPECT_EQ(heights.reading.void_posts > 0, has_voids);
        int bits = 0;
        for (std::uint32_t j = 0; j < 257; ++j)
            for (std::uint32_t i = 0; i < 257; ++i) {
                const terrain::ChunkVertex* const post = stored_post(ground, i, j);
                if (post == nullptr) continue;
                const bool is_void = post->post_class() == terrain::PostClass::void_;
                ASSERT_EQ(heights.at(i, j), is_void ? kNone : post->height_m) << i << ", " << j;
                ++bits;
            }
        EXPECT_GT(bits, 40000);
    }
}

TEST(GroundReader, TheCheckSeesTheOtherDiagonalAndACentimetre) {
    OpenedGround ground(mixed_file(false));
    base::SerialWorkers workers;
    ReadGround<float> heights(ground.database, ground.all(), 1, workers, 1);
    for (std::uint32_t j = 100; j < 120; ++j)
        for (std::uint32_t i = 140; i < 160; ++i) heights.heights[std::size_t{j} * 257 + i] += 0.01f;
    EXPECT_GT(agreement(ground, heights, 3).wrong, 10);
    ReadGround<float> turned(ground.database, ground.all(), 1, workers, 1);
    for (std::uint32_t j = 1; j < 128; j += 4)  // what the other division would have in the middle of level 2's cells
        for (std::uint32_t i = 129; i < 256; i += 4)
            turned.heights[std::size_t{j + 1} * 257 + i + 1] = 0.5f * (turned.at(i - 1, j - 1) + turned.at(i + 3, j + 3));
    EXPECT_GT(agreement(ground, turned, 3).wrong, 100);
}

TEST(GroundReader, AnyWindowIsAPartOfTheWhole) {
    OpenedGround ground(mixed_file(true));
    base::SerialWorkers workers;
    const ReadGround<float> whole(ground.database, ground.all(), 1, workers, 1);
    for (const terrain::PostRange& part : {terrain::PostRange{0, 0, 32, 32},
                                           {128, 0, 160, 32},
                                           {96, 96, 128, 128},
                                           {64, 32, 96, 64},
                                           {256, 256, 256, 256},
                                           {31, 65, 190, 67},
                                           {128, 128, 128, 128}}) {
        const ReadGround<float> window(ground.database, part, 1, workers, 2);
        for (std::uint32_t j = part.j0; j <= part.j1; ++j)
            for (std::uint32_t i = part.i0; i <= part.i1; ++i) ASSERT_EQ(window.at(i, j), whole.at(i, j)) << i << ", " << j;
    }
}

TEST(GroundReader, IsTheSameForEveryNumberOfWorkers) {
    OpenedGround ground(mixed_file(true));
    base::SerialWorkers serial;
    const ReadGround<float> first(ground.database, ground.all(), 1, serial, 1);
    for (const std::uint32_t threads : {2u, 3u, 7u}) {
        const auto workers = platform::make_thread_workers({threads, nullptr});
        const ReadGround<float> again(ground.database, ground.all(), 1, *workers.value(), threads);
        EXPECT_EQ(again.heights, first.heights);
        EXPECT_EQ(again.reading.void_posts, first.reading.void_posts);
    }
}

TEST(GroundReader, WholeStepsAreKeptAndOthersSaidToBeRounded) {
    test_support::TdbSpec spec = rough_file(70, 40);
    spec.height_m = [](std::uint32_t i, std::uint32_t j) { return 0.25 * ((i * 37 + j * 11) % 5000) - 300; };
    OpenedGround quarters(spec);
    base::SerialWorkers workers;
    const ReadGround<std::int16_t> kept(quarters.database, quarters.all(), 0.25, workers, 1);
    EXPECT_TRUE(kept.reading.rounding.are_whole());
    const ReadGround<float> metres(quarters.database, quarters.all(), 1, workers, 1);
    for (std::size_t n = 0; n < kept.heights.size(); ++n) ASSERT_EQ(kept.heights[n] * 0.25f, metres.heights[n]);

    const ReadGround<std::int16_t> rounded(quarters.database, quarters.all(), 1, workers, 1);
    EXPECT_FALSE(rounded.reading.rounding.are_whole());
    EXPECT_EQ(rounded.reading.rounding.largest_m, 0.5f);
    EXPECT_FALSE(rounded.reading.rounding.has_beyond);
    const ReadGround<std::int16_t> beyond(quarters.database, quarters.all(), 0.01, workers, 1);
    EXPECT_TRUE(beyond.reading.rounding.has_beyond);
    EXPECT_GT(beyond.reading.void_posts, 0u);
    EXPECT_FALSE(beyond.reading.rounding.are_whole());
}

TEST(GroundReader, WhatIsDamagedIsVoidAndReported) {
    OpenedGround ground(rough_file(200, 150));
    const std::uint64_t offset = ground.tdb.entry({0, 2, 2}).payload.offset;
    ground.bytes.content[offset + 10] ^= 1;
    base::SerialWorkers workers;
    const ReadGround<float> heights(ground.database, ground.all(), 1, workers, 1);
    EXPECT_EQ(heights.reading.damaged_parts, 1u);
    EXPECT_EQ(heights.reading.first_damage.error, terrain::TdbError::chunk_damaged);
    EXPECT_EQ(heights.reading.first_damage.offset, offset);
    EXPECT_EQ(heights.reading.void_posts, 31u * 31u) << "its border belongs to its neighbours too";
    const Agreement all = agreement(ground, heights, 4);
    EXPECT_EQ(all.wrong, 0);
    EXPECT_GT(all.voids, 90);
    ground.bytes.fails = true;
    const ReadGround<float> none(ground.database, ground.all(), 1, workers, 1);
    EXPECT_EQ(none.reading.void_posts, 200u * 150u);
    EXPECT_EQ(none.reading.first_damage.error, terrain::TdbError::unreadable);
}

TEST(GroundReader, RoundTheEarthAndAtThePoles) {
    test_support::TdbSpec spec = test_support::whole_earth(145, 73);
    spec.height_m = [](std::uint32_t i, std::uint32_t j) { return j == 0 || j == 72 ? 50.0 : 500 + 100 * std::sin(i * 0.4 + j); };
    spec.measured = false;
    OpenedGround ground(spec);
    base::SerialWorkers workers;
    const ReadGround<float> heights(ground.database, ground.all(), 1, workers, 2);
    EXPECT_EQ(heights.reading.void_posts, 0u);
    for (std::uint32_t j = 0; j < 73; ++j) EXPECT_EQ(heights.at(0, j), heights.at(144, j)) << "one meridian";
    for (std::uint32_t i = 0; i < 145; ++i) {
        EXPECT_EQ(heights.at(i, 0), 50);
        EXPECT_EQ(heights.at(i, 72), 50);
    }
    const ReadGround<float> between(ground.database, {0, 1, 144, 71}, 1, workers, 1);
    EXPECT_EQ(agreement(ground, between, 5).wrong, 0);
}

TEST(GroundReader, RefusesASmallArena) {
    OpenedGround ground(rough_file(40, 40));
    std::vector<std::uint64_t> memory(GroundReader::kBytesEach / 8);
    base::Arena arena(memory.data(), memory.size() * 8);
    GroundReader reader;
    EXPECT_FALSE(reader.start(ground.database, 2, arena));
}

}  // namespace
}  // namespace tedavis::raytrace::test_ground_reader
