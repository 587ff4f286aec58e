#include "host_sim/scene_builder/grid_times.hpp"

#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "host_sim/calendar_time.hpp"
#include "host_sim/quiet_gdal.hpp"
#include "host_sim/terrain_builder/raster_file.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kNanoseconds = 1e9;
constexpr double kFarthest_s = 7e9;  // from 1970: 1748..2191

struct Step {
    std::string_view name;
    double seconds;
};
constexpr Step kSteps[] = {{"second", 1}, {"minute", 60}, {"hour", 3600}, {"day", 86400}};
constexpr const char* kReferenceTime = "forecast_reference_time";  // the standard name of the CF conventions

/// "hours".
std::optional<double> step_s(std::string_view text) {
    for (const Step& step : kSteps)
        if (text == step.name || text == std::string(step.name) + "s") return step.seconds;
    return std::nullopt;
}

bool is_reference_time(const GDALMDArray& array) {
    if (array.GetName() == kReferenceTime) return true;
    const std::shared_ptr<GDALAttribute> name = array.GetAttribute("standard_name");
    const char* const text = name != nullptr ? name->ReadAsString() : nullptr;
    return text != nullptr && std::string_view(text) == kReferenceTime;
}

/// The one number of an array of times; empty where it has several.
std::optional<std::int64_t> only_instant(const GDALMDArray& array) {
    const std::optional<TimeUnit> unit = parse_time_unit(array.GetUnit());
    if (!unit || array.GetTotalElementsCount() != 1) return std::nullopt;
    const std::vector<GUInt64> first(array.GetDimensionCount(), 0);
    const std::vector<std::size_t> count(array.GetDimensionCount(), 1);
    double steps = 0;
    if (!array.Read(first.data(), count.data(), nullptr, nullptr, GDALExtendedDataType::Create(GDT_Float64), &steps))
        return std::nullopt;
    return unit->at(steps);
}

/// Of a netCDF file whose forecasts were all computed at once. Readers of rasters do not tell of such a variable.
std::optional<std::int64_t> reference_time_of(const std::string& file) {
    const QuietGdal quiet;
    const GdalDataset dataset(GDALDataset::Open(file.c_str(), GDAL_OF_MULTIDIM_RASTER | GDAL_OF_READONLY));
    const std::shared_ptr<GDALGroup> root = dataset != nullptr ? dataset->GetRootGroup() : nullptr;
    if (root == nullptr) return std::nullopt;
    const char* const with_single_numbers[] = {"SHOW_ZERO_DIM=YES", nullptr};
    for (const std::string& name : root->GetMDArrayNames(with_single_numbers))
        if (const std::shared_ptr<GDALMDArray> array = root->OpenMDArray(name); array != nullptr && is_reference_time(*array))
            return only_instant(*array);
    return std::nullopt;
}

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
    const std::optional<double> step = step_s(text.substr(0, since));
    const std::optional<std::int64_t> origin = parse_origin(text.substr(since + 7));
    return step && origin ? std::optional(TimeUnit{*step, *origin}) : std::nullopt;
}

GridTimes::GridTimes(GDALDataset& dataset, const std::string& file) : dataset_(dataset) {
    const GDALDriver* const driver = dataset.GetDriver();
    if (driver != nullptr && std::string_view(driver->GetDescription()) == "netCDF") reference_ns_ = reference_time_of(file);
    const char* const meaning = dataset.GetMetadataItem("time#standard_name");
    times_are_references_ = meaning != nullptr && std::string_view(meaning) == kReferenceTime;
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

std::optional<std::int64_t> GridTimes::axis_time_of(GDALRasterBand& band) const {
    for (const char* const key : {"NETCDF_DIM_valid_time", "NETCDF_DIM_time"})
        if (const char* const steps = band.GetMetadataItem(key); steps != nullptr && unit_) return unit_->at(CPLAtof(steps));
    return std::nullopt;
}

std::optional<std::int64_t> GridTimes::lead_of(GDALRasterBand& band) const {
    for (const char* const key : {"step", "forecast_period", "leadtime", "lead_time"}) {
        const char* const steps = band.GetMetadataItem((std::string("NETCDF_DIM_") + key).c_str());
        const char* const unit = dataset_.GetMetadataItem((std::string(key) + "#units").c_str());
        const std::optional<double> step = unit != nullptr ? step_s(unit) : std::nullopt;
        if (steps != nullptr && step) return TimeUnit{*step, 0}.at(CPLAtof(steps));
    }
    return std::nullopt;
}

std::optional<std::int64_t> GridTimes::of(GDALRasterBand& band) const {
    const std::optional<std::int64_t> axis = axis_time_of(band), reference = reference_of(band), lead = lead_of(band);
    if (axis && !times_are_references_) return axis;
    if (reference && lead) return *reference + *lead;
    if (axis) return axis;
    if (const char* const seconds = band.GetMetadataItem("GRIB_VALID_TIME")) return TimeUnit{}.at(CPLAtof(seconds));
    return all_ns_;
}

std::optional<std::int64_t> GridTimes::reference_of(GDALRasterBand& band) const {
    if (times_are_references_)
        if (const std::optional<std::int64_t> axis = axis_time_of(band)) return axis;
    if (const char* const seconds = band.GetMetadataItem("GRIB_REF_TIME")) return TimeUnit{}.at(CPLAtof(seconds));
    return reference_ns_;
}

}  // namespace tedavis::host_sim
