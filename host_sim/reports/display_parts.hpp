/// The parts of the display with their names, contents, and positions in a picture of example_approach.
///
/// The table is written into render_core/draw/symbology/README.md; a test compares both.
#pragma once

#include <string_view>

#include "render_core/base/span.hpp"
#include "render_core/draw/symbology/layout.hpp"
#include "render_core/draw/symbology/symbology_input.hpp"

namespace tedavis::host_sim {

/// What a picture was drawn from.
struct DrawnSymbology {
    const draw::SymbologyInput& input;
    const draw::Layout& layout;
};

struct DisplayPart {
    std::string_view name;                        ///< in the picture
    std::string_view shows;                       ///< one or two sentences
    draw::Point (*place)(const DrawnSymbology&);  ///< a point of the part; pixels from the top left corner
};
/// From the top down, left to right.
[[nodiscard]] base::Span<const DisplayPart> display_parts();

}  // namespace tedavis::host_sim
