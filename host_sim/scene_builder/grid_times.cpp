#include "host_sim/scene_builder/grid_times.hpp"

#include <cmath>
#include <string>

#include "host_sim/importers/calendar_time.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kNanoseconds = 1e9;
constexpr double kFarthest_s = 7e9;  // from 1970: 1748..2191

struct Step {
    std::string_view name;
    double seconds;
};
constexpr Step kSteps[] = {{"second", 1}, {"minute", 60}, {"hour", 3600}, {"day", 86400}};

/// "1900-01-01 00:00:00.0", "1970-1-1", "2000-01-01T00:00:00Z".
std::optional<std::int64_t> parse_origin(std::string_view text) {
    int year = 0, month = 0, day = 0, hour = 0, minute = 0;
    double second = 0;
    const std::string line(text);
    char between = 0;
    const int read = std::sscanf(line.c_str(), "%d-%d-%d%c%d:%d:%lf", &year, &month, &day, &between, &hour, &minute, &second);
    if (read != 3 && read < 6) return std::nullopt;
    const std::optional<base::Time> midnight = midnight_of(year, month, day);
    if (!midnight) return std::nullopt;
    return midnight->ns + std::llround((hour * 3600.0 + minute * 60.0 + second) * kNanoseconds);
}

}  // namespace

std::optional<std::int64_t> TimeUnit::at(double steps) const {
    const double seconds = steps * step_s;
    if (!(std::abs(seconds) <= kFarthest_s)) return std::nullopt;
    // Whole seconds apart, so that hours since 1900 stay exact.
    const double whole = std::floor(seconds);
    return origin_ns + static_cast<std::int64_t>(whole) * 1'000'000'000 + std::llround((seconds - whole) * kNanoseconds);
}

std::optional<TimeUnit> parse_time_unit(std::string_view text) {
    const std::size_t since = text.find(" since ");
    if (since == std::string_view::npos) return std::nullopt;
    const std::string_view name = text.substr(0, since);
    for (const Step& step : kSteps) {
        if (name != step.name && name != std::string(step.name) + "s") continue;
        const std::optional<std::int64_t> origin = parse_origin(text.substr(since + 7));
        return origin ? std::optional(TimeUnit{step.seconds, *origin}) : std::nullopt;
    }
    return std::nullopt;
}

GridTimes::GridTimes(GDALDataset& dataset) {
    for (const char* const key : {"time#units", "valid_time#units"})
        if (const char* const text = dataset.GetMetadataItem(key); text != nullptr && !unit_) unit_ = parse_time_unit(text);
    // ODIM_H5 (EUMETNET OPERA data model), as GDAL flattens it.
    const char* const date = dataset.GetMetadataItem("what_date");
    const char* const time = dataset.GetMetadataItem("what_time");
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0;
    if (date == nullptr || time == nullptr || std::sscanf(date, "%4d%2d%2d", &year, &month, &day) != 3 ||
        std::sscanf(time, "%2d%2d%2d", &hour, &minute, &second) != 3)
        return;
    if (const std::optional<base::Time> midnight = midnight_of(year, month, day))
        all_ns_ = midnight->ns + ((hour * 60 + minute) * 60 + second) * std::int64_t{1'000'000'000};
}

std::optional<std::int64_t> GridTimes::of(GDALRasterBand& band) const {
    for (const char* const key : {"NETCDF_DIM_time", "NETCDF_DIM_valid_time"})
        if (const char* const steps = band.GetMetadataItem(key); steps != nullptr && unit_) return unit_->at(CPLAtof(steps));
    if (const char* const seconds = band.GetMetadataItem("GRIB_VALID_TIME")) return TimeUnit{}.at(CPLAtof(seconds));
    return all_ns_;
}

}  // namespace tedavis::host_sim
