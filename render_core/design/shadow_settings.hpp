/// Shadows that data above the ground cast on the ground and into the air: table [effects.shadows] of a design file.
///
///     [effects.shadows]
///     on_ground = 0.6       # what a whole shadow takes of the first light; 0, or absent: no soft shadows
///     in_air = 0.6          # part of the light of the air before the eye that they take; 0: no volumetric light
///     steps = 24            # places at which a view ray is looked at, 8 to 64
///     casters = ["trajectory", "obstacle"]   # roles of the layers that cast them; absent: what is a thing in the air or on it
///
/// Plain data. Reading: start-up only, faults go to the section.
#pragma once

#include <cstdint>

#include "render_core/base/config_reader.hpp"
#include "render_core/scene/sdb_format.hpp"

namespace tedavis::design {

/// One bit per role.
class CasterRoles {
public:
    constexpr CasterRoles& add(scene::LayerRole role) {
        bits_ |= 1u << static_cast<unsigned>(role);
        return *this;
    }
    [[nodiscard]] constexpr bool has(scene::LayerRole role) const { return (bits_ >> static_cast<unsigned>(role) & 1u) != 0; }

private:
    std::uint32_t bits_ = 0;
};

/// The default casters. Airspaces are not objects, and fields have signs wherever there is room: they cast shadows only where a
/// design names them.
inline constexpr CasterRoles kThings = CasterRoles()
                                           .add(scene::LayerRole::trajectory)
                                           .add(scene::LayerRole::traffic)
                                           .add(scene::LayerRole::obstacle)
                                           .add(scene::LayerRole::storm_cell)
                                           .add(scene::LayerRole::building)
                                           .add(scene::LayerRole::model);

struct ShadowSettings {
    double on_ground = 0;  ///< 0..1
    double in_air = 0;     ///< 0..1
    std::uint32_t steps = 24;
    CasterRoles casters = kThings;

    [[nodiscard]] bool is_any() const { return on_ground > 0 || in_air > 0; }
};

void read_shadows(base::ConfigSection section, ShadowSettings& shadows);

}  // namespace tedavis::design
