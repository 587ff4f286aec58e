/// The time of each band of a raster.
#pragma once

#include <gdal_priv.h>

#include <cstdint>
#include <optional>
#include <string_view>

namespace tedavis::host_sim {

/// Steps since an instant, as the CF conventions write them (section 4.4): "hours since 1900-01-01 00:00:00.0".
struct TimeUnit {
    double step_s = 1;
    std::int64_t origin_ns = 0;

    [[nodiscard]] std::optional<std::int64_t> at(double steps) const;
};
/// Empty for another text. Steps of seconds, minutes, hours and days; calendars that are Gregorian.
[[nodiscard]] std::optional<TimeUnit> parse_time_unit(std::string_view text);

class GridTimes {
public:
    explicit GridTimes(GDALDataset& dataset);
    /// Empty where the file does not say.
    [[nodiscard]] std::optional<std::int64_t> of(GDALRasterBand& band) const;

private:
    std::optional<TimeUnit> unit_;
    std::optional<std::int64_t> all_ns_;  ///< of the whole file
};

}  // namespace tedavis::host_sim
