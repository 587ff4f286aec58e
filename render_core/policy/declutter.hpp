/// Declutter: which regions of the picture are too cluttered, and which data are reduced there (effects/clutter_budget.hpp):
/// all except those of the aspect that comes first.
///
/// Plain data; pure.
#pragma once

#include "render_core/design/design_settings.hpp"
#include "render_core/effects/clutter_budget.hpp"

namespace tedavis::policy {

struct Declutter {
    scene::DetailRegions regions;
    std::uint32_t roles = 0;          ///< roles of layers that are reduced; one bit for each scene::LayerRole
    bool lowers_uncertainty = false;  ///< glyphs that only show uncertainty are reduced too

    /// Returns the detail that an element of a layer keeps in each region; null: all. `warns` marks layers that warn, which are
    /// never reduced.
    [[nodiscard]] const scene::DetailRegions* regions_of(const design::DataElement& element, scene::LayerRole role,
                                                         bool warns) const noexcept;
};

/// Makes the declutter state. `regions` is the detail that each region keeps; where all are 1, nothing is reduced.
[[nodiscard]] Declutter declutter_of(const scene::DetailRegions& regions, const design::PrioritySettings& priority,
                                     const design::AspectWeights& weights) noexcept;

}  // namespace tedavis::policy
