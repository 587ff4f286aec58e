/// `tedavis sheet display`: a picture of the display with every part named.
#pragma once

#include "host_sim/commands/sheet.hpp"
#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

inline constexpr const char* kDisplaySheetName = "display";

/// Returns the picture with the names of its parts, over the terrain of the options. Throws UserError and Interrupted.
[[nodiscard]] RgbaPicture named_display(const PictureOptions& options);

/// Writes the files of run_sheet() with one picture. Uses the options size, device, aircraft, palette, light and the folder;
/// refuses terrain, scene, pose, time and layers. Returns the exit code; throws UserError and Interrupted.
[[nodiscard]] int run_display_sheet(const SheetOptions& options, Console& console);

}  // namespace tedavis::host_sim
