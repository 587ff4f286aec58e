/// Depth cues of lines above the ground (design/element_cues.hpp): vertical lines, the path's projection onto the ground, and a
/// curtain from the path down to it. They follow the same points as the tube (tube_path.hpp).
///
/// Vertical lines   have an equal spacing along the path over the ellipsoid, counted from its beginning, or from its end for
///                  paths that grow there (own trail, other aircraft). They reach kTickRadii of the tube's radius up and down,
///                  or down to the ground, and are at least a pixel wide. The frame's time determines how far moving lines have
///                  moved; lines that move away do so in both directions from the point of the path nearest to the eye.
/// Projection       a strip on the drawn ground, as wide as the tube, in a darker shade of its colour.
/// Curtain          a translucent surface from the tube's middle to the ground, in the tube's colours.
///
/// The element's uncertainty technique applies to them: colours fade equally, a projection is as wide as a hull, and with a
/// hull (`widening`) all are as faint as it. Nothing is drawn where the path is less than kFloating_m above the ground;
/// projections and curtains need a known ground. They end kNearRadii before the eye point, as the tube does.
///
/// Counts are lines, and stretches of at most kLongestStep_m; hidden is what has no room. Memory  from an arena, once; may be
/// shared with other builders. Thread  the ground's. Bounded.
#pragma once

#include <array>

#include "render_core/draw/data/solid_mesh.hpp"
#include "render_core/draw/data/tube_path.hpp"

namespace tedavis::draw {

enum class Cue : std::uint8_t { vertical_lines, projection, curtain, count };
inline constexpr std::size_t kCues = static_cast<std::size_t>(Cue::count);
inline constexpr double kTickRadii = 3;

[[nodiscard]] bool asks_for(const design::ElementCues& cues, Cue cue);

struct CueCount {
    std::uint32_t drawn = 0, hidden = 0;
};

class TrajectoryCues {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t points);
    [[nodiscard]] bool start(base::Arena& arena, std::uint32_t points);

    [[nodiscard]] CueCount add(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, Cue cue);

private:
    TubePath way_;
    TubeLine line_;
};

}  // namespace tedavis::draw
