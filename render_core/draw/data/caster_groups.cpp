#include "render_core/draw/data/caster_groups.hpp"

namespace tedavis::draw {

bool casts_shadow(const SolidPiece& piece, const CasterGroups& groups) {
    const SolidLook& look = piece.look;
    return (groups.all >> look.group & 1u) != 0 && look.is_thing && look.halo_px <= 0 && look.raised_px <= 0 && look.opacity > 0;
}

}  // namespace tedavis::draw
