/// Colour images made from formulas, as somebody else's program would hand them over.
#pragma once

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tedavis::test_support {

using Rgba = std::array<std::uint8_t, 4>;

struct ImageFile {
    int columns = 64, rows = 48, bands = 3;
    std::array<double, 6> transform{9.6, 0.001, 0, 47.1, 0, -0.001};  ///< GDAL's: the corner of the first pixel
    bool placed = true;
    std::string crs = "EPSG:4326";  ///< empty: none is stated
    GDALDataType type = GDT_Byte;
    std::optional<double> no_data;
    std::vector<Rgba> palette;  ///< not empty: one band of entries, by the first colour's value
    std::function<Rgba(int, int)> color = [](int i, int j) {
        return Rgba{static_cast<std::uint8_t>(3 * i), static_cast<std::uint8_t>(5 * j), static_cast<std::uint8_t>(40 + i + j),
                    255};
    };
    std::vector<GDALColorInterp> meanings;  ///< of bands; empty: the driver's

    /// Writes a GeoTIFF and returns the path.
    std::string write(const std::string& path) const {
        GDALAllRegister();
        const std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> file(
            GetGDALDriverManager()->GetDriverByName("GTiff")->Create(path.c_str(), columns, rows, bands, type, nullptr));
        if (file == nullptr) return path;
        std::array<double, 6> place = transform;
        if (placed) file->SetGeoTransform(place.data());
        if (!crs.empty()) {
            OGRSpatialReference reference;
            EXPECT_EQ(reference.SetFromUserInput(crs.c_str()), OGRERR_NONE);
            file->SetSpatialRef(&reference);
        }
        if (!palette.empty()) set_palette(*file->GetRasterBand(1));
        for (int band = 1; band <= bands; ++band) fill(*file->GetRasterBand(band), band);
        return path;
    }

private:
    void set_palette(GDALRasterBand& band) const {
        GDALColorTable table;
        for (std::size_t n = 0; n < palette.size(); ++n) {
            const GDALColorEntry entry{palette[n][0], palette[n][1], palette[n][2], palette[n][3]};
            table.SetColorEntry(static_cast<int>(n), &entry);
        }
        band.SetColorTable(&table);
    }
    void fill(GDALRasterBand& band, int number) const {
        if (no_data) band.SetNoDataValue(*no_data);
        const auto n = static_cast<std::size_t>(number - 1);
        if (n < meanings.size()) band.SetColorInterpretation(meanings[n]);
        // Two bands are grey and alpha.
        const std::size_t channel = bands == 2 && n == 1 ? 3 : n;
        std::vector<std::uint8_t> line(static_cast<std::size_t>(columns));
        for (int j = 0; j < rows; ++j) {
            for (int i = 0; i < columns; ++i) line[static_cast<std::size_t>(i)] = color(i, j)[channel];
            EXPECT_EQ(band.RasterIO(GF_Write, 0, j, columns, 1, line.data(), columns, 1, GDT_Byte, 0, 0), CE_None);
        }
    }
};

/// Colours of smooth waves, different in every channel, of `pixels` a wave.
inline std::function<Rgba(int, int)> wavy(double pixels) {
    return [pixels](int i, int j) {
        const auto wave = [&](double a, double b) {
            return static_cast<std::uint8_t>(std::lround(127.5 + 120 * std::sin((a * i + b * j) * 6.283185307 / pixels)));
        };
        return Rgba{wave(1, 0.3), wave(-0.4, 0.9), wave(0.7, -0.6), 255};
    };
}

}  // namespace tedavis::test_support
