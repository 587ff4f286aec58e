#include "host_sim/scene_builder/vector_source.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_vector_source {
namespace {

using scene::LayerShape;
using test_support::expect_user_error;

class VectorFiles : public ::testing::Test {
protected:
    SourceFeatures read_geojson(const std::string& geometry, const std::string& properties = "{}") {
        return read_vector_file(folder_.write("x.geojson", R"({"type":"FeatureCollection","features":[{"type":"Feature",)"
                                                           R"("properties":)" +
                                                               properties + R"(,"geometry":)" + geometry + "}]}"),
                                "");
    }
    SourceFeatures read_csv(const std::string& text, const std::string& crs = "") {
        return read_vector_file(folder_.write("x.csv", text), crs);
    }

    test_support::TemporaryFolder folder_;
};

void expect_at(const SourcePoint& point, double latitude_deg, double longitude_deg) {
    EXPECT_NEAR(point.latitude_deg, latitude_deg, 1e-9);
    EXPECT_NEAR(point.longitude_deg, longitude_deg, 1e-9);
}

TEST_F(VectorFiles, PointsKeepTheirHeightAndFields) {
    const SourceFeatures found =
        read_geojson(R"({"type":"Point","coordinates":[9.8,46.8,1560.5]})", R"({"kind":"mast","height":42.5,"note":null})");
    ASSERT_EQ(found.features.size(), 1u);
    const SourceFeature& mast = found.features[0];
    EXPECT_EQ(mast.shape, LayerShape::points);
    ASSERT_EQ(mast.points.size(), 1u);
    expect_at(mast.points[0], 46.8, 9.8);
    EXPECT_EQ(mast.points[0].height_m, 1560.5);
    EXPECT_EQ(mast.fields.at("kind"), "mast");
    EXPECT_EQ(mast.fields.at("height"), "42.5");
    EXPECT_EQ(mast.fields.count("note"), 0u) << "what is null is not stated";
    EXPECT_TRUE(found.notes.empty());
}

TEST_F(VectorFiles, LinesWithoutHeightsHaveNone) {
    const SourceFeatures found = read_geojson(R"({"type":"LineString","coordinates":[[9.8,46.8],[9.9,46.9],[10,46.7]]})");
    ASSERT_EQ(found.features.size(), 1u);
    EXPECT_EQ(found.features[0].shape, LayerShape::lines);
    ASSERT_EQ(found.features[0].points.size(), 3u);
    expect_at(found.features[0].points[1], 46.9, 9.9);
    EXPECT_FALSE(found.features[0].points[1].height_m);
}

TEST_F(VectorFiles, AreasEndBeforeTheirFirstPointComesAgainAndTheirHolesAreSaid) {
    const SourceFeatures found = read_geojson(R"({"type":"Polygon","coordinates":[[[9,46],[10,46],[10,47],[9,47],[9,46]],)"
                                              R"([[9.4,46.4],[9.4,46.6],[9.6,46.6],[9.4,46.4]]]})");
    ASSERT_EQ(found.features.size(), 1u);
    EXPECT_EQ(found.features[0].shape, LayerShape::areas);
    ASSERT_EQ(found.features[0].points.size(), 4u);
    expect_at(found.features[0].points[3], 47, 9);
    ASSERT_EQ(found.notes.size(), 1u);
    EXPECT_NE(found.notes[0].find("1 holes in areas are not shown"), std::string::npos);
}

TEST_F(VectorFiles, PartsAreFeaturesOfTheirOwnWithTheSameFields) {
    const SourceFeatures found =
        read_geojson(R"({"type":"MultiPolygon","coordinates":[[[[9,46],[10,46],[10,47],[9,46]]],[[[1,6],[2,6],[2,7],[1,6]]]]})",
                     R"({"name":"both"})");
    ASSERT_EQ(found.features.size(), 2u);
    expect_at(found.features[1].points[0], 6, 1);
    for (const SourceFeature& part : found.features) EXPECT_EQ(part.fields.at("name"), "both");
    EXPECT_EQ(read_geojson(R"({"type":"MultiPoint","coordinates":[[1,2],[3,4],[5,6]]})").features.size(), 3u);
    const SourceFeatures mixed =
        read_geojson(R"({"type":"GeometryCollection","geometries":[{"type":"Point","coordinates":[1,2]},)"
                     R"({"type":"LineString","coordinates":[[1,2],[3,4]]}]})");
    ASSERT_EQ(mixed.features.size(), 2u);
    EXPECT_EQ(mixed.features[0].shape, LayerShape::points);
    EXPECT_EQ(mixed.features[1].shape, LayerShape::lines);
}

TEST_F(VectorFiles, ColumnsOfACsvArePlacesAndFields) {
    const SourceFeatures found = read_csv("kind,latitude_deg,longitude_deg,name\ntown,46.8,9.8,Davos\nhut,46.7,9.7,\n");
    ASSERT_EQ(found.features.size(), 2u);
    expect_at(found.features[0].points[0], 46.8, 9.8);
    EXPECT_EQ(found.features[0].fields.at("name"), "Davos");
    EXPECT_EQ(found.features[0].fields.at("latitude_deg"), "46.8");
    EXPECT_EQ(found.features[1].fields.count("name"), 0u) << "an empty cell states nothing";
}

TEST_F(VectorFiles, OtherSystemsBecomeLongitudeAndLatitude) {
    // Bern's old observatory, the origin of the Swiss systems: 2600000 1200000 in LV95, 46 57 03.89 N 7 26 19.07 E on WGS84
    // (Swisstopo, "Formulas and constants for the calculation of the Swiss conformal cylindrical projection", 2008).
    const SourceFeatures swiss = read_csv("x,y\n2600000,1200000\n", "EPSG:2056");
    ASSERT_EQ(swiss.features.size(), 1u);
    EXPECT_NEAR(swiss.features[0].points[0].latitude_deg, 46.951083, 2e-5);
    EXPECT_NEAR(swiss.features[0].points[0].longitude_deg, 7.438637, 2e-5);
    const SourceFeatures plain = read_csv("lon,lat\n9.8,46.8\n", "EPSG:4326");
    expect_at(plain.features[0].points[0], 46.8, 9.8);
    expect_user_error([this] { (void)read_csv("x,y\n1,2\n", "EPSG:99999999"); }, "is unknown; name it as EPSG:4326");
}

TEST_F(VectorFiles, AFeatureWithoutAPlaceIsRefusedWithItsNumber) {
    expect_user_error([this] { (void)read_csv("name,height\nmast,40\n"); }, "x.csv: feature 1 has no place");
    expect_user_error([this] { (void)read_csv("lon,lat\n9.8,46.8\n9.9,\n"); }, "feature 2 has no place");
    expect_user_error([this] { (void)read_geojson("null"); }, "feature 1 has no place");
}

TEST_F(VectorFiles, PlacesLieOnTheEarth) {
    expect_at(read_csv("lon,lat\n350.5,46.8\n").features[0].points[0], 46.8, -9.5);
    expect_user_error([this] { (void)read_csv("lon,lat\n9.8,46.8\n46.8,99.8\n"); }, "feature 2 lies at latitude 99.8");
    expect_user_error([this] { (void)read_csv("x,y\n2600000,1200000\n"); }, "name its system in 'crs'");
    expect_user_error([this] { (void)read_csv("lon,lat\nnan,46.8\n"); }, "feature 1");
}

TEST_F(VectorFiles, WhatIsNoTableIsRefused) {
    expect_user_error([this] { (void)read_vector_file(folder_.file("none.csv"), ""); }, "none.csv");
    expect_user_error([this] { (void)read_vector_file(folder_.write("cut.geojson", R"({"type":"Feat)"), ""); },
                      "not a table or map that GDAL can read");
    EXPECT_TRUE(read_geojson(R"({"type":"LineString","coordinates":[]})").features.empty()) << "an empty geometry is nothing";
}

TEST_F(VectorFiles, RowsOfATableNeedNoPlaces) {
    const auto rows = read_table_file(folder_.write("x.csv", "\"id\",ident\n7,\"LS,ZS\"\n8,\n"));
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].at("ident"), "LS,ZS");
    EXPECT_EQ(rows[1].count("ident"), 0u);
    expect_user_error([this] { (void)read_table_file(folder_.file("none.csv")); }, "none.csv");
}

}  // namespace
}  // namespace tedavis::host_sim::test_vector_source
