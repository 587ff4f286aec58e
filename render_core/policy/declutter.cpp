#include "render_core/policy/declutter.hpp"

namespace tedavis::policy {

const scene::DetailRegions* Declutter::regions_of(const design::DataElement& element, scene::LayerRole role,
                                                  bool warns) const noexcept {
    const bool says_uncertainty = element.technique == design::DataTechnique::uncertainty_only;
    const bool may_declutter = says_uncertainty ? lowers_uncertainty : (roles >> static_cast<unsigned>(role) & 1u) != 0;
    return may_declutter && !warns ? &regions : nullptr;
}

Declutter declutter_of(const scene::DetailRegions& regions, const design::PrioritySettings& priority,
                       const design::AspectWeights& weights) noexcept {
    Declutter declutter;
    declutter.regions = regions;
    if (declutter.regions.is_whole()) return declutter;
    for (std::size_t n = 0; n < static_cast<std::size_t>(scene::LayerRole::count); ++n)
        if (!priority.is_first(priority.aspect_of(static_cast<scene::LayerRole>(n)), weights)) declutter.roles |= 1u << n;
    declutter.lowers_uncertainty = !priority.is_first(design::kUncertaintyAspect, weights);
    return declutter;
}

}  // namespace tedavis::policy
