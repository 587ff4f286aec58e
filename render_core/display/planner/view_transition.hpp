/// The progress of the camera from one view mode to another: at a constant rate of the source's time, so that equal instants give
/// equal positions. The orthographic view is entered and left without a transition, since a path back from the own ship would
/// lead through the terrain. Plain data; a copy is a checkpoint.
#pragma once

#include <type_traits>

#include "render_core/base/time.hpp"
#include "render_core/design/design_settings.hpp"

namespace tedavis::display {

class ViewTransition {
public:
    /// Advances the transition; to be called once per frame. The first frame has the requested mode at once. So has a frame that
    /// is earlier than the last one, later than it by more than a whole transition, or at the same instant but in another mode:
    /// while time stands still no transition can be seen.
    void step(design::ViewMode wanted, double whole_way_s, base::Time now) noexcept;
    /// Completes the transition at once.
    void arrive() noexcept;

    /// Returns the share of the transition from 3D to the map, 0..1; it is 1 in the orthographic view, too, which is as far away.
    [[nodiscard]] double map_share() const { return map_share_; }
    [[nodiscard]] bool is_under_way() const { return map_share_ != goal(); }

private:
    [[nodiscard]] double goal() const { return wanted_ == design::ViewMode::perspective ? 0 : 1; }

    bool has_begun_ = false;
    design::ViewMode wanted_ = design::ViewMode::perspective;
    double map_share_ = 0, from_share_ = 0;
    base::Time last_, from_;
};
static_assert(std::is_trivially_copyable_v<ViewTransition>);

}  // namespace tedavis::display
