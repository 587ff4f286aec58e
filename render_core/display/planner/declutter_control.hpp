/// Decides when the clutter of a display's own pictures is measured, and which measurements a frame uses to hold the clutter
/// budget (effects/clutter_budget.hpp).
///
/// The first frame of each interval of labels (draw/data/label_planner.hpp; on es2 of every second one) measures its picture with
/// all detail. Where that is above the budget, it also measures a picture with the least detail, and up to kMaxTries pictures
/// with detail that may suffice. Of these only the first can be shown, if no other one is requested after it. A frame uses the
/// measurements of the intervals that began within the last kHeld, and in each region the one with the lowest detail, so that
/// detail returns only after it has met the budget for that long. Without earlier measurements, at the beginning of a flight and
/// after a design transition, a frame uses the measurement of its own interval. No measurement depends on earlier reductions, so
/// a frame is the same from whichever frame a replay starts, if the frames that measure have been drawn. Measurements of the
/// display's other designs are not used.
///
///   follow(...), regions(...), plan(...) each frame · then draw: step() says which picture is to be measured, until none is
///
/// Plain data: a copy is the state that one frame passes to the next. Pure; any thread.
#pragma once

#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/time.hpp"
#include "render_core/draw/drawn_design.hpp"
#include "render_core/effects/clutter_budget.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::display {

class DeclutterControl {
public:
    static constexpr base::Duration kHeld = base::Duration::seconds(2);
    static constexpr int kMaxTries = 3;
    enum class Step : std::uint8_t { none, whole, least, tried };

    void start(effects::Lane lane, draw::DrawnDesigns designs);
    /// Whether one of the designs of start() requests what this one requests.
    [[nodiscard]] bool can_show(const design::DesignSettings& design) const;
    /// Whether edges are measured at all, and whether a design shows them.
    [[nodiscard]] bool measures() const { return shows_ || has_budget_; }
    [[nodiscard]] bool shows() const { return shows_; }

    /// Begins a frame; to be called before regions(). A second frame at the same instant from another viewpoint uses no earlier
    /// measurement.
    void follow(base::Time now, const terrain::View& view);
    /// Returns the detail per region for the frame at `now`.
    [[nodiscard]] scene::DetailRegions regions(base::Time now, std::size_t design) const;
    struct Measured {
        effects::ClutterMeasures clutter;
        effects::ClutterMap reached;  ///< with the detail that the interval keeps; unknown where nothing is reduced
    };
    /// Returns the measurement of the newest interval that regions() uses; unknown without one.
    [[nodiscard]] Measured measured(base::Time now, std::size_t design) const;

    /// Plans the measurements of a frame. `runs`: the effect runs in it; `budget` 1: no budget is held, and nothing is measured
    /// for it.
    void plan(bool runs, base::Time now, std::size_t design, double budget);
    /// Returns true where later frames use what the planned one measures.
    [[nodiscard]] bool must_be_drawn() const { return step_ != Step::none; }
    /// Returns the time from which frames must be drawn so that the frame at `time` is the same as in a whole run.
    [[nodiscard]] base::Time needed_since(base::Time time) const;
    /// Forgets all measurements: the next frame does not continue the last one.
    void forget();

    [[nodiscard]] Step step() const { return step_; }
    /// Returns the detail of each region in the picture that step() requests.
    [[nodiscard]] scene::DetailRegions step_regions() const { return step_regions_; }
    /// Takes the measurement of the picture that step() requests, and determines the next step.
    void take(const effects::ClutterMap& map);

private:
    static constexpr std::size_t kMaxHeld = 4;
    struct Held {
        bool is_known = false;
        std::int64_t interval = 0;
        std::size_t design = 0;
        Measured measured;
        scene::DetailRegions left;
    };
    void take_try(Held& held, const effects::ClutterMap& reached);
    void ask_for(Step step, const scene::DetailRegions& regions);
    [[nodiscard]] std::int64_t interval_of(base::Time now) const;
    [[nodiscard]] Held& place_of(std::int64_t interval);
    [[nodiscard]] bool counts(const Held& held, base::Time now, std::size_t design) const;
    [[nodiscard]] bool is_own(const Held& held, base::Time now, std::size_t design) const;
    [[nodiscard]] bool follows(base::Time now, std::size_t design) const;
    using Deciding = base::FixedVector<const Held*, kMaxHeld + 1>;
    /// Returns the measurements that a frame uses: those of earlier intervals, or, where none is known, that of its own.
    [[nodiscard]] Deciding deciding(base::Time now, std::size_t design) const;

    bool shows_ = false, has_budget_ = false;  ///< of at least one design
    base::Duration interval_{0};
    std::array<Held, kMaxHeld + 1> held_;
    Step step_ = Step::none;
    scene::DetailRegions step_regions_;
    int tries_ = 0;
    base::Time now_{0};  ///< of the planned frame, with what follows
    std::size_t design_ = 0;
    double budget_ = 1;
    base::Time last_now_{0};
    glm::dvec3 last_eye_{0}, last_forward_{0};
};
static_assert(std::is_trivially_copyable_v<DeclutterControl>);

}  // namespace tedavis::display
