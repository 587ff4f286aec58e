#include "host_sim/scene_builder/source_kind.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_source_kind {
namespace {

using scene::LayerRole;

TEST(SourceKind, IsToldByContent) {
    const test_support::TemporaryFolder folder;
    (void)test_support::RasterFile().write(folder.file("grid.tif"));
    const auto kind = [&](const std::string& name, const std::string& text, LayerRole role) {
        return source_kind(folder.write(name, text), role);
    };
    EXPECT_EQ(source_kind(folder.file("grid.tif"), LayerRole::field), SourceKind::grid);
    EXPECT_EQ(kind("grid.asc", "ncols 2\nnrows 2\nxllcorner 9\nyllcorner 46\ncellsize 1\n1 2\n3 4\n", LayerRole::field),
              SourceKind::grid);
    EXPECT_EQ(kind("zones.txt", "* airspaces\nAC D\nAN ZONE\n", LayerRole::airspace), SourceKind::openair);
    EXPECT_EQ(kind("runways.csv", "id,le_latitude_deg,le_longitude_deg,he_latitude_deg,he_longitude_deg\n", LayerRole::runway),
              SourceKind::runways);
    EXPECT_EQ(kind("dof.dat", "  CURRENCY DATE = 05/31/26\n", LayerRole::obstacle), SourceKind::dof);
    EXPECT_EQ(kind("strips.geojson", R"({"type":"FeatureCollection","features":[]})", LayerRole::runway), SourceKind::vector);
    EXPECT_EQ(kind("x.csv", "lon,lat,height\n9,46,1\n10,46,2\n9,47,1\n10,47,1\n", LayerRole::sample), SourceKind::vector);
    EXPECT_EQ(kind("noise.bin", std::string("\1\2\0\3", 4), LayerRole::field), SourceKind::vector);
    test_support::expect_user_error([&] { (void)source_kind(folder.file("none.tif"), LayerRole::field); }, "none.tif");
    test_support::expect_user_error([&] { (void)source_kind(folder.path(), LayerRole::field); }, folder.path());
}

TEST(SourceKind, FlightsAreWhatTrajectoriesAndTrafficAsFor) {
    const test_support::TemporaryFolder folder;
    const std::string flight = folder.write("f.csv", "time,latitude_deg,longitude_deg\n0,46,9\n");
    const std::string line = folder.write("f.geojson", R"({"type":"LineString","coordinates":[[9,46],[10,47]]})");
    for (const LayerRole role : {LayerRole::trajectory, LayerRole::traffic, LayerRole::ghost}) {
        EXPECT_EQ(source_kind(flight, role), SourceKind::flight);
        EXPECT_EQ(source_kind(folder.write("f.json.gz", "\x1f\x8b\x08"), role), SourceKind::flight);
        EXPECT_EQ(source_kind(folder.write("f.gpx", "<gpx></gpx>"), role), SourceKind::flight);
        EXPECT_EQ(source_kind(folder.write("f.json", R"([{"timestamp":1}])"), role), SourceKind::flight);
        EXPECT_EQ(source_kind(line, role), SourceKind::vector);
    }
    EXPECT_EQ(source_kind(flight, LayerRole::sample), SourceKind::vector);
    EXPECT_EQ(source_kind(folder.write("f.gpx", "<gpx></gpx>"), LayerRole::place), SourceKind::vector);
}

}  // namespace
}  // namespace tedavis::host_sim::test_source_kind
