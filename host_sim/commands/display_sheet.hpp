/// `tedavis sheet display`: a picture of the display with every part named.
#pragma once

#include "host_sim/commands/sheet.hpp"
#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

inline constexpr const char* kDisplaySheetName = "display";

/// The picture with its names, over the terrain of the options. Throws UserError and Interrupted.
[[nodiscard]] RgbaPicture named_display(const PictureOptions& options);

/// Leaves what run_sheet() does, with one picture. Of the options: size, device, aircraft, palette, light and the folder;
/// terrain, scene, pose, time and layers are refused. Returns the exit code; throws UserError and Interrupted.
[[nodiscard]] int run_display_sheet(const SheetOptions& options, Console& console);

}  // namespace tedavis::host_sim
