/// `tedavis sheet readme`: the pictures at the top of README.md, small enough to load at once.
#pragma once

#include "host_sim/commands/sheet.hpp"

namespace tedavis::host_sim {

inline constexpr const char* kReadmeSheetName = "readme";
/// Folder of README.md's pictures, relative to the root of the project.
inline constexpr const char* kReadmePictureFolder = "docs";
inline constexpr PictureSize kReadmeLargeSize{1280, 720}, kReadmeRowSize{640, 360};

/// Writes the moments of the gallery that have a place in README.md, as PNG of 256 colors; no sheet and no page.
/// `options.picture` states no size. Throws UserError and Interrupted.
[[nodiscard]] int run_readme_sheet(const SheetOptions& options, Console& console);

}  // namespace tedavis::host_sim
