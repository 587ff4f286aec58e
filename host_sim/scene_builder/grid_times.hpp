/// The time of each band of a raster.
#pragma once

#include <gdal_priv.h>

#include <cstdint>
#include <optional>
#include <string>
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
    /// `file` is what the dataset was opened from; it must outlive this.
    GridTimes(GDALDataset& dataset, const std::string& file);
    /// The time for which the band is valid; nothing where the file does not state it.
    [[nodiscard]] std::optional<std::int64_t> of(GDALRasterBand& band) const;
    /// The time at which it was computed, which GRIB and the CF conventions (forecast_reference_time) state for forecasts and
    /// analyses; nothing where the file does not state it.
    [[nodiscard]] std::optional<std::int64_t> reference_of(GDALRasterBand& band) const;

private:
    [[nodiscard]] std::optional<std::int64_t> axis_time_of(GDALRasterBand& band) const;
    /// The lead time of the band's forecast, ns.
    [[nodiscard]] std::optional<std::int64_t> lead_of(GDALRasterBand& band) const;

    GDALDataset& dataset_;
    std::optional<TimeUnit> unit_;
    std::optional<std::int64_t> all_ns_, reference_ns_;  ///< of the whole file
    bool times_are_references_ = false;                  ///< the time axis has the times at which forecasts were computed
};

}  // namespace tedavis::host_sim
