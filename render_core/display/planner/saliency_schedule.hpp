/// When the saliency map of a display's own pictures is measured.
///
/// On es3 every frame that shows it measures it. On es2 the first frame of each decision interval (flight/decision_interval.hpp)
/// does, as often as it is drawn, and the others show what that one measured: at most so old, and of a picture that stood a
/// little elsewhere. A frame that measures for later ones must be drawn.
///
/// Plain data: a copy is what one frame leaves to the next. Pure; any thread.
#pragma once

#include <type_traits>

#include "render_core/base/time.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::display {

class SaliencySchedule {
public:
    /// `is_asked_for`: by a design that is shown; without, nothing is measured.
    void start(effects::Lane lane, bool is_asked_for) {
        keeps_ = lane == effects::Lane::es2;
        is_asked_for_ = is_asked_for;
    }
    /// Of the frame at `now`; `runs`: the plan of effects says so.
    void plan(bool runs, base::Time now);
    /// Whether the planned frame shows the map, and whether it measures it.
    [[nodiscard]] bool runs() const { return runs_; }
    [[nodiscard]] bool measures() const { return measures_; }
    /// Later frames show what the planned one measures.
    [[nodiscard]] bool must_be_drawn() const { return measures_ && keeps_; }
    /// From when on frames must have been drawn for the one at `time` to be what it is.
    [[nodiscard]] base::Time needed_since(base::Time time) const;
    /// The planned frame has measured.
    void take() {
        measured_ = now_;
        has_map_ = true;
    }
    /// The next frame does not follow the last one.
    void forget() { has_map_ = false; }

private:
    bool keeps_ = false;  ///< maps for later frames
    bool is_asked_for_ = false;
    bool runs_ = false, measures_ = false;
    bool has_map_ = false;
    base::Time now_{0}, measured_{0};  ///< of the planned frame; of the map
};
static_assert(std::is_trivially_copyable_v<SaliencySchedule>);

}  // namespace tedavis::display
