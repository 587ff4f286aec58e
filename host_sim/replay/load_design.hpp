/// The design that a run is drawn with: the file, and what the command line puts above it.
#pragma once

#include <string>

#include "host_sim/commands/replay.hpp"
#include "render_core/design/design_settings.hpp"

namespace tedavis::host_sim {

/// Path of the design file, short names resolved. Throws UserError where there is none.
[[nodiscard]] std::string design_path(const PictureOptions& options);
/// Throws UserError with file and line.
[[nodiscard]] design::DesignSettings design_from_text(const std::string& text, const PictureOptions& options);
[[nodiscard]] design::DesignSettings load_design(const PictureOptions& options);

}  // namespace tedavis::host_sim
