#include "host_sim/terrain_builder/fractal_geotiff.hpp"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <vector>

#include "host_sim/atomic_file.hpp"
#include "host_sim/quiet_gdal.hpp"
#include "host_sim/terrain_builder/fractal_terrain.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr int kTile = 256;
constexpr const char *kMadeBy = "TIFFTAG_SOFTWARE", *kMaker = "tedavis terrain fractal";

using Dataset = std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter>;

void require_space(const std::string& path, std::uint32_t posts, FractalNumbers numbers) {
    const std::uint64_t tiles = (posts + kTile - 1) / kTile,
                        bytes = tiles * tiles * kTile * kTile * (numbers == FractalNumbers::float32 ? 4 : 2);
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::absolute(path, error).parent_path();
    const std::filesystem::space_info space = std::filesystem::space(folder, error);
    if (!error && space.available < bytes)
        throw UserError(path + ": needs " + std::to_string(bytes >> 20) + " MiB, but its disk has only " +
                        std::to_string(space.available >> 20) + " MiB left; give a smaller --size or another disk");
}

/// Rasters are what people have: only what says that it was made here makes room for the next.
void require_own(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error) || std::filesystem::file_size(path, error) == 0) return;
    GDALAllRegister();
    const Dataset found(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
    const char* const maker = found == nullptr ? nullptr : found->GetMetadataItem(kMadeBy);
    if (maker == nullptr || std::string(maker) != kMaker)
        throw UserError(path + ": is there already and is no generated terrain; name another output, or remove this file first");
}

Dataset create(const std::string& path, std::uint32_t posts, FractalNumbers numbers) {
    GDALAllRegister();
    CPLStringList options;
    for (const char* option : {"TILED=YES", "BLOCKXSIZE=256", "BLOCKYSIZE=256", "BIGTIFF=IF_SAFER"}) options.AddString(option);
    const int side = static_cast<int>(posts);
    Dataset file(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        path.c_str(), side, side, 1, numbers == FractalNumbers::float32 ? GDT_Float32 : GDT_Int16, options.List()));
    if (file == nullptr) return file;
    // Posts are the centres of pixels.
    double transform[6] = {kFractalWest_deg - 0.5 * kFractalStep_deg,
                           kFractalStep_deg,
                           0,
                           kFractalNorth_deg + 0.5 * kFractalStep_deg,
                           0,
                           -kFractalStep_deg};
    file->SetGeoTransform(transform);
    OGRSpatialReference wgs84;
    wgs84.importFromEPSG(4326);
    file->SetSpatialRef(&wgs84);
    file->SetMetadataItem(kMadeBy, kMaker);
    return file;
}

/// One tile, whole also where it reaches beyond the raster's edge.
bool write_tile(GDALRasterBand& band, int column, int row, const FractalTerrain& terrain, FractalNumbers numbers) {
    std::vector<float> heights(kTile * kTile);
    terrain.read(column * kTile, row * kTile, kTile, kTile, heights);
    if (numbers == FractalNumbers::float32) return band.WriteBlock(column, row, heights.data()) == CE_None;
    std::vector<std::int16_t> metres(heights.size());
    for (std::size_t n = 0; n < heights.size(); ++n) metres[n] = static_cast<std::int16_t>(std::floor(heights[n] + 0.5f));
    return band.WriteBlock(column, row, metres.data()) == CE_None;
}

bool write_tiles(GDALDataset& file, std::uint32_t posts, const FractalTerrain& terrain, FractalNumbers numbers,
                 const FractalProgress& progress) {
    const int tiles = (static_cast<int>(posts) + kTile - 1) / kTile;
    for (int row = 0; row < tiles; ++row) {
        for (int column = 0; column < tiles; ++column) {
            if (!write_tile(*file.GetRasterBand(1), column, row, terrain, numbers)) return false;
            if (progress)
                progress(static_cast<std::uint64_t>(row) * tiles + column + 1, static_cast<std::uint64_t>(tiles) * tiles);
        }
    }
    return true;
}

}  // namespace

void write_fractal_geotiff(const std::string& path, std::uint32_t posts, std::uint64_t seed, FractalNumbers numbers,
                           const FractalProgress& progress) {
    const QuietGdal quiet;
    require_own(path);
    AtomicFile file(path);
    require_space(path, posts, numbers);
    bool written = false;
    {
        const Dataset raster = create(file.part_path(), posts, numbers);
        written = raster != nullptr && write_tiles(*raster, posts, FractalTerrain(seed), numbers, progress);
    }  // closing it writes what is left
    if (!written || CPLGetLastErrorType() >= CE_Failure)
        throw UserError(path + ": could not be written to its end (" + QuietGdal::last_message() + "); check the free space");
    file.commit();
}

}  // namespace tedavis::host_sim
