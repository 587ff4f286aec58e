/// `tedavis sheet gallery`: pictures that tell the story of the shipped default flight, drawn as a replay draws them.
#pragma once

#include <string>

#include "host_sim/commands/sheet.hpp"

namespace tedavis::host_sim {

inline constexpr const char* kGallerySheetName = "gallery";

/// Throws UserError that names the sheet where the options ask for another flight or view.
void require_default_flight(const SheetOptions& options, const std::string& sheet);

/// Builds the shipped terrain and the default flight, and writes what run_sheet() writes. Throws UserError and Interrupted.
[[nodiscard]] int run_gallery_sheet(const SheetOptions& options, Console& console);

}  // namespace tedavis::host_sim
