#include "host_sim/terrain_builder/impossible_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/quiet_gdal.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr int kMaxSamples = 64;  // a side

struct ValueSample {
    std::vector<double> values;
    std::vector<std::uint8_t> is_declared;  ///< 0 where the file marks a void
};

/// GDAL takes the nearest post of each place.
ValueSample sample_of(const RasterSource& source) {
    const QuietGdal quiet;
    GDALRasterBand& band = *source.dataset->GetRasterBand(1);
    const int columns = std::min(source.columns, kMaxSamples), rows = std::min(source.rows, kMaxSamples);
    ValueSample sample;
    sample.values.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    sample.is_declared.resize(sample.values.size());
    const bool is_read = band.RasterIO(GF_Read, 0, 0, source.columns, source.rows, sample.values.data(), columns, rows,
                                       GDT_Float64, 0, 0) == CE_None &&
                         band.GetMaskBand()->RasterIO(GF_Read, 0, 0, source.columns, source.rows, sample.is_declared.data(),
                                                      columns, rows, GDT_Byte, 0, 0) == CE_None;
    if (!is_read)
        throw UserError(source.file + ": the raster ends early or is damaged (" + QuietGdal::last_message() +
                        "); get a whole copy");
    return sample;
}

}  // namespace

ImpossibleValues impossible_values(const RasterSource& source, const RasterOptions& options) {
    if (source.encoding) return {};
    const ValueSample sample = sample_of(source);
    ImpossibleValues found{0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    double count = 0;
    for (std::size_t n = 0; n < sample.values.size(); ++n) {
        const double raw = sample.values[n], height_m = raw * source.metres_per_count + source.offset_m;
        const bool is_void = sample.is_declared[n] == 0 || std::isnan(raw) || (options.void_value && raw == *options.void_value);
        if (is_void || (height_m >= kLowestHeight_m && height_m <= kHighestHeight_m)) continue;
        ++count;
        found.lowest_m = std::min(found.lowest_m, height_m);
        found.highest_m = std::max(found.highest_m, height_m);
    }
    if (count == 0) return {};
    found.share = count / static_cast<double>(sample.values.size());
    return found;
}

}  // namespace tedavis::host_sim
