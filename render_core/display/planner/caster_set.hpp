/// What casts shadows in a frame: data elements of the roles that a design names, as they are drawn.
///
/// Plain data but for what it refers to, which stays until the next plan. Thread  the display's.
#pragma once

#include "render_core/draw/data/caster_groups.hpp"
#include "render_core/draw/data/glyph_batch.hpp"
#include "render_core/draw/data/solid_batch.hpp"

namespace tedavis::display {

struct CasterSet {
    const draw::SolidBatch* solids[draw::kMaxSolidBuffers] = {};
    draw::CasterGroups groups;
    const draw::GlyphBatch* glyphs = nullptr;
    std::uint32_t glyph_slots = 0;  ///< a bit each
};

}  // namespace tedavis::display
