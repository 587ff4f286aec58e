/// A netCDF file of one variable "u" over 4 x 3 posts, as weather services hand forecasts and analyses over.
#pragma once

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tedavis::test_support {

struct NetcdfFile {
    std::vector<double> times_h;        ///< since 1970; empty: no axis of times
    std::vector<double> steps_h;        ///< how far ahead; empty: no such axis
    std::optional<double> reference_h;  ///< a variable forecast_reference_time of one number
    std::string meaning_of_times;       ///< the standard name of the axis of times; empty: none

    void write(const std::string& path) const {
        GDALAllRegister();
        GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("netCDF");
        ASSERT_NE(driver, nullptr);
        const std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> file(
            driver->CreateMultiDimensional(path.c_str(), nullptr, nullptr));
        ASSERT_NE(file, nullptr);
        const std::shared_ptr<GDALGroup> root = file->GetRootGroup();
        Dimensions of_u;
        if (!times_h.empty()) of_u.push_back(axis(*root, "time", times_h, "hours since 1970-01-01", meaning_of_times));
        if (!steps_h.empty()) of_u.push_back(axis(*root, "step", steps_h, "hours", "forecast_period"));
        of_u.push_back(axis(*root, "latitude", {47, 46.5, 46}, "degrees_north", "latitude"));
        of_u.push_back(axis(*root, "longitude", {9, 9.5, 10, 10.5}, "degrees_east", "longitude"));
        if (reference_h)
            fill(*root->CreateMDArray("forecast_reference_time", {}, number()), {*reference_h}, "hours since 1970-01-01", "");
        std::size_t count = 1;
        for (const std::shared_ptr<GDALDimension>& dimension : of_u) count *= static_cast<std::size_t>(dimension->GetSize());
        std::vector<double> values(count);
        for (std::size_t n = 0; n < count; ++n) values[n] = static_cast<double>(n);
        fill(*root->CreateMDArray("u", of_u, number()), values, "m s**-1", "eastward_wind");
    }

private:
    using Dimensions = std::vector<std::shared_ptr<GDALDimension>>;
    static GDALExtendedDataType number() { return GDALExtendedDataType::Create(GDT_Float64); }
    static std::shared_ptr<GDALDimension> axis(GDALGroup& root, const std::string& name, const std::vector<double>& values,
                                               const std::string& unit, const std::string& meaning) {
        std::shared_ptr<GDALDimension> dimension = root.CreateDimension(name, "", "", values.size());
        fill(*root.CreateMDArray(name, {dimension}, number()), values, unit, meaning);
        return dimension;
    }
    static void fill(GDALMDArray& array, const std::vector<double>& values, const std::string& unit, const std::string& meaning) {
        const auto say = [&array](const char* key, const std::string& text) {
            EXPECT_TRUE(array.CreateAttribute(key, {}, GDALExtendedDataType::CreateString())->Write(text.c_str()));
        };
        say("units", unit);
        if (!meaning.empty()) say("standard_name", meaning);
        const std::vector<GUInt64> first(array.GetDimensionCount(), 0);
        std::vector<std::size_t> count;
        for (const std::shared_ptr<GDALDimension>& dimension : array.GetDimensions())
            count.push_back(static_cast<std::size_t>(dimension->GetSize()));
        EXPECT_TRUE(array.Write(first.data(), count.data(), nullptr, nullptr, number(), values.data()));
    }
};

}  // namespace tedavis::test_support
