#include "host_sim/scene_builder/runway_source.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_runway_source {
namespace {

using test_support::expect_user_error;
using ::testing::ElementsAre;

constexpr const char* kHead =
    "\"id\",\"airport_ident\",\"length_ft\",\"width_ft\",\"surface\",\"lighted\",\"closed\",\"le_ident\",\"le_latitude_deg\","
    "\"le_longitude_deg\",\"le_elevation_ft\",\"le_displaced_threshold_ft\",\"he_ident\",\"he_latitude_deg\",\"he_longitude_"
    "deg\","
    "\"he_elevation_ft\",\"he_displaced_threshold_ft\"\n";

class RunwayFiles : public ::testing::Test {
protected:
    SourceFeatures read(const std::string& rows) { return read_runway_file(folder_.write("runways.csv", kHead + rows)); }

    test_support::TemporaryFolder folder_;
};

TEST_F(RunwayFiles, EndsAndMetres) {
    const SourceFeatures found =
        read("1,\"KJAU\",4000,75,\"ASP\",1,0,\"05\",36.3302,-84.1678,1134,,\"23\",36.3379,-84.1581,1180,300\n");
    ASSERT_EQ(found.features.size(), 1u);
    const SourceFeature& runway = found.features[0];
    EXPECT_EQ(runway.shape, scene::LayerShape::lines);
    ASSERT_EQ(runway.points.size(), 2u);
    EXPECT_EQ(runway.points[0].latitude_deg, 36.3302);
    EXPECT_EQ(runway.points[1].longitude_deg, -84.1581);
    EXPECT_NEAR(*runway.points[0].height_m, 1134 * 0.3048, 1e-9);
    EXPECT_NEAR(*runway.points[1].height_m, 1180 * 0.3048, 1e-9);
    EXPECT_EQ(runway.fields.at("name"), "KJAU 05/23");
    EXPECT_EQ(runway.fields.at("surface"), "ASP");
    EXPECT_NEAR(std::stod(runway.fields.at("length_m")), 1219.2, 1e-3);
    EXPECT_NEAR(std::stod(runway.fields.at("width_m")), 22.86, 1e-3);
    EXPECT_NEAR(std::stod(runway.fields.at("he_threshold_m")), 91.44, 1e-3);
    EXPECT_EQ(runway.fields.count("le_threshold_m"), 0u);
    EXPECT_TRUE(found.notes.empty());
}

TEST_F(RunwayFiles, OneElevationServesBothEnds) {
    const SourceFeatures found = read(
        "1,A,1,1,G,0,0,01,46,9,,,19,46.01,9,1000,\n1,B,1,1,G,0,0,01,46,9,1000,,19,46.01,9,,\n1,C,1,1,G,0,0,01,46,9,,,19,46.01,9,,"
        "\n");
    ASSERT_EQ(found.features.size(), 3u);
    for (const std::size_t n : {std::size_t{0}, std::size_t{1}})
        for (const SourcePoint& end : found.features[n].points) EXPECT_NEAR(end.height_m.value_or(0), 304.8, 1e-9);
    EXPECT_FALSE(found.features[2].points[0].height_m);
}

TEST_F(RunwayFiles, ClosedAndPlacelessOnesAreCounted) {
    const SourceFeatures found = read("1,A,1,1,G,0,1,01,46,9,,,19,46.01,9,,\n1,B,1,1,G,0,0,01,46,9,,,19,,,,\n");
    EXPECT_TRUE(found.features.empty());
    EXPECT_THAT(found.notes,
                ElementsAre("1 closed runways are not shown", "1 runways state no place of both ends and are not shown"));
    expect_user_error([this] { (void)read("1,A,1,1,G,0,0,01,46,9,,,19,46.01,9,,\n1,B,1,1,G,0,0,01,here,9,,,19,46.01,9,,\n"); },
                      "runways.csv: row 2: 'here' is no le_latitude_deg; correct it");
    expect_user_error([this] { (void)read("1,B,1,1,G,0,0,01,46,9,,,19,46.01,190,,\n"); }, "'190' is no he_longitude_deg");
}

TEST_F(RunwayFiles, AreKnownByTheirColumns) {
    EXPECT_TRUE(is_runway_table(kHead));
    EXPECT_FALSE(is_runway_table("kind,latitude_deg,longitude_deg\nle_latitude_deg\n"));
    EXPECT_FALSE(is_runway_table(""));
    const std::vector<AttributeRecipe> usual = usual_attributes_of_runways({});
    ASSERT_EQ(usual.size(), 2u);
    EXPECT_EQ(usual[0].variable, "length_m");
}

TEST_F(RunwayFiles, TheGlidePathIsOneMoreColumn) {
    const std::string head =
        "\"airport_ident\",\"le_latitude_deg\",\"le_longitude_deg\",\"he_latitude_deg\",\"he_longitude_deg\","
        "\"glide_path_deg\"\n";
    const auto with = [&](const std::string& angle) {
        return read_runway_file(folder_.write("own.csv", head + "A,46,9,46.01,9," + angle + "\nB,46,9.1,46.01,9.1,\n"));
    };
    const SourceFeatures found = with("5.5");
    EXPECT_EQ(found.features.at(0).fields.at("glide_path_deg"), "5.5");
    EXPECT_EQ(found.features.at(1).fields.count("glide_path_deg"), 0u) << "the lights of this one assume 3 degrees";
    const std::vector<AttributeRecipe> usual = usual_attributes_of_runways(found);
    ASSERT_EQ(usual.size(), 3u);
    EXPECT_EQ(usual[2].name, "glide_path");
    EXPECT_NEAR(usual[2].factor * 180, 3.14159265358979, 1e-12);
    expect_user_error([&] { (void)with("0.2"); }, "own.csv: row 1: '0.2' is no glide_path_deg; state degrees from 1 to 10");
    expect_user_error([&] { (void)with("steep"); }, "'steep' is no glide_path_deg");
}

}  // namespace
}  // namespace tedavis::host_sim::test_runway_source
