/// The kinds of changes that foci make to the ground and for which programs are compiled (focus_ground.hpp). Pure; any thread.
#pragma once

#include <cstdint>

#include "render_core/design/focus_settings.hpp"

namespace tedavis::draw {

/// The variant of foci that programs are built for.
struct GroundFocusKind {
    std::uint8_t foci = 0;  ///< number of the design's foci; 0: none changes the ground
    bool has_paths = false, has_squares = false, has_chebyshev = false;
    bool has_lines = false, has_halos = false, has_grids = false;
    bool sketches = false, blurs = false;
};
[[nodiscard]] bool operator==(const GroundFocusKind& a, const GroundFocusKind& b) noexcept;
/// True where programs built for one variant can also draw another.
[[nodiscard]] bool covers(const GroundFocusKind& built, const GroundFocusKind& wanted) noexcept;
[[nodiscard]] GroundFocusKind ground_focus_kind(const design::FocusList& foci) noexcept;

}  // namespace tedavis::draw
