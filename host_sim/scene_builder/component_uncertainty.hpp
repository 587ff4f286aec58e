/// The uncertainty of a vector's length, or of a component, from the levels of its two components, whose scales may differ.
#pragma once

#include "render_core/scene/uncertainty.hpp"

namespace tedavis::host_sim {

/// What an attribute says of its uncertainties (scene/sdb_format.hpp).
struct UncertaintyScale {
    scene::UncertaintyKind kind = scene::UncertaintyKind::none;
    double full = 0, growth_per_hour = 0;
};

/// Percents and classes are not scaled with the values.
[[nodiscard]] constexpr bool is_in_unit_of_values(scene::UncertaintyKind kind) {
    return kind == scene::UncertaintyKind::standard_deviation || kind == scene::UncertaintyKind::interval;
}

/// One on which neither is more certain than it was: the finer one, growing as the faster. Of two kinds there is none: nobody
/// knows.
[[nodiscard]] UncertaintyScale shared_scale(const UncertaintyScale& a, const UncertaintyScale& b);

/// The level of the less sure of two, each on its own scale, on `shared`. Unknown where one of them is, and where there is no
/// kind.
[[nodiscard]] scene::Uncertainty worse_on(const UncertaintyScale& shared, scene::Uncertainty a, const UncertaintyScale& of_a,
                                          scene::Uncertainty b, const UncertaintyScale& of_b);

}  // namespace tedavis::host_sim
