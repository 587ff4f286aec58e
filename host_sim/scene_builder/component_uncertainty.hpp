/// The uncertainty of a vector's length, or of a component, from the levels of its two components, whose scales may differ.
#pragma once

#include "render_core/scene/uncertainty.hpp"

namespace tedavis::host_sim {

/// Kind and scale of an attribute's uncertainties (scene/sdb_format.hpp).
struct UncertaintyScale {
    scene::UncertaintyKind kind = scene::UncertaintyKind::none;
    double full = 0, growth_per_hour = 0;
};

/// Percents and classes are not scaled with the values.
[[nodiscard]] constexpr bool is_in_unit_of_values(scene::UncertaintyKind kind) {
    return kind == scene::UncertaintyKind::standard_deviation || kind == scene::UncertaintyKind::interval;
}

/// Returns a scale on which neither becomes more certain: the finer of both, with the faster growth. For two different kinds it
/// has kind none.
[[nodiscard]] UncertaintyScale shared_scale(const UncertaintyScale& a, const UncertaintyScale& b);

/// Returns the greater of two uncertainties, each on its own scale, as a level on `shared`. Unknown where one of them is, and
/// where `shared` has kind none.
[[nodiscard]] scene::Uncertainty worse_on(const UncertaintyScale& shared, scene::Uncertainty a, const UncertaintyScale& of_a,
                                          scene::Uncertainty b, const UncertaintyScale& of_b);

}  // namespace tedavis::host_sim
