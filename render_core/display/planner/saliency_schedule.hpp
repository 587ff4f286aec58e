/// When the saliency map of a display's own pictures is measured.
///
/// On es3 every frame that shows it measures it. On es2 the first frame of each decision interval (flight/decision_interval.hpp)
/// measures it, each time that it is drawn. The others show this map, which is at most one interval old and of a slightly
/// different view. A frame that measures for later ones must be drawn.
///
/// Plain data: a copy is the state that one frame passes to the next. Pure; any thread.
#pragma once

#include <type_traits>

#include "render_core/base/time.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::display {

class SaliencySchedule {
public:
    /// `is_asked_for`: one of the designs requests it; else nothing is measured.
    void start(effects::Lane lane, bool is_asked_for) {
        keeps_ = lane == effects::Lane::es2;
        is_asked_for_ = is_asked_for;
    }
    /// Plans the frame at `now`; `runs`: the effect runs in it.
    void plan(bool runs, base::Time now);
    /// Whether the planned frame shows the map, and whether it measures it.
    [[nodiscard]] bool runs() const { return runs_; }
    [[nodiscard]] bool measures() const { return measures_; }
    /// Returns true where later frames show what the planned one measures.
    [[nodiscard]] bool must_be_drawn() const { return measures_ && keeps_; }
    /// Returns the time from which frames must be drawn so that the frame at `time` is the same as in a whole run.
    [[nodiscard]] base::Time needed_since(base::Time time) const;
    /// States that the planned frame has measured the map.
    void take() {
        measured_ = now_;
        has_map_ = true;
    }
    /// Forgets the map: the next frame does not continue the last one.
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
