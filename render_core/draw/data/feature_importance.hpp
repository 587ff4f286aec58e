/// Which features a technique may leave out at less than full detail.
///
/// Features are left out whose value is below kMaxLeftOut * (1 - detail) of the layer's largest; features without a value are
/// kept, since their importance is unknown. Pure; any thread.
#pragma once

#include "render_core/draw/data/element_input.hpp"

namespace tedavis::draw {

inline constexpr double kMaxLeftOut = 0.8;

[[nodiscard]] bool is_unimportant(const ElementInput& input, std::string_view attribute, std::uint32_t feature);

}  // namespace tedavis::draw
