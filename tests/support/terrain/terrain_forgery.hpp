/// `terrain build` and `terrain check` over a raster file, and copies with one height changed by a metre.
#pragma once

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include "host_sim/commands/terrain.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/terrain/damaged_terrain.hpp"
#include "tests/support/terrain/gdal_terrain.hpp"

namespace tedavis::test_support {

class TerrainForgery {
public:
    explicit TerrainForgery(const std::string& raster) : raster_(raster) {
        host_sim::TerrainBuildOptions options;
        options.rasters = {raster};
        options.output = database();
        EXPECT_EQ(run_command([&](host_sim::Console& console) { return host_sim::run_terrain_build(options, console); }).code, 0);
    }

    [[nodiscard]] CommandRun check() const { return check_against(raster_); }

    /// The height of a vertex of the finest level, a metre more; with or without checksums that match.
    void raise_a_vertex(bool sign) {
        const std::string file = folder_.read("t.tdb");
        std::vector<std::uint8_t> image(file.begin(), file.end());
        int chunks = 0;
        for_entries(image, [&](const terrain::ChunkEntry& entry, std::uint64_t) {
            if (entry.level != 0 || ++chunks != 41) return;
            terrain::ChunkVertex vertex;
            std::uint8_t* const place = image.data() + entry.payload.offset + 500 * sizeof vertex;
            std::memcpy(&vertex, place, sizeof vertex);
            vertex.height_m += 1;
            std::memcpy(place, &vertex, sizeof vertex);
        });
        EXPECT_GE(chunks, 41);
        if (sign) sign_chunks(image);
        folder_.write("t.tdb", std::string(image.begin(), image.end()));
    }

    /// Against a copy of the raster in which one post is a metre higher.
    [[nodiscard]] CommandRun check_against_a_raised_post() const {
        GDALAllRegister();
        const std::string copy = folder_.file("raised.tif"), path = GdalBand::path_of(raster_);
        std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> from(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
        std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> to(GetGDALDriverManager()->GetDriverByName("GTiff")->CreateCopy(
            copy.c_str(), from.get(), TRUE, nullptr, nullptr, nullptr));
        float height_m = 0;
        GDALRasterBand& band = *to->GetRasterBand(1);
        EXPECT_EQ(band.RasterIO(GF_Read, 203, 117, 1, 1, &height_m, 1, 1, GDT_Float32, 0, 0), CE_None);
        EXPECT_GT(height_m, 0);
        height_m += 1;
        EXPECT_EQ(band.RasterIO(GF_Write, 203, 117, 1, 1, &height_m, 1, 1, GDT_Float32, 0, 0), CE_None);
        to.reset();
        return check_against(copy);
    }

private:
    [[nodiscard]] std::string database() const { return folder_.file("t.tdb"); }
    [[nodiscard]] CommandRun check_against(const std::string& raster) const {
        host_sim::TerrainBuildOptions options;
        options.rasters = {raster};
        const std::string checked = database();
        return run_command(
            [&](host_sim::Console& console) {
                return host_sim::run_terrain_check({checked, options}, console);
            },
            true);
    }

    std::string raster_;
    TemporaryFolder folder_;
};

/// The database holds; a vertex that was raised is found, signed or not; a post that was raised is found.
inline void expect_check_finds_a_metre(const std::string& raster) {
    TerrainForgery forgery(raster);
    const CommandRun sound = forgery.check();
    EXPECT_EQ(sound.code, 0);
    EXPECT_EQ(sound.json()["violations"], 0);
    EXPECT_GT(sound.json()["chunks"], 100);
    const CommandRun post = forgery.check_against_a_raised_post();
    EXPECT_EQ(post.code, 1);
    EXPECT_GE(post.json()["violations"], 1);
    EXPECT_NEAR(post.json()["worst_excess_m"].get<double>(), 1, 0.01);
    forgery.raise_a_vertex(false);
    const CommandRun damaged = forgery.check();
    EXPECT_EQ(damaged.code, 1);
    EXPECT_EQ(damaged.json()["violations"], 1);
    forgery.raise_a_vertex(true);
    const CommandRun forged = forgery.check();
    EXPECT_EQ(forged.code, 1);
    EXPECT_EQ(forged.json()["violations"], 1);
    EXPECT_NEAR(forged.json()["worst_excess_m"].get<double>(), 2, 1e-3) << "raised twice";
}

}  // namespace tedavis::test_support
