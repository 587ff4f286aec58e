#include "render_core/scene/area_limits.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "render_core/base/units.hpp"
#include "render_core/scene/feature_values.hpp"

namespace tedavis::scene {
namespace {

/// "msl", "ground", "standard"; empty where the attribute is not there.
std::string_view datum_name(const Layer& layer, std::string_view attribute, std::uint32_t feature) {
    const Attribute* const datum = layer.find(attribute);
    const double code = value_or_nan(layer, attribute, feature);
    return datum == nullptr || !(code >= 0) ? std::string_view() : datum->class_name(static_cast<std::uint32_t>(code));
}

HeightLimit limit_of(const Layer& layer, std::string_view attribute, std::string_view datum, std::uint32_t feature) {
    const std::string_view name = datum_name(layer, datum, feature);
    return {value_or_nan(layer, attribute, feature), name.empty()       ? layer.entry->height_datum
                                                     : name == "ground" ? HeightDatum::ground
                                                                        : HeightDatum::msl};
}

/// A flight level is hundreds of feet, whatever the units are.
void append_limit(const HeightLimit& limit, bool is_standard, base::DisplayUnits units, LimitsText& text) {
    constexpr double kMax = 999'999;
    if (std::isnan(limit.m)) return text.append("?");
    const bool is_ground = limit.datum == HeightDatum::ground;
    if (is_ground && limit.m <= 0) return text.append("GND");
    const base::DisplayUnit unit = base::height_unit(is_standard ? base::DisplayUnits::feet_and_knots : units);
    const auto height = static_cast<int>(std::lround(std::clamp(unit.of(limit.m), -kMax, kMax)));
    const bool is_metric = units == base::DisplayUnits::metric;
    char number[24];
    if (is_standard)
        std::snprintf(number, sizeof number, "FL%03d", (height + 50) / 100);
    else
        std::snprintf(number, sizeof number, "%d%s %s", height, is_metric ? "M" : "", is_ground ? "AGL" : "MSL");
    text.append(number);
}

}  // namespace

AreaLimits area_limits(const Layer& layer, std::uint32_t feature) {
    AreaLimits limits{limit_of(layer, "floor", "floor_datum", feature), limit_of(layer, "ceiling", "ceiling_datum", feature)};
    const double height_m = value_or_nan(layer, "height", feature);
    if (std::isnan(limits.ceiling.m) && !std::isnan(height_m)) limits.ceiling = {height_m, HeightDatum::ground};
    return limits;
}

LimitsText limits_text(const Layer& layer, std::uint32_t feature, base::DisplayUnits units) {
    const AreaLimits limits = area_limits(layer, feature);
    LimitsText text;
    if (std::isnan(limits.floor.m) && std::isnan(limits.ceiling.m)) return text;
    append_limit(limits.floor, datum_name(layer, "floor_datum", feature) == "standard", units, text);
    text.append("-");
    append_limit(limits.ceiling, datum_name(layer, "ceiling_datum", feature) == "standard", units, text);
    return text;
}

}  // namespace tedavis::scene
