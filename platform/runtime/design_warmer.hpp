/// Draws each design that a phase can ask for once, behind the picture that is shown, and at last how one design fades
/// into another. A GL driver compiles what it draws for the first time, and the planner builds a design's geometry then:
/// afterwards a change of phase takes no longer than another frame.
///
///   begin(planner) · after a frame that was shown: draw_next(...) until it is false · begin(planner) again for other designs
///
/// Memory    a copy of the planner's memory, inside. Thread  the display's.
#pragma once

#include <cstdint>

#include "render_core/base/ports/surface.hpp"
#include "render_core/display/display.hpp"

namespace tedavis::platform {

class DesignWarmer {
public:
    /// The design that is shown at the moment needs it no less than the others: it may have been shown without terrain so far.
    void begin(const display::FramePlanner& planner);
    /// Draws the flight of `input`, once more, in the next design that waits, or where all are drawn the fade. The surface holds
    /// that picture afterwards, and it must not be shown. The display's record is that picture's; the next frame follows the last
    /// one that was shown, and must be drawn before the display is given another scene or other designs. False, and nothing is
    /// drawn, where nothing waits, or at the moment one design fades into another.
    [[nodiscard]] bool draw_next(display::Display& display, base::Surface& surface, const flight::FrameInput& input);
    /// All of it has been drawn since begin().
    [[nodiscard]] bool is_done() const { return has_begun_ && waiting_ == 0 && !fade_waits_; }

private:
    static_assert(design::kMaxPhaseDesigns + 1 <= 32, "one bit for each design");
    [[nodiscard]] std::size_t take_first();
    void draw_design(display::Display& display, base::Surface& surface, flight::FrameInput input);
    void draw_fade(display::Display& display, base::Surface& surface, const flight::FrameInput& input) const;

    bool has_begun_ = false;
    std::uint32_t waiting_ = 0;  ///< a bit for each place of a design
    bool fade_waits_ = false;
    display::PlannerMemory kept_;
};

}  // namespace tedavis::platform
