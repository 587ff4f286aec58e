#include "host_sim/scene_builder/dof_source.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_dof_source {
namespace {

using test_support::expect_user_error;
using ::testing::ElementsAre;

constexpr const char* kHead =
    "  CURRENCY DATE = 05/31/26\n"
    "                                     LATITUDE    LONGITUDE     OBSTACLE            AGL  AMSL LT ACC MAR FAA       ACTION\n"
    "OAS#      V CO ST CITY             DEG MIN SEC  DEG MIN SEC   TYPE                 HT    HT    H V IND STUDY            "
    "JDATE\n"
    "----------------------------------------------------------------------------------------------------------------------------"
    "---\n";
// Invented records in the columns of the file.
constexpr const char* kTower =
    "47-900001 O US TN JELLICO          36 35 12.50N 084 07 30.00W TOWER              1 00256 01341 D 5 E N                C "
    "2026001 ";
constexpr const char* kTank =
    "47-900002 U US TN ELK VALLEY       36 29 15.00S 174 15 00.00E TANK               2 00100 -0017 N 9 I P                A "
    "2026001 ";

SourceFeatures read(const std::string& records) { return read_dof(kHead + records, "dof.dat"); }

std::string with(std::string record, std::size_t at, const std::string& text) { return record.replace(at, text.size(), text); }

TEST(Dof, ColumnsBecomeMetresAndTolerances) {
    const SourceFeatures found = read(std::string(kTower) + "\r\n" + kTank + "\n");
    ASSERT_EQ(found.features.size(), 2u);
    EXPECT_EQ(found.height_datum, scene::HeightDatum::ground);
    EXPECT_EQ(found.data_time_ns, 1'780'185'600'000'000'000) << "date -u -d 2026-05-31 +%s";
    const SourceFeature &tower = found.features[0], &tank = found.features[1];
    EXPECT_NEAR(tower.points[0].latitude_deg, 36 + 35.0 / 60 + 12.5 / 3600, 1e-12);
    EXPECT_NEAR(tower.points[0].longitude_deg, -(84 + 7.5 / 60), 1e-12);
    EXPECT_NEAR(*tower.points[0].height_m, 256 * 0.3048, 1e-9);
    EXPECT_EQ(tower.fields.at("ident"), "47-900001");
    EXPECT_EQ(tower.fields.at("name"), "TOWER");
    EXPECT_EQ(tower.fields.at("city"), "JELLICO");
    EXPECT_EQ(tower.fields.at("status"), "verified");
    EXPECT_EQ(tower.fields.at("lighting"), "D");
    EXPECT_NEAR(std::stod(tower.fields.at("top_m")), 1341 * 0.3048, 1e-5);
    EXPECT_NEAR(std::stod(tower.fields.at("horizontal_m")), 152.4, 1e-5) << "5: 500 ft";
    EXPECT_NEAR(std::stod(tower.fields.at("vertical_m")), 38.1, 1e-5) << "E: 125 ft";
    EXPECT_LT(tank.points[0].latitude_deg, 0);
    EXPECT_GT(tank.points[0].longitude_deg, 174);
    EXPECT_EQ(tank.fields.at("status"), "unverified");
    EXPECT_EQ(tank.fields.at("quantity"), "2");
    EXPECT_NEAR(std::stod(tank.fields.at("top_m")), -17 * 0.3048, 1e-5);
    EXPECT_EQ(tank.fields.count("horizontal_m"), 0u) << "9 is unknown";
    EXPECT_EQ(tank.fields.count("vertical_m"), 0u) << "I is unknown";
}

TEST(Dof, DismantledOnesAreLeftOutAndSaid) {
    const SourceFeatures found = read(with(kTower, 118, "D") + "\n" + kTank + "\n");
    EXPECT_EQ(found.features.size(), 1u);
    EXPECT_THAT(found.notes, ElementsAre("1 dismantled obstacles are not shown"));
}

TEST(Dof, IsKnownByItsFirstLine) {
    EXPECT_TRUE(is_dof(kHead));
    EXPECT_TRUE(is_dof(std::string(kTower) + "\n"));
    EXPECT_FALSE(is_dof(""));
    EXPECT_FALSE(is_dof("lon,lat\n47-900001 O\n"));
    EXPECT_FALSE(is_dof("47-90000A O US"));
}

TEST(Dof, FaultsAreSaidWithTheirLine) {
    const auto refused = [](const std::string& records, const std::string& words) {
        expect_user_error([&records] { (void)read(records); }, words);
    };
    refused(std::string(kTower).substr(0, 90) + "\n", "dof.dat:5: this record is cut; get a whole copy of the file");
    refused(std::string(kTower) + "\nwords\n", "dof.dat:6: this is no record");
    refused(with(kTower, 83, "tall "), "dof.dat:5: 'tall' is no height in feet");
    refused(with(kTower, 35, "96"), "is no place");
    refused(with(kTower, 46, "X"), "is no place");
    refused(with(kTower, 35, "north       "), "'north' is no place");
    expect_user_error([] { (void)read_dof("CURRENCY DATE = 13/31/26\n", "dof.dat"); }, "dof.dat:1: '13/31/26' is no date");
    EXPECT_TRUE(read("").features.empty());
}

TEST(Dof, UsualAttributesAreStated) {
    const SourceFeatures found = read(std::string(kTower) + "\n");
    for (const AttributeRecipe& usual : usual_attributes_of_dof()) EXPECT_EQ(found.features[0].fields.count(usual.variable), 1u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_dof_source
