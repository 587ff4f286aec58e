#include "render_core/draw/ground_focus_kind.hpp"

#include <algorithm>
#include <tuple>

namespace tedavis::draw {

using design::FocusBorderKind;

bool operator==(const GroundFocusKind& a, const GroundFocusKind& b) noexcept {
    const auto all = [](const GroundFocusKind& k) {
        return std::tie(k.foci, k.has_paths, k.has_squares, k.has_chebyshev, k.has_lines, k.has_halos, k.has_grids, k.sketches,
                        k.blurs);
    };
    return all(a) == all(b);
}

bool covers(const GroundFocusKind& built, const GroundFocusKind& wanted) noexcept {
    GroundFocusKind both = built;
    both.foci = std::max(built.foci, wanted.foci);
    both.has_paths = built.has_paths || wanted.has_paths;
    both.has_squares = built.has_squares || wanted.has_squares;
    both.has_chebyshev = built.has_chebyshev || wanted.has_chebyshev;
    both.has_lines = built.has_lines || wanted.has_lines;
    both.has_halos = built.has_halos || wanted.has_halos;
    both.has_grids = built.has_grids || wanted.has_grids;
    both.sketches = built.sketches || wanted.sketches;
    return both == built && built.blurs == wanted.blurs && (built.foci > 0) == (wanted.foci > 0);
}

GroundFocusKind ground_focus_kind(const design::FocusList& foci) noexcept {
    GroundFocusKind kind;
    if (!design::change_the_ground(foci)) return kind;
    kind.foci = static_cast<std::uint8_t>(foci.size());
    for (const design::FocusSettings& focus : foci) {
        kind.has_paths = kind.has_paths || focus.shape == design::FocusShape::path;
        kind.has_squares =
            kind.has_squares || focus.shape == design::FocusShape::square || focus.shape == design::FocusShape::cuboid;
        kind.has_chebyshev = kind.has_chebyshev || focus.context.distance == scene::FocusDistance::chebyshev;
        kind.has_lines = kind.has_lines || focus.border.kind == FocusBorderKind::line;
        kind.has_halos = kind.has_halos || focus.border.kind == FocusBorderKind::halo;
        kind.has_grids = kind.has_grids || focus.border.kind == FocusBorderKind::grid;
    }
    const design::FocusTerrain& context = design::terrain_of_context(foci);
    kind.sketches = context.sketch_outside;
    kind.blurs = context.blur_px > 0;
    return kind;
}

}  // namespace tedavis::draw
