#include "host_sim/reports/shaded_relief.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render_core/base/check.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/terrain/height_query.hpp"

namespace tedavis::host_sim {
namespace {

using Rgb = std::array<double, 3>;
constexpr Rgb kValley{182, 200, 160}, kSlope{226, 214, 178}, kSummit{246, 244, 240}, kSea{150, 186, 214}, kUnknown{206, 206, 206};

Rgb between(const Rgb& from, const Rgb& to, double share) {
    Rgb mixed{};
    for (std::size_t c = 0; c < mixed.size(); ++c) mixed[c] = from[c] + (to[c] - from[c]) * share;
    return mixed;
}

Rgb tint(double share) { return share < 0.5 ? between(kValley, kSlope, 2 * share) : between(kSlope, kSummit, 2 * share - 1); }

/// Heights at the middles of pixels; NaN where none is known, and the lowest and highest of land.
struct HeightField {
    std::uint32_t width, height;
    std::vector<double> heights_m;
    std::vector<bool> is_sea;
    double low_m = std::numeric_limits<double>::infinity(), high_m = -std::numeric_limits<double>::infinity();

    [[nodiscard]] double at(std::int64_t column, std::int64_t row) const {
        const auto c = static_cast<std::size_t>(std::clamp<std::int64_t>(column, 0, std::int64_t{width} - 1));
        const auto r = static_cast<std::size_t>(std::clamp<std::int64_t>(row, 0, std::int64_t{height} - 1));
        return heights_m[r * width + c];
    }
};

void take(HeightField& field, std::size_t place, const terrain::HeightAnswer& answer) {
    field.is_sea[place] = answer.status == terrain::HeightStatus::sea;
    if (answer.status != terrain::HeightStatus::land && !field.is_sea[place]) return;
    field.heights_m[place] = answer.height.m;
    if (field.is_sea[place]) return;
    field.low_m = std::min(field.low_m, answer.height.m);
    field.high_m = std::max(field.high_m, answer.height.m);
}

/// In strips of some columns, since a query keeps few chunks.
HeightField heights_of(const terrain::TerrainDatabase& database, const GeoExtent& extent, std::uint32_t width,
                       std::uint32_t height) {
    constexpr std::uint32_t kStrip = 32;
    std::vector<std::uint8_t> memory(terrain::HeightQuery::bytes_needed());
    base::Arena arena(memory.data(), memory.size());
    terrain::HeightQuery query;
    TEDAVIS_CHECK(query.start(database, arena));
    HeightField field{width, height, std::vector<double>(std::size_t{width} * height, std::nan("")),
                      std::vector<bool>(std::size_t{width} * height)};
    const double column_deg = (extent.east_deg - extent.west_deg) / width,
                 row_deg = (extent.north_deg - extent.south_deg) / height;
    for (std::uint32_t first = 0; first < width; first += kStrip)
        for (std::uint32_t row = 0; row < height; ++row)
            for (std::uint32_t column = first; column < std::min(first + kStrip, width); ++column)
                take(field, std::size_t{row} * width + column,
                     query.at(base::radians(extent.north_deg - (row + 0.5) * row_deg),
                              earth::wrap_longitude(base::radians(extent.west_deg + (column + 0.5) * column_deg))));
    return field;
}

/// 0.35 .. 1 by the angle between the ground and a light from the north-west, 45 degrees high; 1 where a neighbour is unknown.
double light_on(const HeightField& field, std::int64_t column, std::int64_t row, double column_m, double row_m) {
    constexpr double kExaggeration = 1.5, kAmbient = 0.35;
    const double east = kExaggeration * (field.at(column + 1, row) - field.at(column - 1, row)) / (2 * column_m);
    const double south = kExaggeration * (field.at(column, row + 1) - field.at(column, row - 1)) / (2 * row_m);
    if (!std::isfinite(east) || !std::isfinite(south)) return 1;
    const double facing = (0.5 * east + 0.5 * south + std::sqrt(0.5)) / std::sqrt(1 + east * east + south * south);
    return kAmbient + (1 - kAmbient) * std::clamp(facing / std::sqrt(0.5), 0.0, 1.0);
}

}  // namespace

RgbaPicture shaded_relief(const terrain::TerrainDatabase& database, const GeoExtent& extent, std::uint32_t width,
                          std::uint32_t height) {
    const HeightField field = heights_of(database, extent, width, height);
    const double degree_m = base::radians(1) * earth::kMeanRadius_m;
    const double row_m = (extent.north_deg - extent.south_deg) * degree_m / height;
    const double column_m = (extent.east_deg - extent.west_deg) * degree_m *
                            std::max(std::cos(base::radians(0.5 * (extent.north_deg + extent.south_deg))), 0.01) / width;
    RgbaPicture picture{width, height, std::vector<std::uint8_t>(std::size_t{width} * height * 4, 255)};
    for (std::size_t place = 0; place < field.heights_m.size(); ++place) {
        const bool is_known = std::isfinite(field.heights_m[place]);
        Rgb color = is_known ? kSea : kUnknown;
        if (is_known && !field.is_sea[place]) {
            const double share = (field.heights_m[place] - field.low_m) / std::max(field.high_m - field.low_m, 1.0);
            const double light = light_on(field, static_cast<std::int64_t>(place % width),
                                          static_cast<std::int64_t>(place / width), column_m, row_m);
            color = between({0, 0, 0}, tint(share), light);
        }
        for (std::size_t c = 0; c < color.size(); ++c)
            picture.pixels[4 * place + c] = static_cast<std::uint8_t>(std::lround(color[c]));
    }
    return picture;
}

}  // namespace tedavis::host_sim
