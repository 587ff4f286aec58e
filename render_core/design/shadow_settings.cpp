#include "render_core/design/shadow_settings.hpp"

#include <array>

#include "render_core/design/config_values.hpp"

namespace tedavis::design {
namespace {

constexpr auto kCasterRoles = static_cast<std::size_t>(scene::LayerRole::count);

void read_casters(base::ConfigSection& section, CasterRoles& casters) {
    if (!section.has("casters")) return;
    std::array<std::string_view, kCasterRoles> names;
    const std::size_t count = section.texts("casters", names);
    casters = {};
    for (std::size_t n = 0; n < count; ++n) {
        std::size_t role = 0;
        while (role < kCasterRoles && scene::kLayerRoleNames[role] != names[n]) ++role;
        if (role == kCasterRoles) return fault_of(section, "casters", "names something that is no role of a layer");
        casters.add(static_cast<scene::LayerRole>(role));
    }
    if (count == 0) fault_of(section, "casters", "is empty; leave out the table for no shadows");
}

}  // namespace

void read_shadows(base::ConfigSection section, ShadowSettings& shadows) {
    if (!section.present()) return;
    shadows.on_ground = section.number("on_ground", 0, 1, 0);
    shadows.in_air = section.number("in_air", 0, 1, 0);
    shadows.steps = static_cast<std::uint32_t>(section.integer("steps", 8, 64, 24));
    read_casters(section, shadows.casters);
}

}  // namespace tedavis::design
