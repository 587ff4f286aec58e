/// Which regions of the picture are too cluttered, and which data give way there (effects/clutter_budget.hpp): all but those of
/// the aspect that comes first.
///
/// Plain data; pure.
#pragma once

#include "render_core/design/design_settings.hpp"
#include "render_core/effects/clutter_budget.hpp"

namespace tedavis::policy {

struct Declutter {
    scene::DetailRegions regions;
    std::uint32_t roles = 0;          ///< of layers that give way; a bit for each scene::LayerRole
    bool lowers_uncertainty = false;  ///< glyphs that say nothing else

    /// What an element of a layer keeps where; null: all. `warns`: draw::is_protected() of the layer, which never gives way.
    [[nodiscard]] const scene::DetailRegions* regions_of(const design::DataElement& element, scene::LayerRole role,
                                                         bool warns) const noexcept;
};

/// `regions`: what each keeps of its detail; where all keep all of it, nothing gives way.
[[nodiscard]] Declutter declutter_of(const scene::DetailRegions& regions, const design::PrioritySettings& priority,
                                     const design::AspectWeights& weights) noexcept;

}  // namespace tedavis::policy
