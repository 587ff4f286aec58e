#include "host_sim/scene_builder/source_kind.hpp"

#include <gdal_priv.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "host_sim/input_file.hpp"
#include "host_sim/quiet_gdal.hpp"
#include "host_sim/quiet_stdout.hpp"
#include "host_sim/scene_builder/dof_source.hpp"
#include "host_sim/scene_builder/openair_source.hpp"
#include "host_sim/scene_builder/runway_source.hpp"
#include "host_sim/terrain_builder/raster_file.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kLooked = 65536;

std::string beginning_of(const std::string& path) {
    std::string text(kLooked, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    return text;
}

bool is_packed(std::string_view text) { return text.substr(0, 2) == "\x1f\x8b"; }
bool is_text(std::string_view text) { return text.find('\0') == std::string_view::npos; }

/// GDAL takes a table of three columns for a raster of points.
bool is_table_name(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".csv" || extension == ".tsv";
}

bool is_geojson(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (first == std::string_view::npos || text[first] != '{') return false;
    for (const char* const word : {"\"FeatureCollection\"", "\"Feature\"", "\"coordinates\"", "\"geometries\""})
        if (text.find(word) != std::string_view::npos) return true;
    return false;
}

bool is_raster(const std::string& path) {
    GDALAllRegister();
    const QuietGdal quiet;
    const QuietStdout quiet_reader;  // of GRIB
    return GdalDataset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY)) != nullptr;
}

}  // namespace

SourceKind source_kind(const std::string& path, scene::LayerRole role) {
    require_regular_file(path);
    const std::string text = beginning_of(path);
    using scene::LayerRole;
    const bool may_be_flight = role == LayerRole::trajectory || role == LayerRole::traffic || role == LayerRole::ghost;
    if (may_be_flight && (is_packed(text) || (is_text(text) && !is_geojson(text)))) return SourceKind::flight;
    if (is_text(text) && is_openair(text)) return SourceKind::openair;
    if (is_text(text) && is_runway_table(text)) return SourceKind::runways;
    if (is_text(text) && is_dof(text)) return SourceKind::dof;
    return !is_table_name(path) && is_raster(path) ? SourceKind::grid : SourceKind::vector;
}

}  // namespace tedavis::host_sim
