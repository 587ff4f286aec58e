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

/// Where everything goes; text sizes and gaps follow the pictures' width.
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

/// Every picture of a sheet has the size of its first one. A sheet holds at least one.
[[nodiscard]] ContactSheetLayout lay_out_contact_sheet(const DrawnSheet& sheet);
/// Labels hold the title and, smaller, the caption or else the design's name.
[[nodiscard]] RgbaPicture draw_contact_sheet(const DrawnSheet& sheet);

}  // namespace tedavis::host_sim
