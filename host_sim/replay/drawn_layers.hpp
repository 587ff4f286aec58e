/// Which layer each pixel of a frame belongs to: the frontmost one that changes it.
///
/// The frame is drawn up to each layer in turn; a pixel that a layer does not change belongs to a layer behind it. A pixel in
/// which a layer is blended with the ground belongs to the layer if a colour channel changes by at least one step.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/replay/display_session.hpp"
#include "render_core/display/planner/obstacle_places.hpp"

namespace tedavis::host_sim {

/// Returns for each pixel of the last frame, top row first, the number of its display::PictureLayer. Afterwards the session holds
/// the complete picture again. Draws the frame once for each layer.
[[nodiscard]] std::vector<std::uint8_t> drawn_layers(DisplaySession& session);
/// Returns the places of the obstacles ahead in the frame that was planned last, which contracts need beside the layers.
[[nodiscard]] display::ObstaclePlaces obstacles_of_frame(DisplaySession& session);
/// Writes drawn_layers() beside the file `picture` (host_sim/layer_mask.hpp). Throws UserError.
void write_drawn_layers(const std::string& picture, DisplaySession& session);

}  // namespace tedavis::host_sim
