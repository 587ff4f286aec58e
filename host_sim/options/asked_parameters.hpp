/// Converts the options that override the designs into the form that desk and board share.
#pragma once

#include "host_sim/options/picture_options.hpp"
#include "platform/configuration/design_parameters.hpp"

namespace tedavis::host_sim {

/// Throws UserError where there are more weights or foci than a display has room for, or one is longer than its text may be.
[[nodiscard]] platform::DesignParameters asked_parameters(const PictureOptions& options);

}  // namespace tedavis::host_sim
