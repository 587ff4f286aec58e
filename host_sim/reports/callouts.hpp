/// A picture whose parts are named in margins to both sides: each name has a thin line to the place that it names.
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

/// Where a name stands in the larger picture, and the line to its place.
struct PlacedCallout {
    draw::Point text;  ///< left end of the baseline
    draw::Point from, to;
    bool is_left = false;
};
struct CalloutLayout {
    std::uint32_t margin_px = 0;  ///< to either side
    float text_px = 0;
    std::vector<PlacedCallout> placed;  ///< as the callouts are given
};

/// The left half of the places has its names to the left. On each side the names are in the order of the places' heights, so that
/// few lines cross, and never overlap.
[[nodiscard]] CalloutLayout lay_out_callouts(const std::vector<Callout>& callouts, std::uint32_t width, std::uint32_t height);

/// The picture between white margins, as high as it is.
[[nodiscard]] RgbaPicture draw_callouts(const RgbaPicture& picture, const std::vector<Callout>& callouts);

}  // namespace tedavis::host_sim
