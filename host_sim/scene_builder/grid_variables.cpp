#include "host_sim/scene_builder/grid_variables.hpp"

#include <cpl_string.h>

#include <algorithm>
#include <set>

#include "host_sim/input_file.hpp"
#include "host_sim/quiet_gdal.hpp"
#include "host_sim/quiet_stdout.hpp"
#include "host_sim/scene_builder/grid_times.hpp"
#include "host_sim/terrain_builder/raster_file.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

GdalDataset open_listed(const std::string& name) {
    const QuietStdout quiet;
    return GdalDataset(GDALDataset::Open(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
}

std::string band_text(GDALRasterBand& band, const char* key) {
    const char* const text = band.GetMetadataItem(key);
    return text != nullptr ? text : "";
}

/// Of the first item whose key ends so, as ODIM files prefix theirs by data set.
std::string odim_text(GDALDataset& dataset, const std::string& end) {
    char** const items = dataset.GetMetadata();
    for (int n = 0; items != nullptr && items[n] != nullptr; ++n) {
        const std::string item(items[n]);
        const std::size_t equals = item.find('=');
        if (equals == std::string::npos || equals < end.size() || item.compare(equals - end.size(), end.size(), end) != 0)
            continue;
        if (item.find("quality") < equals) continue;  // of the field that says how good the data are
        return item.substr(equals + 1);
    }
    return {};
}

std::optional<double> odim_number(GDALDataset& dataset, const std::string& end) {
    const std::string text = odim_text(dataset, end);
    return text.empty() ? std::nullopt : std::optional(CPLAtof(text.c_str()));
}

std::string quantity_of(GDALDataset& dataset, GDALRasterBand& band) {
    for (const char* const key : {"standard_name", "GRIB_ELEMENT"})
        if (std::string text = band_text(band, key); !text.empty()) return text;
    if (std::string odim = odim_text(dataset, "what_quantity"); !odim.empty()) return odim;
    if (std::string text = band_text(band, "long_name"); !text.empty()) return text;
    return band.GetDescription();
}

/// What bands of one variable have in common; empty for bands that stand alone.
std::string family_of(GDALRasterBand& band) {
    for (const char* const key : {"NETCDF_VARNAME", "GRIB_ELEMENT"})
        if (std::string text = band_text(band, key); !text.empty()) return text;
    return {};
}

std::string level_text_of(GDALRasterBand& band) {
    for (const char* const key : {"NETCDF_DIM_level", "NETCDF_DIM_pressure_level", "NETCDF_DIM_height",
                                  "NETCDF_DIM_isobaricInhPa", "NETCDF_DIM_z", "NETCDF_DIM_lev", "GRIB_SHORT_NAME"})
        if (std::string text = band_text(band, key); !text.empty()) return text;
    return {};
}

void take_times(const GridTimes& times, GDALRasterBand& band, GridVariable& variable) {
    const std::optional<std::int64_t> time = times.of(band);
    if (!time) return;
    variable.first_ns = std::min(variable.first_ns.value_or(*time), *time);
    variable.last_ns = std::max(variable.last_ns.value_or(*time), *time);
}

/// `bands`: those of the variable, counted from 1.
GridVariable variable_of(GDALDataset& dataset, const std::string& file, const std::vector<int>& bands, const std::string& name) {
    GDALRasterBand& first = *dataset.GetRasterBand(bands.front());
    GridVariable variable;
    variable.name = name;
    variable.quantity = quantity_of(dataset, first);
    variable.unit = first.GetUnitType();
    variable.missing = odim_number(dataset, "what_nodata");
    variable.undetected = odim_number(dataset, "what_undetect");
    const GridTimes times(dataset, file);
    std::set<std::string> levels;
    for (const int band : bands) {
        take_times(times, *dataset.GetRasterBand(band), variable);
        levels.insert(level_text_of(*dataset.GetRasterBand(band)));
    }
    variable.has_levels = levels.size() > 1;
    return variable;
}

std::vector<GridVariable> variables_of(GDALDataset& dataset, const std::string& file) {
    std::vector<std::pair<std::string, std::vector<int>>> families;
    for (int band = 1; band <= dataset.GetRasterCount(); ++band) {
        const std::string family = family_of(*dataset.GetRasterBand(band));
        const auto known = std::find_if(families.begin(), families.end(), [&](const auto& f) { return f.first == family; });
        if (family.empty() || known == families.end())
            families.push_back({family, {band}});
        else
            known->second.push_back(band);
    }
    std::vector<GridVariable> variables;
    for (const auto& [family, bands] : families) {
        const bool is_band = families.size() > 1 && bands.size() == 1;
        const std::string name = is_band || family.empty() ? "band " + std::to_string(bands.front()) : family;
        variables.push_back(variable_of(dataset, file, bands, name));
    }
    return variables;
}

}  // namespace

std::vector<GridVariable> grid_variables(const std::string& file) {
    GDALAllRegister();
    require_regular_file(file);
    const QuietGdal quiet;
    const GdalDataset dataset = open_listed(file);
    if (dataset == nullptr)
        throw UserError(file + ": not a raster that GDAL can read (" + QuietGdal::last_message() +
                        "); give GeoTIFF, netCDF, GRIB or HDF5");
    if (dataset->GetRasterCount() > 0) return variables_of(*dataset, file);
    std::vector<GridVariable> variables;
    const CPLStringList names(dataset->GetMetadata("SUBDATASETS"), FALSE);
    for (int n = 1;; ++n) {
        const char* const name = names.FetchNameValue(CPLSPrintf("SUBDATASET_%d_NAME", n));
        if (name == nullptr) break;
        const GdalDataset part = open_listed(name);
        if (part == nullptr || part->GetRasterCount() == 0) continue;
        std::vector<int> bands(static_cast<std::size_t>(part->GetRasterCount()));
        for (std::size_t k = 0; k < bands.size(); ++k) bands[k] = static_cast<int>(k) + 1;
        const std::string whole(name);
        variables.push_back(variable_of(*part, file, bands, whole.substr(whole.find_last_of(':') + 1)));
    }
    return variables;
}

}  // namespace tedavis::host_sim
