/// The pictures of a sheet on one picture: a heading, then a labelled grid for each group, black on white.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/reports/drawn_sheet.hpp"

namespace tedavis::host_sim {

/// Pixels from the top left corner.
struct SheetBox {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

/// The positions of all parts; text sizes and gaps are proportional to the pictures' width.
struct ContactSheetLayout {
    std::uint32_t width = 0, height = 0;
    SheetBox title;
    struct Group {
        SheetBox title;
        std::vector<SheetBox> pictures;
        std::vector<SheetBox> labels;  ///< below each picture, as wide as it
    };
    std::vector<Group> groups;
};

/// All pictures of a sheet have the same size; a sheet has at least one.
[[nodiscard]] ContactSheetLayout lay_out_contact_sheet(const DrawnSheet& sheet);
/// Labels hold the title and, smaller, the caption or else the design's name.
[[nodiscard]] RgbaPicture draw_contact_sheet(const DrawnSheet& sheet);

}  // namespace tedavis::host_sim
