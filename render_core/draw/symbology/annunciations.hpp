/// The strip of annunciations along the top of the display: the flight phase with its source at the left, then warnings and
/// cautions in their order, the most urgent first, and how many have no room; the activity mark at its right end.
///
/// Fields are as wide as their words; they stand on one translucent ground, and a thin frame in their colour marks notices.
/// Where the strip has two rows, the source is always below the phase, and notices continue in the second row. A notice
/// is left out only together with all that are less urgent. Pure: no GL, no clock, no heap. Thread any.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/span.hpp"
#include "render_core/draw/rect.hpp"
#include "render_core/draw/symbology/painter.hpp"
#include "render_core/draw/symbology/symbology_input.hpp"
#include "render_core/flight/flight_phase.hpp"
#include "render_core/policy/display_decisions.hpp"

namespace tedavis::draw {

enum class AnnunciationKind : std::uint8_t {
    phase,
    phase_source,
    warning,
    caution,
    more,  ///< the number of notices that have no room
};

struct Annunciation {
    AnnunciationKind kind = AnnunciationKind::phase;
    Rect box;                    ///< pixels, within the strip; no two overlap
    float size = 0;              ///< of its text, in texts; smaller only where the box is too narrow for the words
    base::FixedString<63> text;  ///< upper case ASCII
};

/// The phase, its source, all notices and the number of the others.
inline constexpr std::size_t kMaxAnnunciations = 21;

struct AnnunciationPlan {
    base::FixedVector<Annunciation, kMaxAnnunciations> fields;
    std::size_t left_out = 0;  ///< warnings and cautions without room
};
static_assert(std::is_trivially_copyable_v<AnnunciationPlan>);

/// True where a source states the phase now: it is neither held nor unknown.
[[nodiscard]] bool is_phase_certain(const flight::PhaseStatus& status) noexcept;

/// `strip` in pixels, at least 15 texts wide; `text_px` pixels an em of ordinary text; `phase` null: it is not shown. Of the
/// notices, those that are only information are not in the strip. The first notice is always shown.
[[nodiscard]] AnnunciationPlan plan_annunciations(const Rect& strip, float text_px, const flight::PhaseStatus* phase,
                                                  base::Span<const policy::Notice> notices) noexcept;

void build_annunciations(const Painter& painter, const SymbologyInput& input);

}  // namespace tedavis::draw
