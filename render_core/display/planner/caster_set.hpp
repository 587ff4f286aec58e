/// The shadow casters of a frame: data elements of the roles that a design names, as they are drawn.
///
/// Plain data, with pointers that are valid until the next plan. Thread  the display's.
#pragma once

#include "render_core/draw/data/caster_groups.hpp"
#include "render_core/draw/data/glyph_batch.hpp"
#include "render_core/draw/data/solid_batch.hpp"

namespace tedavis::display {

struct CasterSet {
    const draw::SolidBatch* solids[draw::kMaxSolidBuffers] = {};
    draw::CasterGroups groups;
    const draw::GlyphBatch* glyphs = nullptr;
    std::uint32_t glyph_slots = 0;  ///< one bit for each slot
};

}  // namespace tedavis::display
