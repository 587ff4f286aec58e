#include "render_core/draw/data/obstacle_color.hpp"

#include "render_core/design/warning_bands.hpp"

namespace tedavis::draw {

design::Color obstacle_color(const ElementInput& input, std::uint32_t feature, design::Color own) {
    if (input.alerts == nullptr) return own;
    switch (input.alerts->of(input.layer_number, feature)) {
        case policy::TerrainAhead::warning: return design::kWarningGround;
        case policy::TerrainAhead::caution: return design::kCautionGround;
        case policy::TerrainAhead::none: break;
    }
    return own;
}

}  // namespace tedavis::draw
