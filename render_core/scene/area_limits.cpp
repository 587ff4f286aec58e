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

void append_limit(const HeightLimit& limit, bool is_standard, LimitsText& text) {
    constexpr double kMax_ft = 999'999;
    if (std::isnan(limit.m)) return text.append("?");
    const bool is_ground = limit.datum == HeightDatum::ground;
    if (is_ground && limit.m <= 0) return text.append("GND");
    const auto feet = static_cast<int>(std::lround(std::clamp(limit.m / base::kMetresPerFoot, -kMax_ft, kMax_ft)));
    char number[24];
    if (is_standard)
        std::snprintf(number, sizeof number, "FL%03d", (feet + 50) / 100);
    else
        std::snprintf(number, sizeof number, "%d %s", feet, is_ground ? "AGL" : "MSL");
    text.append(number);
}

}  // namespace

AreaLimits area_limits(const Layer& layer, std::uint32_t feature) {
    AreaLimits limits{limit_of(layer, "floor", "floor_datum", feature), limit_of(layer, "ceiling", "ceiling_datum", feature)};
    const double height_m = value_or_nan(layer, "height", feature);
    if (std::isnan(limits.ceiling.m) && !std::isnan(height_m)) limits.ceiling = {height_m, HeightDatum::ground};
    return limits;
}

LimitsText limits_text(const Layer& layer, std::uint32_t feature) {
    const AreaLimits limits = area_limits(layer, feature);
    LimitsText text;
    if (std::isnan(limits.floor.m) && std::isnan(limits.ceiling.m)) return text;
    append_limit(limits.floor, datum_name(layer, "floor_datum", feature) == "standard", text);
    text.append("-");
    append_limit(limits.ceiling, datum_name(layer, "ceiling_datum", feature) == "standard", text);
    return text;
}

}  // namespace tedavis::scene
