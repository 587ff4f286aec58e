// Trajectories that no aircraft flew, from the recording to the picture: points twice, gaps, time that runs back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "tests/hard_cases/scene_files.hpp"

namespace tedavis::tests::test_bad_paths {
namespace {

using test_support::DataPicture;
using test_support::DataSite;
using test_support::expect_refusal;
using test_support::kBareGround;
using test_support::plain_ground_design;
using test_support::SceneFiles;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::size_t kFixes = 60;
constexpr double kStep_deg = 0.0006;  // eastward, 54 m

/// A fix a second, from west to east with a bend to the north; the values are those of a speed of its own.
struct Fix {
    int second = 0;
    double latitude_deg = 0, longitude_deg = 0, height_m = 1500;
};
std::vector<Fix> flight() {
    std::vector<Fix> fixes;
    for (int n = 0; n < static_cast<int>(kFixes); ++n)
        fixes.push_back({n, DataSite::kLatitude_deg + 0.00001 * n * n - 0.01, DataSite::kLongitude_deg + kStep_deg * (n - 30)});
    return fixes;
}

std::string text_of(const char* format, const Fix& fix) {
    char text[200];
    std::snprintf(text, sizeof text, format, fix.second, fix.latitude_deg, fix.longitude_deg, fix.height_m);
    return text;
}
std::string csv(const std::vector<Fix>& fixes) {
    std::string text = "time,latitude_deg,longitude_deg,height_msl_m\n";
    for (Fix fix : fixes) text += (fix.second += 1'586'684'820, text_of("%d,%.7f,%.7f,%.1f\n", fix));
    return text;
}
std::string gpx(const std::vector<Fix>& fixes) {
    std::string text = "<gpx><trk><trkseg>\n";
    for (const Fix& fix : fixes) {
        char time[40];
        std::snprintf(time, sizeof time, "2020-04-12T%02d:%02d:%02dZ", 9 + fix.second / 3600, fix.second / 60 % 60,
                      fix.second % 60);
        char point[200];
        std::snprintf(point, sizeof point, "<trkpt lat='%.7f' lon='%.7f'><ele>%.1f</ele><time>%s</time></trkpt>\n",
                      fix.latitude_deg, fix.longitude_deg, fix.height_m, time);
        text += point;
    }
    return text + "</trkseg></trk></gpx>\n";
}
/// Places alone, one line.
std::string geojson(const std::vector<Fix>& fixes, double turn_deg = 0) {
    std::string text = R"({"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":[)";
    for (std::size_t n = 0; n < fixes.size(); ++n) {
        char place[100];
        std::snprintf(place, sizeof place, "%s[%.7f,%.7f,%.1f]", n == 0 ? "" : ",", fixes[n].longitude_deg + turn_deg,
                      fixes[n].latitude_deg, fixes[n].height_m);
        text += place;
    }
    return text + "]}}";
}

std::string way_layer(const std::string& source, const std::string& more = "") {
    return "[[layer]]\nname = 'way'\nsource = '" + source + "'\nrole = 'trajectory'\n" + more;
}
const std::string& way_design() {
    static const std::string text =
        plain_ground_design("[[data.element]]\nrole = 'trajectory'\ntechnique = 'tube'\ncolor = '#f0a020'\nsize_m = 60\n");
    return text;
}

struct Format {
    const char* name;
    std::string (*text)(const std::vector<Fix>&);
};
void PrintTo(const Format& format, std::ostream* out) { *out << format.name; }

class BadPaths : public ::testing::TestWithParam<Format> {
protected:
    DataPicture drawn(const std::vector<Fix>& fixes) {
        files_.write(GetParam().text(fixes), GetParam().name);
        return files_.drawn(way_layer(GetParam().name), way_design());
    }
    SceneFiles files_;
};
INSTANTIATE_TEST_SUITE_P(Formats, BadPaths, ::testing::Values(Format{"way.csv", csv}, Format{"way.gpx", gpx}),
                         [](const auto& format) { return std::string(format.param.name).substr(4); });

TEST_P(BadPaths, PointsThatComeTwiceChangeNothing) {
    const DataPicture usual = drawn(flight());
    EXPECT_THAT(files_.notes(), Not(HasSubstr("left out")));
    EXPECT_GT(usual.differing(drawn({flight()[0], flight()[1]})), 500u) << "control: there is a tube";
    std::vector<Fix> repeated;
    for (const Fix& fix : flight()) repeated.insert(repeated.end(), 1 + fix.second % 3, fix);
    EXPECT_EQ(drawn(repeated), usual);
    EXPECT_THAT(files_.notes(), HasSubstr("60 fixes had the time of another one and are left out"));
    std::vector<Fix> moved = repeated;
    for (Fix& fix : moved) fix.latitude_deg += fix.second == 30 ? 0.003 : 0;
    EXPECT_NE(drawn(moved), usual) << "control";
}

TEST_P(BadPaths, TimeThatRunsBackIsPutInOrder) {
    const DataPicture usual = drawn(flight());
    std::vector<Fix> mixed = flight();
    std::reverse(mixed.begin() + 10, mixed.begin() + 25);
    std::swap(mixed[40], mixed[52]);
    EXPECT_EQ(drawn(mixed), usual);
    EXPECT_THAT(files_.notes(), HasSubstr("fixes were earlier than the one before and have been sorted"));
    std::vector<Fix> believed = mixed;
    for (std::size_t n = 0; n < believed.size(); ++n) believed[n].second = static_cast<int>(60 * n);  // slow enough to be true
    EXPECT_GT(drawn(believed).differing(usual), 100u) << "control: the same places one after the other are another way";
}

/// Between the places round the middle there is no tube, and the rest is as it was.
TEST_P(BadPaths, NothingIsDrawnAcrossAGap) {
    const DataPicture usual = drawn(flight());
    std::vector<Fix> broken;
    for (Fix fix : flight()) {
        if (fix.second >= 25 && fix.second < 35) continue;
        fix.second += fix.second >= 35 ? 900 : 0;
        broken.push_back(fix);
    }
    const DataPicture gap = drawn(broken);
    EXPECT_THAT(files_.notes(), HasSubstr("1 gap in the recording; nothing is shown there"));
    const auto tube_between = [](const DataPicture& picture, double from, double to) {
        const std::vector<earth::Geodetic>& places = DataSite::places_from_above();
        std::size_t count = 0;
        for (std::size_t n = 0; n < places.size(); ++n) {
            const double step = (base::degrees(places[n].longitude_rad) - DataSite::kLongitude_deg) / kStep_deg + 30;
            const auto width = picture.picture.width;
            const auto x = static_cast<std::uint32_t>(n % width), y = static_cast<std::uint32_t>(n / width);
            count += step > from && step < to && picture.at(x, y) != kBareGround ? 1 : 0;
        }
        return count;
    };
    // A tube 1000 m above the ground stands a quarter farther from the middle of the picture.
    EXPECT_EQ(tube_between(gap, 26.5, 33.5), 0u);
    EXPECT_GT(tube_between(usual, 26.5, 33.5), 50u) << "control";
    EXPECT_EQ(tube_between(gap, 0, 20), tube_between(usual, 0, 20));
    EXPECT_GT(tube_between(gap, 40, 60), 50u);
}

TEST(BadPaths, LinesOfMapsWithPointsTwiceAndOverTheWholeTurn) {
    SceneFiles files;
    const auto drawn = [&](const std::vector<Fix>& fixes, double turn_deg = 0) {
        files.write(geojson(fixes, turn_deg), "way.geojson");
        return files.drawn(way_layer("way.geojson"), way_design());
    };
    const DataPicture usual = drawn(flight());
    EXPECT_EQ(files.notes(), "");
    std::vector<Fix> repeated;
    for (const Fix& fix : flight()) repeated.insert(repeated.end(), 1 + fix.second % 3, fix);
    EXPECT_EQ(drawn(repeated), usual);
    EXPECT_THAT(files.notes(), HasSubstr("60 points repeat the one before"));
    EXPECT_LE(drawn(flight(), 360).most_difference(usual), 0);
    EXPECT_NE(drawn(flight(), 359.99), usual) << "control";
    // All points in one place are one mark, as a single point is.
    const DataPicture one = drawn({flight()[30]});
    EXPECT_EQ(drawn(std::vector<Fix>(20, flight()[30])), one);
    EXPECT_LT(one.count(kBareGround), 76'795u) << "and it is seen";
}

/// Values between points twice: the colours stay as well.
TEST(BadPaths, RepeatedPointsKeepTheColorsOfTheirSpeeds) {
    SceneFiles files;
    const std::string design = plain_ground_design(
        "[[data.element]]\nrole = 'trajectory'\ntechnique = 'tube'\nattribute = 'ground_speed'\npalette = 'scale.toml'\n"
        "size_m = 60\n");
    const auto drawn = [&](const std::vector<Fix>& fixes) {
        files.write(csv(fixes), "way.csv");
        return files.drawn(way_layer("way.csv"), design);
    };
    const DataPicture usual = drawn(flight());
    std::vector<Fix> repeated = flight();
    repeated.insert(repeated.begin() + 20, 5, flight()[19]);
    EXPECT_EQ(drawn(repeated), usual);
    std::vector<Fix> slow = flight();
    for (Fix& fix : slow) fix.second *= 2;
    EXPECT_NE(drawn(slow), usual) << "control";
}

/// Of a table of places: no system, and longitudes of the whole turn.
TEST(BadPlaces, OfTablesAreRefusedOrTheSame) {
    SceneFiles files;
    const std::string design = plain_ground_design(
        "[[data.element]]\nrole = 'sample'\ntechnique = 'spheres'\nattribute = 'z'\npalette = 'scale.toml'\nsize_m = 200\n");
    const auto layer = [](const std::string& more) {
        return "[[layer]]\nname = 'places'\nsource = 'places.csv'\nrole = 'sample'\nheight_variable = 'z'\n" + more +
               "[[layer.attribute]]\nname = 'z'\n";
    };
    files.write("lon,lat,z\n-84.21,36.71,900\n-84.22,36.705,900\n", "places.csv");
    const DataPicture usual = files.drawn(layer(""), design);
    EXPECT_LT(usual.count(kBareGround), 76'750u);
    files.write("lon,lat,z\n275.79,36.71,900\n275.78,36.705,900\n", "places.csv");
    EXPECT_EQ(files.drawn(layer(""), design), usual);
    files.write("lon,lat,z\n275.79,36.71,900\n275.781,36.705,900\n", "places.csv");
    EXPECT_NE(files.drawn(layer(""), design), usual) << "control";
    files.write("x,y,z\n749200,4066000,900\n748300,4065400,900\n", "places.csv");
    expect_refusal(files.build(layer("")), "which is no place; name its system in 'crs', or correct it");
    EXPECT_FALSE(files.has_database());
    EXPECT_LT(files.drawn(layer("crs = 'EPSG:32616'\n"), design).count(kBareGround), 76'750u) << "named, they are in the picture";
    for (const char* const row : {"nan,36.71,900\n", ",36.71,900\n", "-84.21,91,900\n", "-84.21,inf,900\n"}) {
        files.write(std::string("lon,lat,z\n") + row, "places.csv");
        expect_refusal(files.build(layer("")), "places.csv");
        EXPECT_FALSE(files.has_database()) << row;
    }
}

TEST(BadPaths, AFileWithoutOneUsableFixIsRefused) {
    SceneFiles files;
    for (const char* const rows : {"", "1586684820,95,-84.2,1500\n", "nan,36.7,-84.2,1500\n"}) {
        files.write(std::string("time,latitude_deg,longitude_deg,height_msl_m\n") + rows, "way.csv");
        expect_refusal(files.build(way_layer("way.csv")), "way.csv");
        EXPECT_FALSE(files.has_database());
    }
}

}  // namespace
}  // namespace tedavis::tests::test_bad_paths
