/// What options put above the designs, as desk and board hold it.
#pragma once

#include "host_sim/options/picture_options.hpp"
#include "platform/configuration/design_parameters.hpp"

namespace tedavis::host_sim {

/// Throws UserError where there are more than a display has room for.
[[nodiscard]] platform::DesignParameters asked_parameters(const PictureOptions& options);

}  // namespace tedavis::host_sim
