#include "render_core/draw/data/feature_importance.hpp"

#include "render_core/draw/data/placement.hpp"

namespace tedavis::draw {

bool is_unimportant(const ElementInput& input, std::string_view attribute, std::uint32_t feature) {
    const scene::Attribute* const stated = input.layer.find(attribute);
    if (stated == nullptr) return false;
    const double least = kMaxLeftOut * (1 - input.element.detail) * static_cast<double>(stated->entry->maximum);
    return scene::value_or_nan(input.layer, attribute, feature) < least;
}

}  // namespace tedavis::draw
