#include "render_core/display/planner/display_settings.hpp"

namespace tedavis::display {

bool DisplaySettings::asks_for_rays() const {
    bool asks = design::may_trace(design.terrain);
    const std::size_t count = phases != nullptr ? phases->size() : 0;
    for (std::size_t place = 1; place <= count; ++place) asks = asks || design::may_trace(phases->at(place).terrain);
    return asks;
}

}  // namespace tedavis::display
