/// Draws each design that a phase can have once, without showing it, and then a fade from one design into another. When a design
/// is drawn for the first time, the GL driver compiles its programs and the planner builds its geometry. Afterwards the first
/// frame of a new phase takes no longer than other frames.
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
    /// Begins with all designs, also the one that is shown at the moment, since it may have been shown without terrain so far.
    void begin(const display::FramePlanner& planner);
    /// Draws `input` again in the next design that waits, or, where all have been drawn, the fade. Afterwards the surface holds
    /// that picture, which must not be shown, and the display's record is that of the picture. The next frame continues the last
    /// one that was shown; it must be drawn before the display is given another scene or other designs. Returns false and draws
    /// nothing where nothing waits, or while one design fades into another.
    [[nodiscard]] bool draw_next(display::Display& display, base::Surface& surface, const flight::FrameInput& input);
    /// Whether everything has been drawn since begin().
    [[nodiscard]] bool is_done() const { return has_begun_ && waiting_ == 0 && !fade_waits_; }

private:
    static_assert(design::kMaxPhaseDesigns + 1 <= 32, "one bit for each design");
    [[nodiscard]] std::size_t take_first();
    void draw_design(display::Display& display, base::Surface& surface, flight::FrameInput input);
    void draw_fade(display::Display& display, base::Surface& surface, const flight::FrameInput& input) const;

    bool has_begun_ = false;
    std::uint32_t waiting_ = 0;  ///< a bit for the place of each design
    bool fade_waits_ = false;
    display::PlannerMemory kept_;
};

}  // namespace tedavis::platform
