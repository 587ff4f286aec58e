/// Which layer each pixel of a frame belongs to: the frontmost one that changes it.
///
/// The frame is drawn up to each layer in turn; a pixel that a layer leaves as it is belongs to what lies behind. What blends
/// with the ground is its own layer's from the first step of a colour on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/replay/display_session.hpp"
#include "render_core/display/planner/obstacle_places.hpp"

namespace tedavis::host_sim {

/// Of the frame that was drawn last: a number of display::PictureLayer a pixel, top row first. Afterwards the session's picture
/// is the whole one again. Costs as many drawings as there are layers.
[[nodiscard]] std::vector<std::uint8_t> drawn_layers(DisplaySession& session);
/// Where the obstacles ahead are in the frame that was planned last: what a contract asks for beside the layers.
[[nodiscard]] display::ObstaclePlaces obstacles_of_frame(DisplaySession& session);
/// Beside a picture (evaluation/layer_mask.hpp). Throws UserError.
void write_drawn_layers(const std::string& picture, DisplaySession& session);

}  // namespace tedavis::host_sim
