#include "host_sim/scene_builder/fixed_unit.hpp"

#include <cstdint>
#include <initializer_list>

#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using scene::LayerRole;

constexpr std::uint32_t roles(std::initializer_list<LayerRole> all) {
    std::uint32_t bits = 0;
    for (const LayerRole role : all) bits |= 1U << static_cast<unsigned>(role);
    return bits;
}

constexpr std::uint32_t kAll = ~0U;
constexpr std::uint32_t kAreas =
    roles({LayerRole::no_go, LayerRole::airspace, LayerRole::storm_cell, LayerRole::land_cover, LayerRole::building});
constexpr std::uint32_t kObstacles = roles({LayerRole::obstacle});
constexpr std::uint32_t kStrips = roles({LayerRole::runway, LayerRole::road, LayerRole::river});
constexpr std::uint32_t kModels = roles({LayerRole::model, LayerRole::place, LayerRole::building, LayerRole::obstacle});

struct FixedUnit {
    std::string_view attribute, unit;
    std::uint32_t roles;
};
constexpr FixedUnit kFixed[] = {{"east", "m/s", kAll},
                                {"north", "m/s", kAll},
                                {"position_accuracy", "m", kAll},
                                {"height_accuracy", "m", kAll},
                                {"height", "m", kAreas | kObstacles},
                                {"floor", "m", kAreas},
                                {"ceiling", "m", kAreas},
                                {"speed", "m/s", kAreas},
                                {"toward", "rad", kAreas},
                                {"diameter", "m", kObstacles},
                                {"width", "m", kStrips},
                                {"glide_path", "rad", roles({LayerRole::runway})},
                                {"heading", "rad", kModels}};

struct UnitFactor {
    std::string_view from, to;
    double factor;
};
constexpr UnitFactor kFactors[] = {{"ft", "m", base::kMetresPerFoot},
                                   {"feet", "m", base::kMetresPerFoot},
                                   {"km", "m", 1000},
                                   {"cm", "m", 0.01},
                                   {"NM", "m", base::kMetresPerNauticalMile},
                                   {"nm", "m", base::kMetresPerNauticalMile},
                                   {"kt", "m/s", base::kMpsPerKnot},
                                   {"kn", "m/s", base::kMpsPerKnot},
                                   {"kts", "m/s", base::kMpsPerKnot},
                                   {"km/h", "m/s", 1 / 3.6},
                                   {"ft/min", "m/s", base::kMpsPerFootPerMinute},
                                   {"fpm", "m/s", base::kMpsPerFootPerMinute},
                                   {"deg", "rad", base::kRadiansPerDegree}};

}  // namespace

std::string_view fixed_unit(LayerRole role, std::string_view attribute) {
    for (const FixedUnit& fixed : kFixed)
        if (fixed.attribute == attribute && (fixed.roles & roles({role})) != 0) return fixed.unit;
    return {};
}

std::optional<double> factor_between(std::string_view from, std::string_view to) {
    for (const UnitFactor& known : kFactors)
        if (known.from == from && known.to == to) return known.factor;
    return std::nullopt;
}

}  // namespace tedavis::host_sim
