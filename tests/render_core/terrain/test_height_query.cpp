#include "render_core/terrain/height_query.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"
#include "tests/support/files/flaky_bytes.hpp"
#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::terrain::test_height_query {
namespace {

using test_support::FlakyBytes;
using test_support::TdbSpec;
using test_support::WrittenTdb;

TdbSpec rough(std::uint32_t columns, std::uint32_t rows) {
    TdbSpec spec;
    spec.columns = columns;
    spec.rows = rows;
    spec.height_m = [](std::uint32_t i, std::uint32_t j) {
        return 800 + 300 * std::sin(i * 0.11) * std::cos(j * 0.07) + 40 * std::sin(i * 2.3 + j);
    };
    spec.measured = false;
    return spec;
}

struct Query {
    explicit Query(const TdbSpec& spec) : tdb(spec), bytes(tdb.bytes), database(open()) {
        base::Arena arena(memory.data(), memory.size());
        EXPECT_TRUE(query.start(database, arena));
    }
    TerrainDatabase open() {
        base::Arena arena(table.data(), table.size());
        return TerrainDatabase::open(bytes, arena).value();
    }
    /// At a place between posts; rows at a pole are as far from the next as any.
    HeightAnswer ask(double i, double j) {
        const Lattice& lattice = tdb.lattice();
        const auto between = [](double a, double b, double t) { return a + (b - a) * t; };
        const auto row = static_cast<std::uint32_t>(std::min(std::floor(j), lattice.rows() - 2.0));
        return query.at(between(lattice.latitude_rad(row), lattice.latitude_rad(row + 1), j - row),
                        base::radians(tdb.database().header().west_deg + i * tdb.database().header().step_lon_deg));
    }
    WrittenTdb tdb;
    FlakyBytes bytes;
    std::vector<std::uint8_t> table = std::vector<std::uint8_t>(1 << 17);
    TerrainDatabase database;
    std::vector<std::uint8_t> memory = std::vector<std::uint8_t>(HeightQuery::bytes_needed());
    HeightQuery query;
};

TEST(HeightQuery, ReturnsPostsAndBothTrianglesOfACell) {
    Query q(rough(200, 150));
    for (const auto& [i, j] : {std::pair{0u, 0u}, {31u, 32u}, {64u, 64u}, {130u, 77u}, {199u, 149u}, {192u, 128u}})
        EXPECT_NEAR(q.ask(i, j).height.m, q.tdb.height_m(i, j), 1e-3);
    const double ne = q.tdb.height_m(65, 70), sw = q.tdb.height_m(64, 71);
    EXPECT_NEAR(q.ask(64.25, 70.25).height.m, 0.5 * q.tdb.height_m(64, 70) + 0.25 * ne + 0.25 * sw, 1e-3);
    EXPECT_NEAR(q.ask(64.75, 70.75).height.m, 0.5 * q.tdb.height_m(65, 71) + 0.25 * ne + 0.25 * sw, 1e-3);
    EXPECT_NEAR(q.ask(64.5, 70.5).height.m, 0.5 * ne + 0.5 * sw, 1e-3) << "the diagonal";
    EXPECT_NEAR(q.ask(10, 10).undulation.m, WrittenTdb::undulation_m(q.tdb.lattice().latitude_rad(10)), 1e-4);
}

TEST(HeightQuery, AnswersDoNotDependOnWhatWasAskedBefore) {
    Query walked(rough(200, 150)), backwards(rough(200, 150));
    std::vector<std::array<double, 3>> answers;
    for (int n = 0; n < 400; ++n) {
        const double i = (n * 37) % 199 + 0.3, j = (n * 53) % 149 + 0.6;
        answers.push_back({i, j, walked.ask(i, j).height.m});
    }
    for (auto answer = answers.rbegin(); answer != answers.rend(); ++answer)
        EXPECT_EQ(backwards.ask((*answer)[0], (*answer)[1]).height.m, (*answer)[2]);
}

TEST(HeightQuery, ReadsAChunkOnceWhereItIsAskedOften) {
    Query q(rough(200, 150));
    (void)q.ask(40, 40);
    const int reads = q.bytes.reads;
    for (double d = 0; d < 20; d += 0.1) EXPECT_EQ(q.ask(40 + d, 40.5).status, HeightStatus::land);
    EXPECT_EQ(q.bytes.reads, reads);
    (void)q.ask(70, 40);
    EXPECT_EQ(q.bytes.reads, reads + 1) << "the way down is kept";
}

/// What stands on the ground, in more chunks than are kept.
TEST(HeightQuery, PlacesThatAreAskedForAgainNeedNoReading) {
    Query q(rough(500, 400));
    const auto ask_all = [&q] {
        std::vector<double> heights;
        for (int n = 0; n < 300; ++n) heights.push_back(q.ask((n * 37) % 499 + 0.3, (n * 53) % 399 + 0.6).height.m);
        return heights;
    };
    const std::vector<double> first = ask_all();
    const int reads = q.bytes.reads;
    EXPECT_GT(reads, 200) << "control: each was in another chunk";
    q.bytes.fails = true;
    EXPECT_EQ(ask_all(), first);
    EXPECT_EQ(q.bytes.reads, reads);
}

TEST(HeightQuery, ExactChunksOfCoarserLevelsAnswerWithTheirOwnPosts) {
    TdbSpec spec = rough(257, 257);
    spec.is_exact = [](const ChunkKey& key) { return key.level == 2 && key.i == 1; };
    Query q(spec);
    ASSERT_TRUE(q.tdb.has({2, 1, 0}) && !q.tdb.has({1, 2, 0}));
    const double nw = q.tdb.height_m(140, 80), ne = q.tdb.height_m(144, 80), sw = q.tdb.height_m(140, 84);
    EXPECT_NEAR(q.ask(141, 80.5).height.m, nw + 0.25 * (ne - nw) + 0.125 * (sw - nw), 1e-3);
    for (double j = 0; j <= 256; j += 7.7)
        for (double i = 0; i <= 256; i += 9.1) ASSERT_EQ(q.ask(i, j).status, HeightStatus::land) << i << ", " << j;
}

TEST(HeightQuery, TheLatticesEndRoundTheEarthAndThePoles) {
    TdbSpec spec = test_support::whole_earth(145, 73);
    spec.height_m = [](std::uint32_t i, std::uint32_t j) { return j == 0 || j == 72 ? 50.0 : 500 + 100 * std::sin(i * 0.4 + j); };
    spec.measured = false;
    Query q(spec);
    // Across the antimeridian, from both sides.
    const double west = q.tdb.height_m(143, 30), seam = q.tdb.height_m(0, 30);
    EXPECT_NEAR(q.query.at(q.tdb.lattice().latitude_rad(30), base::radians(180 - 1.25)).height.m, 0.5 * (west + seam), 1e-3);
    EXPECT_NEAR(q.query.at(q.tdb.lattice().latitude_rad(30), base::radians(-180.0)).height.m, seam, 1e-3);
    for (double longitude_deg = -180; longitude_deg < 180; longitude_deg += 13) {
        EXPECT_NEAR(q.query.at(base::radians(90), base::radians(longitude_deg)).height.m, 50, 1e-3);
        EXPECT_NEAR(q.query.at(base::radians(-90), base::radians(longitude_deg)).height.m, 50, 1e-3);
        // Straight along the meridian from the pole, and equal to the row beside it at its other end.
        const double j = 0.4, i = (longitude_deg + 180) / 2.5, u = i - std::floor(i);
        const auto a = static_cast<std::uint32_t>(i);
        const double row = (1 - u) * q.tdb.height_m(a, 1) + u * q.tdb.height_m(a + 1, 1);
        EXPECT_NEAR(q.ask(i, j).height.m, 0.6 * 50 + 0.4 * row, 1e-3);
    }
}

TEST(HeightQuery, OutsideVoidAndSeaAreSaid) {
    TdbSpec spec = rough(100, 100);
    const auto is_sea = [](std::uint32_t i, std::uint32_t j) { return i >= 50 && i < 60 && j >= 50 && j < 60; };
    const auto height = spec.height_m;
    spec.height_m = [=](std::uint32_t i, std::uint32_t j) { return is_sea(i, j) ? 0 : height(i, j); };
    spec.post_class = [=](std::uint32_t i, std::uint32_t j) {
        if (i == 20 && j == 30) return PostClass::void_;
        return is_sea(i, j) ? PostClass::sea : PostClass::land;
    };
    Query q(spec);
    EXPECT_EQ(q.ask(-1, 5).status, HeightStatus::outside);
    EXPECT_EQ(q.ask(100, 5).status, HeightStatus::outside);
    EXPECT_EQ(q.query.at(std::nan(""), 0.1).status, HeightStatus::outside);
    EXPECT_EQ(q.query.at(0.8, INFINITY).status, HeightStatus::outside);
    EXPECT_EQ(q.ask(19.5, 30.5).status, HeightStatus::void_);
    EXPECT_EQ(q.ask(18.5, 30.5).status, HeightStatus::land);
    EXPECT_EQ(q.ask(55.5, 55.5).status, HeightStatus::sea);
    EXPECT_EQ(q.ask(55.5, 55.5).height.m, 0);
    EXPECT_EQ(q.ask(49.5, 55.5).status, HeightStatus::land) << "a shore";
}

TEST(HeightQuery, WhatIsDamagedIsSaidNotShown) {
    Query q(rough(100, 100));
    q.bytes.content[q.tdb.entry({0, 2, 2}).payload.offset + 10] ^= 1;
    EXPECT_EQ(q.ask(70, 70).status, HeightStatus::damaged);
    EXPECT_EQ(q.ask(10, 10).status, HeightStatus::land);
    EXPECT_EQ(q.ask(70, 70).status, HeightStatus::damaged);
    q.bytes.content[q.tdb.entry({0, 2, 2}).payload.offset + 10] ^= 1;
    EXPECT_EQ(q.ask(70, 70).status, HeightStatus::land) << "and asked again";
    q.bytes.fails = true;
    EXPECT_EQ(q.ask(10, 80).status, HeightStatus::damaged);
    EXPECT_EQ(q.ask(11, 11).status, HeightStatus::land) << "what is kept needs no disk";
}

TEST(HeightQuery, RefusesASmallArena) {
    Query q(rough(40, 40));
    base::Arena arena(q.memory.data(), q.memory.size() / 2);
    EXPECT_FALSE(HeightQuery().start(q.database, arena));
}

}  // namespace
}  // namespace tedavis::terrain::test_height_query
