#include "host_sim/reports/height_findings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_height_findings {
namespace {

using ::testing::HasSubstr;

std::string names(const HeightCounts& counts) {
    std::string all;
    for (const Finding& finding : height_findings("x.tif", counts)) all += finding.name + " ";
    return all;
}

TEST(HeightFindings, GroundHasNone) {
    EXPECT_EQ(names({4'665'600, 0, 556, 3373, false}), "");
    EXPECT_EQ(names({1'442'401, 7652, 349, 3100, false}), "") << "some voids";
    EXPECT_EQ(names({1'000'000, 0, 0, 0, false}), "") << "a sea";
    EXPECT_EQ(names({300, 0, 400, 401, false}), "") << "a small plain";
}

TEST(HeightFindings, WhatIsNoGroundIsSaid) {
    const Findings found = height_findings("x.tif", {1000, 970, -32, 52, false});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].name, "heights.void");
    EXPECT_EQ(found[0].count, 970u);
    EXPECT_THAT(found[0].text, HasSubstr("x.tif: 97 % of 1000 posts have no height"));
    EXPECT_EQ(names({245'000, 0, 0, 1, false}), "heights.no_relief ") << "a quality from 0 to 1";
    EXPECT_EQ(names({245'000, 0, 0, 255, true}), "heights.eight_bit ");
    EXPECT_EQ(names({1000, 1000, 1e300, -1e300, false}), "heights.void ") << "no heights to speak of";
}

TEST(HeightFindings, ValuesThatNoGroundHasAreSaidWhereTheFileDoesNotDeclareThem) {
    const test_support::TemporaryFolder place;
    test_support::RasterFile file;
    file.value = [](int i, int j) { return j < 6 ? -8888000.0 : 400.0 + i; };
    const Findings found = value_findings(file.write(place.file("x.tif")), {});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].name, "heights.impossible");
    EXPECT_THAT(found[0].text,
                HasSubstr("x.tif: about 40 % of its posts have values that no ground has, from -8888000 to -8888000 m"));
    RasterOptions stated;
    stated.void_value = -8888000;
    EXPECT_TRUE(value_findings(place.file("x.tif"), stated).empty());
    file.no_data = -8888000;
    EXPECT_TRUE(value_findings(file.write(place.file("y.tif")), {}).empty()) << "the file declares it";
}

TEST(HeightFindings, ADatabaseIsCountedByItsHeader) {
    terrain::FileHeader header{};
    header.columns = 20;
    header.rows = 10;
    header.void_posts = 150;
    header.min_height_m = -5;
    header.max_height_m = 40;
    const HeightCounts counts = height_counts(header);
    EXPECT_EQ(counts.posts, 200u);
    EXPECT_EQ(counts.lowest_m, -5);
    EXPECT_EQ(counts.highest_m, 40);
    EXPECT_EQ(names(counts), "heights.void ");
}

}  // namespace
}  // namespace tedavis::host_sim::test_height_findings
