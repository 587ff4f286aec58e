/// How far the eye has come from one view mode to another: by the time of the source, at an even rate, so that the same instants
/// give the same ways. To and from the orthographic view there is no way: back from the own ship it would lead through the
/// terrain. Plain data; a copy is a checkpoint.
#pragma once

#include <type_traits>

#include "render_core/base/time.hpp"
#include "render_core/design/design_settings.hpp"

namespace tedavis::display {

class ViewTransition {
public:
    /// Once a frame. The first frame is there at once; so is a frame before the last one, later than it by more than a whole way,
    /// or at its very instant but in another mode: time that stands still leaves no way to be seen.
    void step(design::ViewMode wanted, double whole_way_s, base::Time now) noexcept;
    /// Leaves out the rest of the way.
    void arrive() noexcept;

    /// Of the way from 3D to the map, 0..1; 1 in the orthographic view too, which is as far away.
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
