/// What the foci of a frame make of an element's glyphs. Pure; any thread.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/frame_foci.hpp"
#include "render_core/scene/glyph_selection.hpp"

namespace tedavis::draw {

/// `foci`: LayerFoci::frame() of the layer; null: nothing steps back. Foci that mean the values that the
/// glyphs show go by these; those for another attribute by where its values are. `coarsest`: scene::GlyphSettings::coarsest.
[[nodiscard]] scene::GlyphFocus glyph_focus(const FrameFoci* foci, const design::DataElement& element, const scene::Layer& layer,
                                            double coarsest);

}  // namespace tedavis::draw
