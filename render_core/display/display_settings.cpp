#include "render_core/display/display_settings.hpp"

namespace tedavis::display {

bool DisplaySettings::asks_for_rays() const {
    const auto is_traced = [](const design::DesignSettings& one) {
        return one.terrain.renderer == design::TerrainRenderer::trace;
    };
    bool asks = is_traced(design);
    const std::size_t count = phases != nullptr ? phases->size() : 0;
    for (std::size_t place = 1; place <= count; ++place) asks = asks || is_traced(phases->at(place));
    return asks;
}

}  // namespace tedavis::display
