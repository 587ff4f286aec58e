#include "render_core/terrain/height_query.hpp"

#include <gtest/gtest.h>

#include "render_core/base/units.hpp"
#include "tests/support/built_database.hpp"

namespace tedavis::terrain {
namespace {

struct Query {
    host_sim::Raster raster;
    test_support::BuiltDatabase built;
    std::vector<std::uint8_t> memory = std::vector<std::uint8_t>(HeightQuery::bytes_needed());
    base::Arena arena{memory.data(), memory.size()};
    HeightQuery query;

    explicit Query(host_sim::Raster r) : raster(r), built(std::move(r)) { EXPECT_TRUE(query.start(built.database, arena)); }
    HeightAnswer ask(double i, double j) {
        return query.at(base::radians(raster.north_deg - j * raster.step_lat_deg),
                        base::radians(raster.west_deg + i * raster.step_lon_deg));
    }
    double post(std::uint32_t i, std::uint32_t j) const { return double{raster.height_m[raster.at(i, j)]}; }
};

TEST(HeightQuery, ReturnsPostsAndBothTrianglesOfACell) {
    Query q(test_support::make_rough_raster(200, 150));
    for (const auto& [i, j] : {std::pair{0u, 0u}, {31u, 32u}, {64u, 64u}, {130u, 77u}, {199u, 149u}})
        EXPECT_NEAR(q.ask(i, j).height.m, q.post(i, j), 1e-3);
    EXPECT_NEAR(q.ask(64.25, 70.25).height.m, 0.5 * q.post(64, 70) + 0.25 * q.post(65, 70) + 0.25 * q.post(64, 71), 1e-3);
    EXPECT_NEAR(q.ask(64.75, 70.75).height.m, 0.5 * q.post(65, 71) + 0.25 * q.post(65, 70) + 0.25 * q.post(64, 71), 1e-3);
}

TEST(HeightQuery, AnswersDoNotDependOnWhatWasAskedBefore) {
    Query walked(test_support::make_rough_raster(200, 150));
    std::vector<std::array<double, 3>> answers;
    for (int n = 0; n < 400; ++n) {
        const double i = (n * 37) % 199 + 0.3, j = (n * 53) % 149 + 0.6;
        answers.push_back({i, j, walked.ask(i, j).height.m});
    }
    Query backwards(test_support::make_rough_raster(200, 150));
    for (auto answer = answers.rbegin(); answer != answers.rend(); ++answer)
        EXPECT_EQ(backwards.ask((*answer)[0], (*answer)[1]).height.m, (*answer)[2]);
}

TEST(HeightQuery, OutsideVoidAndSeaAreSaid) {
    host_sim::Raster raster = test_support::make_rough_raster(100, 100);
    raster.height_m[raster.at(20, 30)] = NAN;
    raster.post_class[raster.at(20, 30)] = PostClass::void_;
    for (std::uint32_t n = 50; n < 60; ++n)
        for (std::uint32_t m = 50; m < 60; ++m) {
            raster.height_m[raster.at(n, m)] = 0;
            raster.post_class[raster.at(n, m)] = PostClass::sea;
        }
    Query q(raster);
    EXPECT_EQ(q.ask(-1, 5).status, HeightStatus::outside);
    EXPECT_EQ(q.ask(100, 5).status, HeightStatus::outside);
    EXPECT_EQ(q.ask(19.5, 30.5).status, HeightStatus::void_);
    EXPECT_EQ(q.ask(18.5, 30.5).status, HeightStatus::land);
    EXPECT_EQ(q.ask(55.5, 55.5).status, HeightStatus::sea);
    EXPECT_EQ(q.ask(55.5, 55.5).height.m, 0);
}

TEST(HeightQuery, ADamagedChunkIsSaidNotShown) {
    Query q(test_support::make_rough_raster(100, 100));
    const ChunkEntry& entry = q.built.database.entry(q.built.database.at(0, 2, 2));
    q.built.image[entry.offset + entry.bytes - 10] ^= 1;
    EXPECT_EQ(q.ask(70, 70).status, HeightStatus::damaged);
    EXPECT_EQ(q.ask(10, 10).status, HeightStatus::land);
}

}  // namespace
}  // namespace tedavis::terrain
