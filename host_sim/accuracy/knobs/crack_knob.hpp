/// Cracks of the drawn terrain, through which the background is seen, a setting with one level
/// (render_core/terrain/chunk_mesh.hpp).
#pragma once

#include <memory>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/accuracy/knobs/knob_ground.hpp"

namespace tedavis::host_sim {

/// Those of some pixels in which a picture has the very colour of the same picture without terrain, whose background is magenta.
[[nodiscard]] std::vector<KnobPixel> cracks_among(const std::vector<KnobPixel>& pixels, const RgbaView& drawn,
                                                  const RgbaView& background);

[[nodiscard]] std::unique_ptr<Knob> make_crack_knob(const KnobGround& ground);

}  // namespace tedavis::host_sim
