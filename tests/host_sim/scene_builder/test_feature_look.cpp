#include "host_sim/scene_builder/feature_look.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_feature_look {
namespace {

using ::testing::ElementsAre;

class FeatureLooks : public ::testing::Test {
protected:
    FeatureLook look(SourceKind kind, const std::string& name, const std::string& content) {
        LayerRecipe recipe;
        recipe.name = "things";
        recipe.source = name;
        return look_at_features(read_feature_source(kind, recipe, folder_.write(name, content)));
    }
    static const ColumnLook& column(const FeatureLook& look, const std::string& name) {
        const auto found = std::find_if(look.columns.begin(), look.columns.end(),
                                        [&name](const ColumnLook& column) { return column.name == name; });
        EXPECT_NE(found, look.columns.end()) << name;
        return *found;
    }
    test_support::TemporaryFolder folder_;
};

TEST_F(FeatureLooks, ColumnsAreNumbersTimesOrTexts) {
    const FeatureLook found =
        look(SourceKind::vector, "x.csv",
             "lon,lat,kind,height,seen,empty\n9.8,46.8,mast,40,2026-06-01T12:00:00Z,\n9.9,46.7,crane,-2.5,2026-06-01T11:00:00Z,\n"
             "9.7,46.9,mast,,2026-06-01T13:00:00Z,\n");
    EXPECT_EQ(found.points, 3u);
    EXPECT_EQ(found.lines + found.areas, 0u);
    EXPECT_EQ(found.places, 3u);
    EXPECT_DOUBLE_EQ(found.west_deg, 9.7);
    EXPECT_DOUBLE_EQ(found.north_deg, 46.9);
    const ColumnLook &kind = column(found, "kind"), &height = column(found, "height"), &seen = column(found, "seen");
    EXPECT_EQ(kind.kind, ColumnKind::text);
    EXPECT_THAT(kind.texts, ElementsAre("crane", "mast"));
    EXPECT_EQ(height.kind, ColumnKind::number);
    EXPECT_EQ(height.stated, 2u);
    EXPECT_EQ(height.range->least, -2.5);
    EXPECT_EQ(height.range->greatest, 40);
    EXPECT_EQ(seen.kind, ColumnKind::time);
    EXPECT_NE(seen.first.find("11:00"), std::string::npos) << seen.first;
    EXPECT_EQ(column(found, "empty").stated, 0u);
}

TEST_F(FeatureLooks, ExtentsCrossTheAntimeridian) {
    const FeatureLook found = look(SourceKind::vector, "x.csv", "lon,lat\n179,1\n-179,2\n178,3\n");
    EXPECT_DOUBLE_EQ(found.west_deg, 178);
    EXPECT_DOUBLE_EQ(found.east_deg, 181);
}

TEST_F(FeatureLooks, FlightsStateTimesAircraftAndValuesOfPoints) {
    const FeatureLook found = look(
        SourceKind::flight, "flight.csv",
        "time,latitude_deg,longitude_deg,height_msl_m,aircraft\n1586684820,46.8,9.8,2000,HB1\n1586684821,46.8005,9.8,2002,HB1\n"
        "1586684820,46.7,9.7,3000,HB2\n1586684825,46.7,9.71,3000,HB2\n");
    EXPECT_THAT(found.aircraft, ElementsAre("HB1", "HB2"));
    EXPECT_EQ(found.first_ns, std::int64_t{1586684820} * 1'000'000'000);
    EXPECT_EQ(found.last_ns, std::int64_t{1586684825} * 1'000'000'000);
    EXPECT_TRUE(column(found, "ground_speed").is_of_points);
    EXPECT_FALSE(found.usual_attributes.empty());
    ASSERT_TRUE(found.height_m);
    EXPECT_NEAR(found.height_m->least, 2000, 5);
}

TEST_F(FeatureLooks, ShapesAreCounted) {
    const FeatureLook found =
        look(SourceKind::vector, "x.geojson",
             R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":)"
             R"({"type":"LineString","coordinates":[[9,46,500],[10,47,700]]}},{"type":"Feature","properties":{},"geometry":)"
             R"({"type":"Polygon","coordinates":[[[9,46],[10,46],[10,47],[9,46]]]}}]})");
    EXPECT_EQ(found.lines, 1u);
    EXPECT_EQ(found.areas, 1u);
    EXPECT_EQ(found.places, 5u);
    EXPECT_EQ(found.format, "GeoJSON");
    EXPECT_EQ(found.height_m->greatest, 700);
}

}  // namespace
}  // namespace tedavis::host_sim::test_feature_look
