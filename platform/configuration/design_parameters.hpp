/// What a configuration puts above its designs, table [parameters]: on the desk and on the board alike.
#pragma once

#include <optional>
#include <string_view>
#include <type_traits>

#include "render_core/base/error.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/design/design_settings.hpp"
#include "render_core/scene/focus_region.hpp"

namespace tedavis::platform {

struct AspectWeight {
    base::FixedString<63> aspect;
    double weight = 0;  ///< 0..1
};

/// What is wrong with more foci than a display has room for.
inline constexpr const char* kTooManyFoci = "a display has room for 4 foci, the design's among them; leave one out";
static_assert(scene::kMaxFoci == 4, "as kTooManyFoci says");

struct DesignParameters {
    std::optional<double> tau_px;                                      ///< terrain error in pixels; nothing: the design's
    base::FixedVector<AspectWeight, design::kMaxAspects> weights;      ///< those without one keep the design's
    base::FixedVector<base::FixedString<1000>, scene::kMaxFoci> foci;  ///< that come before the design's (design::read_focus)
};
static_assert(std::is_trivially_copyable_v<DesignParameters>);

/// Puts the parameters above a design. The error says what does not fit; `design_name` is the design's name in it.
[[nodiscard]] base::Error put_parameters(const DesignParameters& parameters, std::string_view design_name,
                                         design::DesignSettings& design);

}  // namespace tedavis::platform
