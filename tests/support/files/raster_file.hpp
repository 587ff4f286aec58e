/// Raster files made from formulas, as somebody else's program would hand them over.
#pragma once

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tedavis::test_support {

struct RasterFile {
    int columns = 20, rows = 15, bands = 1;
    std::array<double, 6> transform{9.6, 0.01, 0, 47.1, 0, -0.01};  ///< GDAL's: the corner of the first pixel, not its centre
    std::string crs = "EPSG:4326";                                  ///< empty: none is stated
    GDALDataType type = GDT_Float32;
    std::optional<double> no_data;
    std::string unit;
    double scale = 1, offset = 0;
    GDALColorInterp meaning = GCI_GrayIndex;
    std::function<double(int, int)> value = [](int i, int j) { return 1000.0 + 7 * i + 3 * j; };  ///< as it is stored
    std::function<double(int)> more = [](int band) { return band == 1 ? 0.0 : 5000.0; };  ///< of a band, where it has a value
    std::function<double(int, int)> second;  ///< of the second band, where it has values of its own
    const char* driver = "GTiff";

    [[nodiscard]] double x(double i, double j) const {
        return transform[0] + (i + 0.5) * transform[1] + (j + 0.5) * transform[2];
    }
    [[nodiscard]] double y(double i, double j) const {
        return transform[3] + (i + 0.5) * transform[4] + (j + 0.5) * transform[5];
    }

    /// Writes it and returns the path.
    std::string write(const std::string& path) const {
        GDALAllRegister();
        GDALDriver* const maker = GetGDALDriverManager()->GetDriverByName(driver);
        std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> file(
            maker->Create(path.c_str(), columns, rows, bands, type, nullptr));
        if (file == nullptr) return path;
        std::array<double, 6> place = transform;
        file->SetGeoTransform(place.data());
        if (!crs.empty()) {
            OGRSpatialReference reference;
            EXPECT_EQ(reference.SetFromUserInput(crs.c_str()), OGRERR_NONE);
            file->SetSpatialRef(&reference);
        }
        for (int band = 1; band <= bands; ++band)
            fill(*file->GetRasterBand(band), band == 2 && second ? second : value, more(band));
        return path;
    }

private:
    using Values = std::function<double(int, int)>;
    [[nodiscard]] double stored(double v, double added) const { return no_data && v == *no_data ? v : v + added; }
    void fill(GDALRasterBand& band, const Values& values, double added) const {
        if (no_data) band.SetNoDataValue(*no_data);
        if (!unit.empty()) band.SetUnitType(unit.c_str());
        if (scale != 1 || offset != 0) {
            band.SetScale(scale);
            band.SetOffset(offset);
        }
        if (meaning != GCI_GrayIndex) band.SetColorInterpretation(meaning);
        std::vector<double> line(static_cast<std::size_t>(columns));
        for (int j = 0; j < rows; ++j) {
            for (int i = 0; i < columns; ++i) line[static_cast<std::size_t>(i)] = stored(values(i, j), added);
            EXPECT_EQ(band.RasterIO(GF_Write, 0, j, columns, 1, line.data(), columns, 1, GDT_Float64, 0, 0), CE_None);
        }
    }
};

/// Gives the file a mask that covers one column of pixels.
inline void mask_out(const std::string& path, int column) {
    const std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> file(GDALDataset::Open(path.c_str(), GDAL_OF_UPDATE));
    ASSERT_NE(file, nullptr);
    ASSERT_EQ(file->CreateMaskBand(GMF_PER_DATASET), CE_None);
    std::vector<unsigned char> line(static_cast<std::size_t>(file->GetRasterXSize()), 255);
    line[static_cast<std::size_t>(column)] = 0;
    for (int row = 0; row < file->GetRasterYSize(); ++row)
        ASSERT_EQ(file->GetRasterBand(1)->GetMaskBand()->RasterIO(GF_Write, 0, row, file->GetRasterXSize(), 1, line.data(),
                                                                  file->GetRasterXSize(), 1, GDT_Byte, 0, 0),
                  CE_None);
}

}  // namespace tedavis::test_support
