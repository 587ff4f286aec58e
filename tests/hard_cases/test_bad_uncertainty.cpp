// Uncertainty that cannot be, from the file to the picture: it looks as what nobody knows, and never as what is certain.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/hard_cases/scene_files.hpp"

namespace tedavis::tests::test_bad_uncertainty {
namespace {

using test_support::DataPicture;
using test_support::DataSite;
using test_support::expect_refusal;
using test_support::plain_ground_design;
using test_support::RasterFile;
using test_support::SceneFiles;
using test_support::site_raster;
using ::testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
constexpr double kUnstated = -9999;  // the file's own word for "there is none"

/// The kind as a scene file writes it, and statements of which one is as sure as can be and the others cannot be.
struct Kind {
    const char* name;
    std::string words;
    double certain, least_sure;
    std::vector<double> impossible;
};
void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

std::vector<Kind> kinds() {
    return {
        {"deviation", "kind = 'standard_deviation'\nfull = 4\n", 0, 4, {kNan, kInfinity, -kInfinity, -1e-3, -7}},
        {"interval", "kind = 'interval'\nfull = 4\n", 0, 9, {kNan, kInfinity, -2}},
        {"percent", "kind = 'percent'\nfull = 50\n", 0, 50, {kNan, 150, -10, kInfinity}},
        {"ordinal", "kind = 'ordinal'\nfull = 3\n", 0, 3, {kNan, 4, -1}},
        {"quality", "kind = 'percent'\nfull = 1\nis_quality = true\n", 1, 0, {kNan, 1.5, -0.25, kInfinity}},
    };
}

/// The first pixels are as sure as can be, so that the picture shows both.
RasterFile unsure_raster(double uncertainty, double certain) {
    RasterFile raster = site_raster();
    raster.bands = 2;
    raster.no_data = kUnstated;
    raster.more = [](int) { return 0.0; };
    raster.second = [=](int i, int) { return i < 3 ? certain : uncertainty; };
    return raster;
}
std::string field_layer(const std::string& uncertainty) {
    return "[[layer]]\nname = 'field'\nsource = 'grid.tif'\n[[layer.attribute]]\nname = 'value'\nvariable = 'band 1'\n"
           "[layer.attribute.uncertainty]\n" +
           uncertainty;
}
std::string ground_design(const std::string& technique) {
    return plain_ground_design(
        "[data.ground]\nlayer = 'field'\nattribute = 'value'\npalette = 'scale.toml'\n[data.ground.uncertainty]\ntechnique = '" +
        technique + "'\n");
}

class ImpossibleUncertainty : public ::testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, ImpossibleUncertainty, ::testing::ValuesIn(kinds()),
                         [](const auto& kind) { return std::string(kind.param.name); });

TEST_P(ImpossibleUncertainty, OfAGridIsDrawnAsUnknown) {
    const Kind& kind = GetParam();
    SceneFiles files;
    const auto drawn = [&](double uncertainty, const char* technique) {
        files.write(unsure_raster(uncertainty, kind.certain));
        return files.drawn(field_layer("variable = 'band 2'\n" + kind.words), ground_design(technique));
    };
    for (const char* const technique : {"none", "transparency"}) {
        SCOPED_TRACE(technique);
        const DataPicture unknown = drawn(kUnstated, technique), certain = drawn(kind.certain, technique);
        EXPECT_GT(unknown.differing(certain), 3'000u) << "control: unknown is not certain";
        EXPECT_GT(unknown.differing(drawn(kind.least_sure, technique)), 3'000u) << "control: nor a level of its own";
        for (const double impossible : kind.impossible) EXPECT_EQ(drawn(impossible, technique), unknown) << impossible;
    }
}

/// How points show their uncertainty.
struct Look {
    const char *role, *technique, *uncertainty;
};
constexpr Look kLooks[] = {{"sample", "spheres", "circles"}, {"obstacle", "solid", "saturation"}};

std::string point_layer(const Look& look, const std::string& uncertainty) {
    return std::string("[[layer]]\nname = 'points'\nsource = 'points.csv'\nheight_variable = 'height'\nrole = '") + look.role +
           "'\n[[layer.attribute]]\nname = 'value'\n[layer.attribute.uncertainty]\nvariable = 'unsure'\n" + uncertainty;
}
std::string point_design(const Look& look) {
    return plain_ground_design(std::string("[[data.element]]\nrole = '") + look.role + "'\ntechnique = '" + look.technique +
                               "'\nattribute = 'value'\npalette = 'scale.toml'\nsize_m = 250\n[data.element.uncertainty]\n" +
                               "technique = '" + look.uncertainty + "'\nstrength = 1\n");
}
std::string point_table(const std::string& stated) {
    std::string text = "lon,lat,value,unsure,height\n";
    for (int n = 0; n < 4; ++n)
        text += std::to_string(DataSite::kLongitude_deg - 0.012 + 0.008 * n) + "," +
                std::to_string(DataSite::kLatitude_deg - 0.01) + ",30," + stated + ",1200\n";
    return text;
}

TEST_P(ImpossibleUncertainty, OfPointsIsDrawnAsUnknown) {
    const Kind& kind = GetParam();
    for (const Look& look : kLooks) {
        SCOPED_TRACE(look.uncertainty);
        SceneFiles files;
        const auto drawn = [&](const std::string& stated) {
            files.write(point_table(stated), "points.csv");
            return files.drawn(point_layer(look, kind.words), point_design(look));
        };
        const DataPicture unknown = drawn(""), certain = drawn(std::to_string(kind.certain));
        EXPECT_GT(unknown.differing(certain), 20u) << "control";
        for (const double impossible : kind.impossible) EXPECT_EQ(drawn(std::to_string(impossible)), unknown) << impossible;
        EXPECT_EQ(drawn("perhaps"), unknown);
        EXPECT_THAT(files.notes(), HasSubstr("4 values of 'unsure' are no numbers and count as missing (the first: 'perhaps')"));
    }
}

TEST(ImpossibleUncertaintyInWords, IsDrawnAsUnknown) {
    const Look look{"sample", "spheres", "circles"};
    SceneFiles files;
    const auto drawn = [&](const std::string& trust) {
        files.write(point_table(trust), "points.csv");
        return files.drawn(point_layer(look, "kind = 'ordinal'\nclasses = ['surveyed', 'reported', 'doubtful']\n"),
                           point_design(look));
    };
    const DataPicture unknown = drawn("");
    EXPECT_NE(drawn("surveyed"), unknown) << "control";
    EXPECT_NE(drawn("reported"), unknown) << "control";
    for (const char* const trust : {"rumoured", "3", "-1", "nan"}) EXPECT_EQ(drawn(trust), unknown) << trust;
}

TEST(ImpossibleUncertaintyOfTheSceneFile, IsRefusedOrUnknown) {
    SceneFiles files;
    files.write(unsure_raster(1, 1));
    const auto built = [&](const std::string& value) {
        return files.build(field_layer("kind = 'percent'\nfull = 50\nvalue = " + value + "\n"));
    };
    for (const char* const none : {"nan", "inf"}) {
        expect_refusal(built(none), "s.toml:");
        EXPECT_FALSE(files.has_database());
    }
    EXPECT_EQ(built("0").code, 0);
    const DataPicture certain = files.draw(ground_design("none"));
    EXPECT_EQ(files.build(field_layer("kind = 'none'\n")).code, 0);
    const DataPicture unknown = files.draw(ground_design("none"));
    EXPECT_NE(certain, unknown) << "control";
    for (const char* const value : {"-1", "101"}) {
        EXPECT_EQ(built(value).code, 0);
        EXPECT_EQ(files.draw(ground_design("none")), unknown) << value;
    }
}

/// A flight whose accuracy is not known in places is as wide there as in its worst place, never as thin as where it is known
/// best.
TEST(ImpossibleUncertaintyOfAWay, WidensAsTheWorstOfIt) {
    SceneFiles files;
    const std::string design = plain_ground_design(
        "[[data.element]]\nrole = 'trajectory'\ntechnique = 'tube'\ncolor = '#f0a020'\nsize_m = 30\n"
        "[data.element.uncertainty]\ntechnique = 'widening'\nstrength = 1\n");
    const auto drawn = [&](const std::string& accuracy) {
        std::string text = "{\"type\":\"FeatureCollection\",\"features\":[";
        for (int n = 0; n < 3; ++n) {
            const std::string latitude = std::to_string(DataSite::kLatitude_deg + 0.01 * (n - 1));
            text += std::string(n == 0 ? "" : ",") + R"({"type":"Feature","properties":{"acc":)" +
                    (n == 0   ? "\"400\""
                     : n == 1 ? "\"100\""
                              : "\"" + accuracy + "\"") +
                    R"(},"geometry":{"type":"LineString","coordinates":[[-84.23,)" + latitude + ",1500],[-84.19," + latitude +
                    ",1500]]}}";
        }
        files.write(text + "]}", "ways.geojson");
        return files.drawn(
            "[[layer]]\nname = 'ways'\nsource = 'ways.geojson'\nrole = 'trajectory'\n[[layer.attribute]]\n"
            "name = 'position_accuracy'\nvariable = 'acc'\nunit = 'm'\n",
            design);
    };
    const DataPicture worst = drawn("400");
    EXPECT_GT(worst.differing(drawn("100")), 5'000u) << "control: the tube of the best one is thinner";
    for (const char* const accuracy : {"nan", "-5", "0", "perhaps", ""}) EXPECT_EQ(drawn(accuracy), worst) << accuracy;
}

}  // namespace
}  // namespace tedavis::tests::test_bad_uncertainty
