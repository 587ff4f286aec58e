#include "render_core/display/planner/ghost_element.hpp"

#include "render_core/display/planner/element_labels.hpp"
#include "render_core/draw/data/ghost_signs.hpp"

namespace tedavis::display {
namespace {

const design::DataElement kGhosts = [] {
    design::DataElement element;
    element.role = scene::LayerRole::ghost;
    element.technique = design::DataTechnique::billboard;
    element.color = draw::kGhostColor;
    return element;
}();

bool are_meant(const design::DataElementList& elements, const scene::Layer& layer) {
    for (const design::DataElement& element : elements)
        if (element.own == design::OwnData::none && is_meant(element, layer)) return true;
    return false;
}

}  // namespace

bool needs_ghost_element(const design::DataElementList& elements, const scene::Layer& layer) {
    return draw::shows_ghosts(layer) && !are_meant(elements, layer);
}

const design::DataElement& ghost_element() { return kGhosts; }

}  // namespace tedavis::display
