#include "host_sim/terrain_builder/file_sources.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace tedavis::host_sim {
namespace {

constexpr double kInsetDensity = 1.5;

struct FileExtent {
    std::string file;
    double step_deg, west_deg, south_deg, east_deg, north_deg;
};

FileExtent extent_of(const std::string& file, const RasterOptions& options) {
    const PostSource posts({file}, options);
    const PostGrid& g = posts.grid();
    return {file,
            g.step_lat_deg,
            g.west_deg,
            g.north_deg - g.step_lat_deg * (g.rows - 1),
            g.west_deg + g.step_lon_deg * (g.columns - 1),
            g.north_deg};
}

/// Up to a step of the inset.
bool lies_within(const FileExtent& inset, const std::vector<FileExtent>& ground) {
    double west = 1e9, south = 1e9, east = -1e9, north = -1e9;
    for (const FileExtent& file : ground) {
        // Names of a meridian differ by whole turns.
        const double turns = 360 * std::round((inset.west_deg - file.west_deg) / 360);
        west = std::min(west, file.west_deg + turns);
        east = std::max(east, file.east_deg + turns);
        south = std::min(south, file.south_deg);
        north = std::max(north, file.north_deg);
    }
    const double slack = inset.step_deg;
    return inset.west_deg >= west - slack && inset.east_deg <= east + slack && inset.south_deg >= south - slack &&
           inset.north_deg <= north + slack;
}

PostReaderFactory reader_of(std::vector<std::string> files, const RasterOptions& options) {
    return [files = std::move(files), options] { return std::make_unique<PostSource>(files, options); };
}

TerrainSources one_raster(const std::vector<std::string>& files, const RasterOptions& options, std::vector<std::string>& notes) {
    const PostSource posts(files, options);
    notes.insert(notes.end(), posts.notes().begin(), posts.notes().end());
    return reader_of(files, options);
}

}  // namespace

TerrainSources sources_of_files(const std::vector<std::string>& files, const RasterOptions& options,
                                std::vector<std::string>& notes) {
    if (files.size() < 2 || options.extent || options.encoding) return one_raster(files, options, notes);
    RasterOptions whole = options;
    whole.bounds.reset();
    std::vector<FileExtent> extents;
    for (const std::string& file : files) extents.push_back(extent_of(file, whole));
    double coarsest_deg = 0;
    for (const FileExtent& extent : extents) coarsest_deg = std::max(coarsest_deg, extent.step_deg);
    std::vector<FileExtent> ground, insets;
    for (const FileExtent& extent : extents) (extent.step_deg * kInsetDensity < coarsest_deg ? insets : ground).push_back(extent);
    const bool all_within =
        std::all_of(insets.begin(), insets.end(), [&](const FileExtent& e) { return lies_within(e, ground); });
    if (insets.empty() || !all_within) return one_raster(files, options, notes);
    std::vector<std::string> names;
    for (const FileExtent& file : ground) names.push_back(file.file);
    TerrainSources sources = one_raster(names, options, notes);
    for (const FileExtent& inset : insets) {
        std::vector<std::string> own;
        (void)one_raster({inset.file}, whole, own);
        notes.insert(notes.end(), own.begin(), own.end());
        sources.insets.push_back(reader_of({inset.file}, whole));
    }
    return sources;
}

}  // namespace tedavis::host_sim
