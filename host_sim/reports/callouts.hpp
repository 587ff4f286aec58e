/// Adds margins to a picture in which its parts are named, each with a thin line from the name to the part.
#pragma once

#include <string>
#include <vector>

#include "host_sim/png_file.hpp"
#include "render_core/draw/rect.hpp"

namespace tedavis::host_sim {

struct Callout {
    std::string name;
    draw::Point at;  ///< in the picture, pixels from the top left corner
};

/// The position of a name in the picture with margins, and the line to its part; pixels from the top left corner.
struct PlacedCallout {
    draw::Point text;  ///< left end of the baseline
    draw::Point from, to;
    bool is_left = false;
};
struct CalloutLayout {
    std::uint32_t margin_px = 0;  ///< width of each margin
    float text_px = 0;
    std::vector<PlacedCallout> placed;  ///< in the order of the callouts
};

/// The leftmost half of the parts get their names in the left margin. In each margin the names are in the vertical order of the
/// parts, so that few lines cross, and they never overlap.
[[nodiscard]] CalloutLayout lay_out_callouts(const std::vector<Callout>& callouts, std::uint32_t width, std::uint32_t height);

/// Returns the picture between white margins of its height.
[[nodiscard]] RgbaPicture draw_callouts(const RgbaPicture& picture, const std::vector<Callout>& callouts);

}  // namespace tedavis::host_sim
