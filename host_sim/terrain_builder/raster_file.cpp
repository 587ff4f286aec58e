#include "host_sim/terrain_builder/raster_file.hpp"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "host_sim/quiet_gdal.hpp"
#include "host_sim/terrain_builder/vertical_reference.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

bool has_extension(const std::string& file, const char* extension) { return EQUAL(CPLGetExtension(file.c_str()), extension); }

GdalDataset open_quietly(const std::string& name) {
    return GdalDataset(GDALDataset::Open(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
}

std::string inside_zip(const std::string& file) {
    if (!has_extension(file, "zip")) return file;
    const std::string archive = "/vsizip/" + file;
    const CPLStringList names(VSIReadDirRecursive(archive.c_str()));
    for (int n = 0; n < names.Count(); ++n) {
        std::string candidate = archive + "/" + names[n];
        if (open_quietly(candidate) != nullptr) return candidate;
    }
    throw UserError(file + ": no raster inside this archive; unpack it and name the height file");
}

/// A grid whose name or unit says that it holds heights of the ground.
bool is_height_grid(const std::string& name, GDALDataset& grid) {
    std::string variable = name.substr(name.find_last_of(':') + 1);
    std::transform(variable.begin(), variable.end(), variable.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const char* word : {"elev", "height", "topo", "altitude", "dem"})
        if (variable.find(word) != std::string::npos) return true;
    const std::string unit = grid.GetRasterCount() > 0 ? grid.GetRasterBand(1)->GetUnitType() : "";
    return !unit.empty() && metres_per_unit(unit).has_value();
}

/// Of a file that holds several grids, the one with heights; which one that is must be beyond doubt.
GdalDataset open_height_grid(const std::string& file, GDALDataset& container) {
    const CPLStringList grids(container.GetMetadata("SUBDATASETS"), FALSE);
    std::vector<GdalDataset> found;
    std::string names;
    for (int n = 1;; ++n) {
        const char* const name = grids.FetchNameValue(CPLSPrintf("SUBDATASET_%d_NAME", n));
        if (name == nullptr) break;
        names += (names.empty() ? "" : ", ") + std::string(name);
        GdalDataset grid = open_quietly(name);
        if (grid != nullptr && is_height_grid(name, *grid)) found.push_back(std::move(grid));
    }
    if (found.size() == 1) return std::move(found.front());
    if (names.empty()) throw UserError(file + ": holds no raster; give a height raster");
    throw UserError(file + ": holds several grids, and which of them is the height is not clear; name one of " + names);
}

[[noreturn]] void refuse_unreadable(const std::string& file) {
    const std::string reason = QuietGdal::last_message();
    VSIStatBufL info;
    if (VSIStatL(file.c_str(), &info) != 0) throw UserError(file + ": no such file; check the name");
    if (has_extension(file, "hgt"))
        throw UserError(file + ": not a whole SRTM tile, or its name does not tell its place (" + reason +
                        "); name it after its south-west corner, such as N46E009.hgt");
    throw UserError(file + ": not a raster that GDAL can read (" + reason +
                    "); give a height raster such as GeoTIFF, HGT, HF2, TER or BT");
}

/// Read by GDAL for many formats, but not listed by all of them.
constexpr const char* kSidecars[] = {".aux.xml", ".ovr", ".msk"};

void add_sidecars(const std::string& file, std::set<std::string>& files) {
    for (const char* const sidecar : kSidecars) {
        VSIStatBufL info;
        if (VSIStatL((file + sidecar).c_str(), &info) == 0) files.insert(file + sidecar);
    }
}

std::vector<std::string> file_list(const std::string& file) {
    const GdalDataset dataset = open_quietly(file);
    if (dataset == nullptr) return {};
    const CPLStringList names(dataset->GetFileList());
    return {names.List(), names.List() + names.Count()};
}

/// Virtual rasters may name each other, in other spellings: each file is opened once.
void add_files_of(const std::string& file, std::set<std::string>& opened, std::set<std::string>& files) {
    std::error_code ignored;
    if (!opened.insert(std::filesystem::weakly_canonical(file, ignored).string()).second) return;
    for (const std::string& part : file_list(file)) {
        if (!files.insert(part).second) continue;
        add_sidecars(part, files);
        if (has_extension(part, "vrt")) add_files_of(part, opened, files);
    }
}

}  // namespace

std::vector<std::string> files_of_raster(const std::string& file) {
    const QuietGdal quiet;
    GDALAllRegister();  // does nothing the second time
    std::set<std::string> files{file};
    add_sidecars(file, files);
    std::set<std::string> opened;
    add_files_of(file, opened, files);
    return {files.begin(), files.end()};
}

GdalDataset open_raster_file(const std::string& file) {
    GDALAllRegister();  // does nothing the second time
    if (has_extension(file, "mmf"))
        throw UserError(file +
                        ": MMF files cannot be read, because no public description of the format exists; export the "
                        "heights as GeoTIFF from the program that wrote it");
    CPLErrorReset();
    VSIStatBufL info;
    if (has_extension(file, "zip") && VSIStatL(file.c_str(), &info) != 0) refuse_unreadable(file);
    GdalDataset dataset = open_quietly(inside_zip(file));
    if (dataset == nullptr) refuse_unreadable(file);
    return dataset->GetRasterCount() < 1 ? open_height_grid(file, *dataset) : std::move(dataset);
}

}  // namespace tedavis::host_sim
