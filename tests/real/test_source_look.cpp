// What `tedavis scene look` says of published files: each that a scene can take is described, and the layer that it prints builds
// as it is; of the others one sentence says why not.
#include <gtest/gtest.h>

#include "host_sim/scene_builder/source_look.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/scene/looked_scene.hpp"

namespace tedavis::test_source_look {
namespace {

using host_sim::look_at_source;
using host_sim::SourceKind;
using host_sim::SourceLook;

SourceLook look(const std::string& file) { return look_at_source(test_support::real_data_dir() + "/" + file, ""); }

TEST(SourceLookOfRealFiles, LayersBuildAsTheyAre) {
    struct File {
        const char* name;
        SourceKind kind;
    };
    constexpr File kFiles[] = {{"weather/ens_storm.grib", SourceKind::grid},
                               {"weather/era5_davos_pressure_levels_202001.nc", SourceKind::grid},
                               {"weather/opera_20241126_0100_dbz_alps_0.01deg.tif", SourceKind::grid},
                               {"weather/opera_20241126_0100_quality_alps_0.01deg.tif", SourceKind::grid},
                               {"terrain/davos_engadin_srtm1_1arcsec_2160x2160_wgs84.tif", SourceKind::grid},
                               {"formats/davos_1025.hf2", SourceKind::grid},
                               {"formats/davos_utm.bt", SourceKind::grid},
                               {"formats/swisstopo_dhm25_interlaken_25m_350x240_lv03.bt", SourceKind::grid},
                               {"nav/davos_places.csv", SourceKind::vector},
                               {"nav/runways.csv", SourceKind::runways},
                               {"flights/adsb_noisy_landing.json.gz", SourceKind::flight},
                               {"flights/adsb_rega_sg.json.gz", SourceKind::flight},
                               {"flights/adsb_switzerland_map.json.gz", SourceKind::flight},
                               {"flights/igcxc_discontinuity.igc", SourceKind::flight},
                               {"flights/igcxc_trifai-xcontest-362.70.igc", SourceKind::flight}};
    for (const File& file : kFiles) {
        const SourceLook found = look(file.name);
        EXPECT_EQ(found.kind, file.kind) << file.name;
        EXPECT_GT(test_support::built_layer(found).point_count(), 0u) << found.layer;
    }
}

TEST(SourceLookOfRealFiles, WhatNoSceneCanTakeIsSaid) {
    using test_support::expect_user_error;
    expect_user_error([] { (void)look("flights/adsb_fuelflow_a320.json.gz"); }, "as a recorded flight: ");
    expect_user_error([] { (void)look("formats/davos_utm.ter"); }, "check 'crs'");
    expect_user_error([] { (void)look("formats/swisstopo_dhm25_interlaken_25m_350x240_lv03.prj"); }, "no scene can take it");
    expect_user_error([] { (void)look("terrain/jacksboro_fault_dem.npz"); }, "no scene can take it");
    expect_user_error([] { (void)look("terrain/N42E001_pyrenees_andorra_srtm3.hgt.zip"); }, "no scene can take it");
}

/// As GDAL's own listing of the file's bands has it.
TEST(SourceLookOfRealFiles, AnEnsembleHasItsGustsAndAGeopotentialAt850Hectopascals) {
    const SourceLook found = look("weather/ens_storm.grib");
    ASSERT_EQ(found.grid->variables.size(), 2u);
    const host_sim::VariableLook& gust = found.grid->variables[0];
    EXPECT_EQ(gust.name, "var28 of table 228 of center ECMWF");
    EXPECT_EQ(gust.most_members, 51u);
    EXPECT_EQ(gust.least_members, 51u);
    EXPECT_EQ(gust.times_ns.size(), 3u);
    const host_sim::VariableLook& z = found.grid->variables[1];
    EXPECT_EQ(z.name, "Z");
    EXPECT_EQ(z.levels, std::vector<double>{850});
    EXPECT_EQ(z.level_unit, "hPa");
    EXPECT_EQ(z.unit, "m^2/s^2");
    ASSERT_TRUE(z.range);
    EXPECT_NEAR(z.range->least / 9.80665, 1200, 400) << "the height of 850 hPa, m";
    EXPECT_NEAR(z.range->greatest / 9.80665, 1500, 300);
    EXPECT_EQ(z.times_ns.size(), 1u);
}

}  // namespace
}  // namespace tedavis::test_source_look
