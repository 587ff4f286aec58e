#include "host_sim/scene_builder/component_uncertainty.hpp"

#include <algorithm>

namespace tedavis::host_sim {
namespace {

using scene::Uncertainty;
using scene::UncertaintyKind;

/// A level of 1 means as unsure as its scale says or more, and it stays 1 on a finer one. Classes are levels without a unit.
Uncertainty level_on(const UncertaintyScale& shared, Uncertainty level, const UncertaintyScale& own) {
    if (!level.is_known() || shared.kind == UncertaintyKind::none) return {};
    if (shared.kind == UncertaintyKind::ordinal || !(shared.full > 0)) return level;
    return Uncertainty::from_level(level.level() * own.full / shared.full);
}

}  // namespace

UncertaintyScale shared_scale(const UncertaintyScale& a, const UncertaintyScale& b) {
    if (a.kind != b.kind) return {};
    return {a.kind, std::min(a.full, b.full), std::max(a.growth_per_hour, b.growth_per_hour)};
}

Uncertainty worse_on(const UncertaintyScale& shared, Uncertainty a, const UncertaintyScale& of_a, Uncertainty b,
                     const UncertaintyScale& of_b) {
    return scene::worse(level_on(shared, a, of_a), level_on(shared, b, of_b));
}

}  // namespace tedavis::host_sim
