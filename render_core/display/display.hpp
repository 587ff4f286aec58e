/// The face of the core: aircraft state in, pixels and a FrameRecord out.
///
///   start(settings, memory, surface, terrain) · update(state, phase, now) · draw(surface) · stop()
///
/// Memory    everything from the arena and the GPU lines of the device's budget table, at start(); nothing later.
/// Thread    one, on which the surface is current. Time comes from the source with update(); no clock is read.
/// Failure   start() gives one sentence. Later faults of data remove what is not trustworthy, flag it and keep running.
#pragma once

#include "render_core/display/frame_painter.hpp"
#include "render_core/display/frame_planner.hpp"
#include "render_core/display/record_of.hpp"
#include "render_core/effects/calibration.hpp"
#include "render_core/flight/terrain_heights.hpp"

namespace tedavis::display {

/// What an interval leaves to the next one. Plain data.
struct IntervalMemory {
    LabelHistory labels;
    policy::PriorityBoost weights;
};

class Display final : public flight::TerrainHeights {
public:
    Display() = default;
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    /// The surface must be current. An empty sentence means success.
    /// `scene`: a scene database, or null; it is read whole, now.
    [[nodiscard]] base::Error start(const DisplaySettings& settings, base::Arena memory, base::Surface& surface,
                                    const TerrainInput& terrain, base::ByteSource* scene = nullptr);
    /// What the reservation handed to start() must hold for this device.
    [[nodiscard]] static std::uint64_t bytes_needed(const effects::DeviceSettings& device) {
        return DisplayMemory::bytes_needed(device.budget);
    }

    /// Whether a design asks for traced terrain: workers make it faster (TerrainInput).
    [[nodiscard]] static bool asks_for_rays(const DisplaySettings& settings);

    /// Plans the frame for `now`, without GL. `trail`: the flown trail, which must stay until the frame is drawn; null where
    /// nobody keeps one.
    void update(const flight::AircraftState& state, const flight::PhaseStatus& phase, base::Time now,
                const flight::FlightTrail* trail = nullptr);
    /// Plans like update(), but counts no frame and need not be drawn: what lies before the first frame that is shown.
    void preroll(const flight::AircraftState& state, const flight::PhaseStatus& phase, base::Time now,
                 const flight::FlightTrail* trail = nullptr);
    /// Decides the weights and labels of an interval (policy/priority_boost.hpp, element_labels.hpp) that begins at `now`, and
    /// plans nothing else: what a replay does for every interval from the log's start on, so that they are the same however a
    /// frame is reached. `phase`: of the frame before that instant, whose design the next frame shows.
    void preroll_interval(const flight::AircraftState& state, const flight::PhaseStatus& phase, base::Time now);
    /// Whether an interval leaves anything to the next one.
    [[nodiscard]] bool has_intervals() const { return planner_.has_intervals(); }
    [[nodiscard]] IntervalMemory interval_memory() const;
    void restore(const IntervalMemory& memory);
    /// Whether the interval was decided a second time, because another design took its turn or the view lies elsewhere. The next
    /// interval then follows from the first decision: whoever kept that one restores it before.
    [[nodiscard]] bool interval_is_anew() const { return memory_.boost.is_anew() || memory_.labels.is_anew; }
    /// Approaches one instant until everything it needs has arrived; gives up after a bounded number of times.
    void settle(const flight::AircraftState& state, const flight::PhaseStatus& phase, base::Time now);
    /// Draws what update() planned.
    void draw(base::Surface& surface);
    /// Draws the frame that was drawn last again, without what lies before a layer: for those who measure pictures. Counts as no
    /// frame, and changes nothing of its record or the next one; up to the symbology it is the same picture. A frame that keeps
    /// the picture of an earlier design (must_be_drawn()) must be drawn up to there before the next one is planned.
    void draw_up_to(base::Surface& surface, PictureLayer last);
    void stop();

    /// Colours, thresholds and views of other designs, and which phases have them; no new objects. Takes effect with the next
    /// update(), from which the eye travels to another mode of view. False, and nothing changes, when one needs techniques that
    /// the display was not started with.
    [[nodiscard]] bool set_design(const design::DesignSettings& design, const design::PhaseDesigns* phases = nullptr);
    /// Foci that somebody chose, in place of those chosen before: they stand before the ones of all designs from the next
    /// update() on. False, and nothing changes, where a design has no room for them, or needs techniques that the display was not
    /// started with.
    [[nodiscard]] bool set_foci(const design::FocusList& chosen);
    /// Whether a phase's design takes the place of another one little by little.
    [[nodiscard]] bool fades() const { return planner_.fades(); }
    /// True where a later frame shows the planned one again: it must be drawn, even if nobody looks at it.
    [[nodiscard]] bool must_be_drawn() const {
        return memory_.transition.keeps || memory_.saliency.must_be_drawn() || memory_.clutter.must_be_drawn();
    }
    /// From when on, besides, frames that must be drawn are a part of the one at `time`.
    [[nodiscard]] base::Time needed_since(base::Time time) const {
        return std::min(memory_.saliency.needed_since(time), memory_.clutter.needed_since(time));
    }
    /// The next update() does not follow the last one: the phase it is told has its design at once.
    void cut_to_design() { FramePlanner::cut(memory_); }
    /// Room to load the next scene into, by whoever reads files; it is empty, and stays whoever's it is until take_scene().
    [[nodiscard]] base::Arena& spare_scene_memory() { return planner_.data().spare(); }
    /// Takes over a scene that lies in that room, whole, with the next update(). False, and nothing changes, where it is no newer
    /// revision, or the display was started without a scene and expected none.
    [[nodiscard]] bool take_scene(const scene::Scene& scene);
    /// Replaces the own ship's eye with another one until cleared: the simulator's free camera.
    void set_free_view(const terrain::View& view) { planner_.set_free_view(view); }
    void clear_free_view() { planner_.clear_free_view(); }
    /// From the next update() on nothing is left out for being unseen: what the planner of effects saves can be measured.
    void force_effects(bool forced) { planner_.force_effects(forced); }

    /// Height above the terrain below a position; missing outside the database or over voids.
    [[nodiscard]] base::Stamped<double> height_above_terrain(const flight::OwnShipEstimate& own_ship, base::Time now) override {
        return planner_.height_above_terrain(own_ship, now);
    }

    /// What measured costs must be of to hold for this display: device, renderer and size of the picture.
    [[nodiscard]] effects::CalibrationSubject calibration_subject() const {
        const DisplaySettings& settings = planner_.settings();
        return {settings.device.name, painter_.gl().driver().renderer, settings.width_px, settings.height_px};
    }
    /// Holds no deadline until it is told one, with costs.
    [[nodiscard]] effects::FrameBudget& frame_budget() { return memory_.budget; }

    /// Of the planned frame.
    [[nodiscard]] const effects::FrameCounters& counters() const { return frame_.counters; }

    [[nodiscard]] const FrameRecord& record() const { return record_; }
    /// Where the obstacles on the way are in the frame that was drawn last: computed when it is asked for, and only then. None
    /// where no terrain or no data are shown.
    [[nodiscard]] ObstaclePlaces obstacles_ahead() { return planner_.obstacles_ahead(frame_, memory_); }
    [[nodiscard]] const base::BudgetTable& budget() { return planner_.settings().device.budget; }
    [[nodiscard]] gl::Gl& gl() { return painter_.gl(); }
    [[nodiscard]] const terrain::View& view() const { return frame_.camera.eye.view; }
    [[nodiscard]] const terrain::TerrainDatabase* terrain_database() const {
        return planner_.terrain().is_started() ? &planner_.terrain().database() : nullptr;
    }
    /// What stands on the ground stands here; after draw().
    [[nodiscard]] terrain::DrawnPoint drawn_ground(double latitude_rad, double longitude_rad) {
        TerrainPlanner& terrain = planner_.terrain();
        return terrain.is_started() ? terrain.drawn_point(latitude_rad, longitude_rad) : terrain::DrawnPoint{};
    }

private:
    [[nodiscard]] base::Error start_all(const TerrainInput& terrain, base::ByteSource* scene);
    [[nodiscard]] bool can_show(const design::DesignSettings& possible) const;
    void keep_scene();
    [[nodiscard]] draw::TerrainDrawResult paint_measured(base::Surface& surface);
    [[nodiscard]] draw::TerrainDrawResult paint(base::Surface& surface, PictureLayer last, bool is_unseen);
    [[nodiscard]] draw::TerrainDrawResult draw_scene(base::Surface& surface, PictureLayer last, bool is_unseen);
    [[nodiscard]] draw::TerrainDrawResult draw_side(const EyePair& pair, draw::EyeSide side, PictureLayer last);
    [[nodiscard]] draw::TerrainDrawResult draw_sides(base::Surface& surface, PictureLayer last);
    void measure_unseen(base::Surface& surface);
    void measure(base::Surface& surface, bool is_unseen);

    DisplayMemory arenas_;
    FramePlanner planner_;
    FramePainter painter_;
    PlannerMemory memory_;
    PlannedFrame frame_, scratch_;
    FrameRecord record_;
};

}  // namespace tedavis::display
