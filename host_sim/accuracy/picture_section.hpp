/// The part of a knob's section that shows its pictures: cheap over exact with a slider, maps of the difference, the worst pixel.
#pragma once

#include <string>

#include "host_sim/accuracy/knob_pictures.hpp"

namespace tedavis::host_sim {

/// CSS of the sliders.
[[nodiscard]] const char* picture_style();

/// HTML; the pictures are embedded.
[[nodiscard]] std::string picture_section(const KnobPictures& pictures);

}  // namespace tedavis::host_sim
