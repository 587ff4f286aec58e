#include "host_sim/scene_builder/source_look.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include "tests/host_sim/scene_builder/grib_file.hpp"
#include "tests/host_sim/scene_builder/netcdf_file.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/scene/looked_scene.hpp"

namespace tedavis::host_sim::test_source_look {
namespace {

using scene::LayerRole;
using scene::LayerShape;
using test_support::built_layer;
using test_support::expect_user_error;

constexpr const char* kPlaces = "kind,latitude_deg,longitude_deg,name\ntown,46.8,9.8,Davos\nhut,46.7,9.7,\n";
constexpr const char* kFlight =
    "time,latitude_deg,longitude_deg,height_msl_m,aircraft\n1586684820,46.8,9.8,2000,HB1\n1586684821,46.8005,9.8,2002,HB1\n"
    "1586684822,46.801,9.8,2004,HB1\n";
constexpr const char* kZones =
    "AC R\nAN A\nAL GND\nAH 3000ft MSL\nDP 46:00:00N 009:00:00E\nDP 46:10:00N 009:00:00E\nDP 46:10:00N 009:10:00E\n";
constexpr const char* kRunways =
    "\"airport_ident\",\"length_ft\",\"width_ft\",\"surface\",\"lighted\",\"closed\",\"le_ident\",\"le_latitude_deg\","
    "\"le_longitude_deg\",\"le_elevation_ft\",\"he_ident\",\"he_latitude_deg\",\"he_longitude_deg\",\"he_elevation_ft\"\n"
    "\"LSZS\",5906,131,\"ASP\",1,0,\"03\",46.527,9.878,5600,\"21\",46.541,9.890,5580\n";
// An invented record in the columns of the file.
constexpr const char* kObstacles =
    "  CURRENCY DATE = 05/31/26\n"
    "47-900001 O US TN JELLICO          36 35 12.50N 084 07 30.00W TOWER              1 00256 01341 D 5 E N                C "
    "2026001 \n";

class SourceLooks : public ::testing::Test {
protected:
    SourceLook look(const std::string& name, const std::string& content) {
        return look_at_source(folder_.write(name, content), "");
    }
    test_support::TemporaryFolder folder_;
};

/// Each kind of file is recognized, and the printed layer builds as it is.
TEST_F(SourceLooks, LayersOfTextFilesBuild) {
    const auto expect_built = [this](const char* name, const char* content, SourceKind kind, LayerRole role, LayerShape shape) {
        const SourceLook found = look(name, content);
        EXPECT_EQ(found.kind, kind) << name;
        const LayerDraft layer = built_layer(found);
        EXPECT_EQ(layer.role, role) << found.layer;
        EXPECT_EQ(layer.shape, shape) << found.layer;
        EXPECT_GT(layer.feature_count(), 0u) << found.layer;
    };
    expect_built("places.csv", kPlaces, SourceKind::vector, LayerRole::place, LayerShape::points);
    expect_built("flight.csv", kFlight, SourceKind::flight, LayerRole::trajectory, LayerShape::lines);
    expect_built("zones.txt", kZones, SourceKind::openair, LayerRole::airspace, LayerShape::areas);
    expect_built("runways.csv", kRunways, SourceKind::runways, LayerRole::runway, LayerShape::lines);
    expect_built("obstacles.dat", kObstacles, SourceKind::dof, LayerRole::obstacle, LayerShape::points);
    expect_built("stations.csv", "lon,lat,height_ft,wind_kt,seen\n9.8,46.8,1000,12,2026-06-01T12:00:00Z\n", SourceKind::vector,
                 LayerRole::sample, LayerShape::points);
    expect_built("roads.geojson",
                 R"({"type":"Feature","properties":{"width_m":7,"speed":80},)"
                 R"("geometry":{"type":"LineString","coordinates":[[9,46],[9.1,46.1]]}})",
                 SourceKind::vector, LayerRole::road, LayerShape::lines);
    expect_built("woods.geojson",
                 R"({"type":"Feature","properties":{"kind":"wood","height_ft":60,"toward_deg":5},)"
                 R"("geometry":{"type":"Polygon","coordinates":[[[9,46],[9.1,46.1],[9,46.1],[9,46]]]}})",
                 SourceKind::vector, LayerRole::land_cover, LayerShape::areas);
}

TEST_F(SourceLooks, UnitsOfColumnsAreConverted) {
    const LayerDraft layer = built_layer(look("stations.csv", "lon,lat,height_ft,wind_kt\n9.8,46.8,1000,10\n"));
    ASSERT_EQ(layer.attributes.size(), 2u);
    EXPECT_EQ(layer.attributes[0].name, "height");
    EXPECT_NEAR(double{layer.attributes[0].values[0]}, 304.8, 1e-3);
    EXPECT_EQ(layer.attributes[1].unit, "m/s");
    EXPECT_NEAR(double{layer.attributes[1].values[0]}, 5.14444, 1e-4);
}

TEST_F(SourceLooks, LayersOfMapsBuild) {
    GDALAllRegister();
    for (const char* const format : {"GPKG", "ESRI Shapefile", "KML"}) {
        const std::string path = folder_.file(std::string("map") + (format[0] == 'G'   ? ".gpkg"
                                                                    : format[0] == 'E' ? ".shp"
                                                                                       : ".kml"));
        GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName(format);
        ASSERT_NE(driver, nullptr) << format;
        {
            const std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> map(
                driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
            ASSERT_NE(map, nullptr) << format;
            OGRSpatialReference degrees;
            degrees.SetFromUserInput("EPSG:4326");
            degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
            OGRLayer* const points = map->CreateLayer("points", &degrees, wkbPoint, nullptr);
            ASSERT_NE(points, nullptr) << format;
            OGRFieldDefn weight("weight", OFTReal);
            ASSERT_EQ(points->CreateField(&weight), OGRERR_NONE);
            OGRFeature feature(points->GetLayerDefn());
            OGRPoint place(9.8, 46.8);
            feature.SetGeometry(&place);
            feature.SetField("weight", 2.5);
            ASSERT_EQ(points->CreateFeature(&feature), OGRERR_NONE);
        }
        const SourceLook found = look_at_source(path, "");
        EXPECT_EQ(found.kind, SourceKind::vector) << format;
        EXPECT_EQ(found.features->points, 1u) << format;
        EXPECT_FALSE(found.features->system.empty()) << format;
        EXPECT_EQ(built_layer(found).feature_count(), 1u) << found.layer;
    }
}

TEST_F(SourceLooks, LayersOfGridsBuild) {
    test_support::RasterFile raster;
    raster.bands = 2;
    const SourceLook tif = look_at_source(raster.write(folder_.file("grid.tif")), "");
    EXPECT_EQ(built_layer(tif).attributes.at(0).values.at(0), 1000);
    raster.crs = "";
    raster.transform = {2780000, 1000, 0, 1190000, 0, -1000};
    EXPECT_GT(built_layer(look_at_source(raster.write(folder_.file("swiss.tif")), "EPSG:2056")).point_count(), 0u);
    test_support::NetcdfFile file;
    file.times_h = {6, 9, 12};
    file.write(folder_.file("u.nc"));
    const LayerDraft netcdf = built_layer(look_at_source(folder_.file("u.nc"), ""));
    EXPECT_EQ(netcdf.grid.times, 3u);
    EXPECT_EQ(netcdf.attributes.at(0).unit, "m/s");
}

/// A wind over two levels, and an ensemble of gusts beside a geopotential at another level, as services mix them in one file.
TEST_F(SourceLooks, LayersOfGribBuild) {
    const std::string wind = folder_.file("wind.grb2"), gusts = folder_.file("gusts.grb2");
    test_support::write_grib(
        wind, {{2, 2, 100, 50000, 0, 10}, {2, 2, 100, 85000, 0, 8}, {2, 3, 100, 50000, 0, 2}, {2, 3, 100, 85000, 0, 1}});
    const LayerDraft layer = built_layer(look_at_source(wind, ""));
    EXPECT_EQ(layer.role, LayerRole::wind);
    ASSERT_EQ(layer.levels_m.size(), 2u);
    EXPECT_NEAR(layer.levels_m[0], 1457, 2) << "850 hPa";
    EXPECT_NEAR(double{layer.attributes.at(0).values.at(5)}, 8, 1e-3) << "the eastward wind there";
    EXPECT_NEAR(double{layer.attributes.at(1).values.at(5)}, 1, 1e-3);
    test_support::write_grib(
        gusts,
        {{2, 22, 1, 0, 6, 20}, {2, 22, 1, 0, 6, 24}, {2, 22, 1, 0, 12, 30}, {2, 22, 1, 0, 12, 34}, {3, 4, 100, 85000, 6, 14000}});
    const SourceLook found = look_at_source(gusts, "");
    ASSERT_EQ(found.grid->variables.size(), 2u);
    const LayerDraft mean = built_layer(found);
    EXPECT_EQ(mean.grid.times, 2u);
    EXPECT_NEAR(double{mean.attributes.at(0).values.at(5)}, 22, 1e-3) << found.layer;
    EXPECT_TRUE(mean.attributes.at(0).uncertainties.at(5).is_known());
}

TEST_F(SourceLooks, TablesWithTimesThatNothingFlewAreTables) {
    const SourceLook found = look("profiles.csv",
                                  "name,longitude_deg,latitude_deg,height_m,time,temperature_c\n"
                                  "A,9.8,46.9,3090,2020-01-15T12:00:00Z,0.5\nA,9.8,46.9,4311,2020-01-15T12:00:00Z,-6.6\n"
                                  "B,10.0,46.9,3090,2020-01-15T12:00:00Z,0.6\nB,10.0,46.9,4311,2020-01-15T12:00:00Z,-6.6\n");
    EXPECT_EQ(found.kind, SourceKind::vector);
    EXPECT_EQ(built_layer(found).feature_count(), 4u);
}

TEST_F(SourceLooks, WhatNoSceneCanTakeIsRefused) {
    expect_user_error([this] { (void)look("notes.md", "# Notes\nNothing that has a place.\n"); },
                      "notes.md: no scene can take it");
    expect_user_error([this] { (void)look_at_source(folder_.file("none.csv"), ""); }, "none.csv");
    expect_user_error([this] { (void)look_at_source(folder_.path(), ""); }, folder_.path());
    expect_user_error([this] { (void)look("packed.gz", "\x1f\x8b nothing"); }, "packed.gz");
}

}  // namespace
}  // namespace tedavis::host_sim::test_source_look
