/// The effect of a frame's foci on an element's glyphs. Pure; any thread.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/frame_foci.hpp"
#include "render_core/scene/glyph_selection.hpp"

namespace tedavis::draw {

/// `foci`: LayerFoci::frame() of the layer; null: no foci. Data foci on the attribute that the glyphs show use the glyphs'
/// values; those on another attribute use the positions of its values. `coarsest`: scene::GlyphSettings::coarsest.
[[nodiscard]] scene::GlyphFocus glyph_focus(const FrameFoci* foci, const design::DataElement& element, const scene::Layer& layer,
                                            double coarsest);

}  // namespace tedavis::draw
