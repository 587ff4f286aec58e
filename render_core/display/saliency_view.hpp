/// The saliency map of a display's own pictures: when it is measured, and how it is shown over them.
///
/// On es3 every frame that shows it measures it. On es2 the first frame of each epoch of labels (draw/data/label_planner.hpp)
/// does, as often as it is drawn, and the others show what that one measured: at most so old, and of a picture that stood a
/// little elsewhere. A frame that measures for later ones must be drawn.
///
/// Memory    draw::SaliencyPass's, where a design asks for it; else none. Thread  the GL thread; plan() is pure. Failure start():
///           one sentence.
#pragma once

#include "render_core/base/time.hpp"
#include "render_core/display/effect_work.hpp"
#include "render_core/draw/saliency_pass.hpp"
#include "render_core/draw/terrain_program.hpp"

namespace tedavis::display {

class SaliencyView {
public:
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, draw::DrawnDesigns designs, std::uint32_t width_px,
                                    std::uint32_t height_px);
    /// Whether what start() built shows the design's.
    [[nodiscard]] bool shows(const design::Saliency& saliency) const;

    /// Of the frame at `now`; `runs`: the plan of effects says so.
    void plan(bool runs, base::Time now);
    /// Later frames show what the planned one measures.
    [[nodiscard]] bool must_be_drawn() const { return measures_ && keeps_; }
    /// From when on frames must have been drawn for the one at `time` to be what it is.
    [[nodiscard]] base::Time needed_since(base::Time time) const;
    /// The next frame does not follow the last one.
    void forget() { has_map_ = false; }

    /// Of the planned frame, over all that is on the surface, where it runs.
    void draw(gl::Gl& gl, const base::Surface& surface, const design::Saliency& saliency, EffectWork& work);
    void destroy(gl::Gl& gl) { pass_.destroy(gl); }

private:
    draw::SaliencyPass pass_;
    bool keeps_ = false;  ///< maps for later frames
    bool runs_ = false, measures_ = false;
    bool has_map_ = false;
    base::Time now_{0}, measured_{0};  ///< of the planned frame; of the map
};

}  // namespace tedavis::display
