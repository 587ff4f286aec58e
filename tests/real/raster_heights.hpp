/// Heights of a raster as GDAL reads them, without the product.
#pragma once

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace tedavis::test_support {

/// Heights of the raster, by the two triangles of a cell.
class RasterHeights {
public:
    explicit RasterHeights(const std::string& path) {
        GDALAllRegister();
        auto* const file = GDALDataset::Open(path.c_str());
        file->GetGeoTransform(transform_);
        columns_ = file->GetRasterXSize(), rows_ = file->GetRasterYSize();
        heights_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
        EXPECT_EQ(
            file->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, columns_, rows_, heights_.data(), columns_, rows_, GDT_Float32, 0, 0),
            CE_None);
        GDALClose(file);
    }
    [[nodiscard]] double at(double lat_deg, double lon_deg) const {
        const double x = (lon_deg - transform_[0]) / transform_[1] - 0.5, y = (lat_deg - transform_[3]) / transform_[5] - 0.5;
        if (!(x >= 0 && y >= 0 && x < columns_ - 1 && y < rows_ - 1)) return std::nan("");
        const auto i = static_cast<int>(x), j = static_cast<int>(y);
        const double u = x - i, v = y - j, nw = post(i, j), ne = post(i + 1, j), sw = post(i, j + 1), se = post(i + 1, j + 1);
        return u + v < 1 ? nw + u * (ne - nw) + v * (sw - nw) : se + (1 - u) * (sw - se) + (1 - v) * (ne - se);
    }

private:
    [[nodiscard]] double post(int i, int j) const {
        return static_cast<double>(
            heights_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i)]);
    }
    double transform_[6] = {};
    int columns_ = 0, rows_ = 0;
    std::vector<float> heights_;
};

}  // namespace tedavis::test_support
