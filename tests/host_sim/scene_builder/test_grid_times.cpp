#include "host_sim/scene_builder/grid_times.hpp"

#include <gtest/gtest.h>

#include <ctime>

#include "tests/support/files/raster_file.hpp"

namespace tedavis::host_sim::test_grid_times {
namespace {

std::int64_t utc_ns(int year, int month, int day, int hour = 0) {
    std::tm tm{};
    tm.tm_year = year - 1900;
    tm.tm_mon = month - 1;
    tm.tm_mday = day;
    tm.tm_hour = hour;
    return std::int64_t{timegm(&tm)} * 1'000'000'000;
}

TEST(GridTimes, UnitsOfTheCfConventions) {
    const auto at = [](const char* text, double steps) {
        const std::optional<TimeUnit> unit = parse_time_unit(text);
        return unit ? unit->at(steps) : std::nullopt;
    };
    EXPECT_EQ(at("hours since 1900-01-01 00:00:00.0", 1051896), utc_ns(2020, 1, 1)) << "the first hour of ERA5's January 2020";
    EXPECT_EQ(at("seconds since 1970-01-01", 86400), utc_ns(1970, 1, 2));
    EXPECT_EQ(at("days since 2000-1-1", 0.5), utc_ns(2000, 1, 1, 12));
    EXPECT_EQ(at("minutes since 2000-02-29T06:00:00Z", 60), utc_ns(2000, 2, 29, 7));
    EXPECT_EQ(at("hour since 1970-01-01 03:00:00", -3), utc_ns(1970, 1, 1));
    EXPECT_EQ(at("seconds since 1970-01-01", 1e18), std::nullopt);
    EXPECT_FALSE(parse_time_unit("fortnights since 1970-01-01"));
    EXPECT_FALSE(parse_time_unit("hours after 1970-01-01"));
    EXPECT_FALSE(parse_time_unit("hours since noon"));
    EXPECT_FALSE(parse_time_unit("hours since 2001-02-29"));
    EXPECT_FALSE(parse_time_unit(""));
}

class Dataset {
public:
    Dataset() {
        GDALAllRegister();
        dataset_.reset(GetGDALDriverManager()->GetDriverByName("MEM")->Create("", 2, 2, 1, GDT_Float32, nullptr));
    }
    GDALDataset& operator*() { return *dataset_; }
    void say(const char* key, const char* value) { dataset_->SetMetadataItem(key, value); }
    GDALRasterBand& band() { return *dataset_->GetRasterBand(1); }

private:
    std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> dataset_;
};

TEST(GridTimes, OfNetcdfGribAndRadarFiles) {
    Dataset netcdf;
    netcdf.say("time#units", "hours since 1970-01-01");
    netcdf.band().SetMetadataItem("NETCDF_DIM_time", "2");
    EXPECT_EQ(GridTimes(*netcdf, "").of(netcdf.band()), utc_ns(1970, 1, 1, 2));
    Dataset grib;
    grib.band().SetMetadataItem("GRIB_VALID_TIME", "1382918400");
    EXPECT_EQ(GridTimes(*grib, "").of(grib.band()), utc_ns(2013, 10, 28));
    Dataset radar;
    radar.say("what_date", "20241126");
    radar.say("what_time", "010000");
    EXPECT_EQ(GridTimes(*radar, "").of(radar.band()), utc_ns(2024, 11, 26, 1));
    Dataset silent;
    EXPECT_EQ(GridTimes(*silent, "").of(silent.band()), std::nullopt);
    silent.say("what_date", "2024");
    silent.say("what_time", "01");
    EXPECT_EQ(GridTimes(*silent, "").of(silent.band()), std::nullopt);
}

TEST(GridTimes, WhenForecastsWereComputed) {
    Dataset grib;
    EXPECT_EQ(GridTimes(*grib, "").reference_of(grib.band()), std::nullopt);
    grib.band().SetMetadataItem("GRIB_REF_TIME", "1382659200");
    EXPECT_EQ(GridTimes(*grib, "").reference_of(grib.band()), utc_ns(2013, 10, 25));
    Dataset steps;
    steps.say("time#units", "hours since 1970-01-01");
    steps.say("step#units", "hours");
    steps.band().SetMetadataItem("NETCDF_DIM_time", "2");
    steps.band().SetMetadataItem("NETCDF_DIM_step", "5");
    EXPECT_EQ(GridTimes(*steps, "").of(steps.band()), utc_ns(1970, 1, 1, 2)) << "control: plain times are those of the data";
    EXPECT_EQ(GridTimes(*steps, "").reference_of(steps.band()), std::nullopt);
    steps.say("time#standard_name", "forecast_reference_time");
    EXPECT_EQ(GridTimes(*steps, "").of(steps.band()), utc_ns(1970, 1, 1, 7));
    EXPECT_EQ(GridTimes(*steps, "").reference_of(steps.band()), utc_ns(1970, 1, 1, 2));
}

}  // namespace
}  // namespace tedavis::host_sim::test_grid_times
