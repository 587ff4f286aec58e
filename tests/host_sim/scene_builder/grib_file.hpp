/// GRIB files of several variables, levels and times, as weather services hand them over.
#pragma once

#include <cpl_string.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/files/raster_file.hpp"

namespace tedavis::test_support {

/// A grid of GRIB 2 (template 4.0 of its product definition): WMO Manual on Codes, code tables 4.1, 4.2 and 4.5.
struct GribGrid {
    int category = 2, number = 2;  ///< of meteorology: 2, 2 is the eastward wind and 2, 3 the northward wind; 2, 22 gusts
    int surface = 100;             ///< 100: isobaric, level in Pa; 1: the ground
    int level = 50000;
    int hours = 0;     ///< of the forecast
    double value = 1;  ///< at every post but the first, which has half of it
};

/// Writes all of them to one file, as archives append messages.
inline void write_grib(const std::string& path, const std::vector<GribGrid>& grids) {
    RasterFile raster;
    raster.columns = 4;
    raster.rows = 3;
    raster.transform = {8.75, 0.5, 0, 47.25, 0, -0.5};
    GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("GRIB");
    std::ofstream whole(path, std::ios::binary);
    for (const GribGrid& grid : grids) {
        raster.value = [&grid](int i, int j) { return i == 0 && j == 0 ? grid.value / 2 : grid.value; };
        const std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> from(
            GDALDataset::Open(raster.write(path + ".tif").c_str()));
        ASSERT_NE(from, nullptr);
        const std::array<int, 15> numbers = {grid.category, grid.number,  2, 0,          0,   0, 0, 1,
                                             grid.hours,    grid.surface, 0, grid.level, 255, 0, 0};
        std::string product;
        for (const int number : numbers) product += (product.empty() ? "" : " ") + std::to_string(number);
        CPLStringList options;
        options.SetNameValue("PDS_PDTN", "0");
        options.SetNameValue("PDS_TEMPLATE_ASSEMBLED_VALUES", product.c_str());
        options.SetNameValue("IDS_REF_TIME", "2026-06-01T12:00:00Z");
        CPLPushErrorHandler(CPLQuietErrorHandler);
        {
            const std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> made(
                driver->CreateCopy((path + ".one").c_str(), from.get(), FALSE, options.List(), nullptr, nullptr));
        }
        CPLPopErrorHandler();
        std::ifstream one(path + ".one", std::ios::binary);
        whole << std::string(std::istreambuf_iterator<char>(one), {});
    }
}

}  // namespace tedavis::test_support
