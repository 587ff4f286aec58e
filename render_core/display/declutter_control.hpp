/// Holds the budget of clutter of a display's own pictures (effects/clutter_budget.hpp): when they are measured, and by which
/// measures a frame goes.
///
/// The first frame of each interval of labels (draw/data/label_planner.hpp; on es2 of every second one) measures its picture with
/// all detail and, where that is beyond the budget, with the least, and up to kMaxTries times with what may suffice; such
/// pictures are drawn for that, and never seen. A frame goes by the intervals before its own as far back as kHeld, and in each
/// region by the one that takes away most: what gives way comes back when it would have had room for so long. With nothing before
/// it, at a flight's beginning and after a turn of designs, it goes by its own interval's. No measure depends on what gave way
/// before, so that a frame is the same however it is reached, where the frames that measure have been drawn. What another of the
/// display's designs measured does not count.
///
///   follow(...), regions(...), plan(...) each frame · then draw: step() says which picture is to be measured, until none is
///
/// Plain data: a copy is what one frame leaves to the next. Pure; any thread.
#pragma once

#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/time.hpp"
#include "render_core/draw/terrain_program.hpp"
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
    /// Whether one of the designs of start() does what this one asks for.
    [[nodiscard]] bool can_show(const design::DesignSettings& design) const;
    /// Whether edges are measured at all, and whether a design shows them.
    [[nodiscard]] bool measures() const { return shows_ || has_budget_; }
    [[nodiscard]] bool shows() const { return shows_; }

    /// Before regions(): the same instant seen from elsewhere follows from nothing.
    void follow(base::Time now, const terrain::View& view);
    /// By which the frame at `now` goes.
    [[nodiscard]] scene::DetailRegions regions(base::Time now, std::size_t design) const;
    struct Measured {
        effects::ClutterMeasures clutter;
        effects::ClutterMap reached;  ///< with what the interval would leave; where nothing gives way unknown
    };
    /// Of the newest interval that they follow from; unknown without one.
    [[nodiscard]] Measured measured(base::Time now, std::size_t design) const;

    /// `runs`: the plan of effects says so; `budget` 1: none is held, and nothing measured for it.
    void plan(bool runs, base::Time now, std::size_t design, double budget);
    /// Later frames go by what the planned one measures.
    [[nodiscard]] bool must_be_drawn() const { return step_ != Step::none; }
    /// From when on frames must have been drawn for the one at `time` to be what it is.
    [[nodiscard]] base::Time needed_since(base::Time time) const;
    /// The next frame does not follow the last one.
    void forget();

    [[nodiscard]] Step step() const { return step_; }
    /// What each region keeps in the picture that it asks for.
    [[nodiscard]] scene::DetailRegions step_regions() const { return step_regions_; }
    /// What was measured of the picture that step() asks for; the next step follows from it.
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
    /// What a frame goes by: earlier intervals, or, where none is known, its own.
    [[nodiscard]] Deciding deciding(base::Time now, std::size_t design) const;

    bool shows_ = false, has_budget_ = false;  ///< one of the designs
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
