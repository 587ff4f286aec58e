/// Which features a technique may leave out where it is to convey less than all detail.
///
/// Those whose value is below kMaxLeftOut * (1 - detail) of the layer's largest; what has no value is kept, for nobody knows how
/// important it is. Pure; any thread.
#pragma once

#include "render_core/draw/data/element_input.hpp"

namespace tedavis::draw {

inline constexpr double kMaxLeftOut = 0.8;

[[nodiscard]] bool is_unimportant(const ElementInput& input, std::string_view attribute, std::uint32_t feature);

}  // namespace tedavis::draw
