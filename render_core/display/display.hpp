/// The face of the core: aircraft state in, pixels and a FrameRecord out.
///
///   start(settings, memory, surface, terrain) · update(state, phase, now) · draw(surface) · stop()
///
/// Memory    everything from the arena and the GPU lines of the device's budget table, at start(); nothing later.
/// Thread    one, on which the surface is current. Time comes from the source with update(); no clock is read.
/// Failure   start() gives one sentence. Later faults of data remove what is not trustworthy, flag it and keep running.
#pragma once

#include <algorithm>

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/ports/surface.hpp"
#include "render_core/design/phase_designs.hpp"
#include "render_core/display/clutter_control.hpp"
#include "render_core/display/display_memory.hpp"
#include "render_core/display/draw_inputs.hpp"
#include "render_core/display/element_painter.hpp"
#include "render_core/display/eye.hpp"
#include "render_core/display/eye_pair.hpp"
#include "render_core/display/foci_plan.hpp"
#include "render_core/display/frame_record.hpp"
#include "render_core/display/obstacle_places.hpp"
#include "render_core/display/saliency_view.hpp"
#include "render_core/display/scene_passes.hpp"
#include "render_core/display/spatial_data.hpp"
#include "render_core/display/symbology_data.hpp"
#include "render_core/display/terrain_painter.hpp"
#include "render_core/display/view_transition.hpp"
#include "render_core/draw/dimmer.hpp"
#include "render_core/draw/quad_drawer.hpp"
#include "render_core/draw/scene_fade.hpp"
#include "render_core/draw/symbology/symbology_input.hpp"
#include "render_core/effects/calibration.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/effects/frame_budget.hpp"
#include "render_core/gl/gl.hpp"
#include "render_core/policy/failure_policy.hpp"
#include "render_core/policy/panel_lighting.hpp"
#include "render_core/policy/priority_boost.hpp"

namespace tedavis::display {

struct DisplaySettings {
    effects::DeviceSettings device;
    design::DesignSettings design;                 ///< where no phase has another
    const design::PhaseDesigns* phases = nullptr;  ///< null: none has; copied at start()
    std::uint32_t width_px = 0, height_px = 0;
    bool generated_flight = false;           ///< said on the display
    bool expects_scene = false;              ///< one may come later, by take_scene()
    bool terrain_failed_at_start = false;    ///< there should be terrain, and start() is given none: said as a failure
    base::ProgramStore* programs = nullptr;  ///< of a device without a compiler, or to be filled; must outlive start()
};

/// What an epoch leaves to the next one. Plain data.
struct EpochMemory {
    LabelEpoch labels;
    policy::PriorityBoost weights;
};

class Display {
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

    /// Plans the frame for `now`. Pure planning: no GL. `way`: null where nobody keeps it.
    /// It must stay until the frame is drawn.
    void update(const flight::AircraftState& state, const flight::PhaseStatus& phase, base::Time now,
                const flight::FlownWay* way = nullptr);
    /// Plans like update(), but counts no frame and need not be drawn: what lies before the first frame that is shown.
    void approach(const flight::AircraftState& state, const flight::PhaseStatus& phase, base::Time now,
                  const flight::FlownWay* way = nullptr);
    /// Decides the weights and labels of an epoch (raised_weights.hpp, element_labels.hpp) that begins at `now`, and plans
    /// nothing else: what a replay does for every epoch from the log's start on, so that they are the same however a frame is
    /// reached. `phase`: of the frame before that instant, whose design the next frame shows.
    void approach_epoch(const flight::AircraftState& state, const flight::PhaseStatus& phase, base::Time now);
    /// Whether an epoch leaves anything to the next one.
    [[nodiscard]] bool has_epochs() const { return has_epochs_; }
    [[nodiscard]] EpochMemory epoch() const;
    void restore(const EpochMemory& memory);
    /// What was decided for the epoch has been decided anew, for another design or elsewhere: the next one follows from the
    /// former.
    [[nodiscard]] bool epoch_is_anew() const { return raised_.is_anew() || elements_.labels().is_anew(); }
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
    [[nodiscard]] bool fades() const { return fade_.is_started(); }
    /// True where a later frame shows the planned one again: it must be drawn, even if nobody looks at it.
    [[nodiscard]] bool must_be_drawn() const {
        return turn_ == Turn::keeps || saliency_.must_be_drawn() || clutter_.must_be_drawn();
    }
    /// From when on, besides, frames that must be drawn are a part of the one at `time`.
    [[nodiscard]] base::Time needed_since(base::Time time) const {
        return std::min(saliency_.needed_since(time), clutter_.needed_since(time));
    }
    /// The next update() does not follow the last one: the phase it is told has its design at once.
    void forget_turns() {
        turn_ = Turn::none;
        is_new_to_phases_ = true;
        saliency_.forget();
        clutter_.forget();
    }
    /// Room to load the next scene into, by whoever reads files; it is empty, and stays whoever's it is until take_scene().
    [[nodiscard]] base::Arena& spare_scene_memory() { return data_.spare(); }
    /// Takes over a scene that lies in that room, whole, with the next update(). False, and nothing changes, where it is no newer
    /// revision, or the display was started without a scene and expected none.
    [[nodiscard]] bool take_scene(const scene::Scene& scene);
    /// Replaces the own ship's eye with another one until cleared: the simulator's free camera.
    void set_free_view(const terrain::View& view) {
        free_view_ = view;
        free_view_active_ = true;
    }
    void clear_free_view() { free_view_active_ = false; }
    /// From the next update() on nothing is left out for being unseen: what the planner of effects saves can be measured.
    void force_effects(bool forced) { effects_are_forced_ = forced; }

    /// Height above the terrain below a position; missing outside the database or over voids.
    [[nodiscard]] base::Stamped<double> height_above_terrain(const flight::OwnShipEstimate& own_ship, base::Time now);

    /// Of this display; costs measured for another subject say nothing of it.
    [[nodiscard]] effects::CalibrationSubject calibration_subject() const {
        return {settings_.device.name, gl_.driver().renderer, settings_.width_px, settings_.height_px};
    }
    /// Holds no deadline until it is told one, with costs.
    [[nodiscard]] effects::FrameBudget& frame_budget() { return frame_budget_; }

    /// Of the planned frame.
    [[nodiscard]] const effects::FrameCounters& counters() const { return counters_; }

    [[nodiscard]] const FrameRecord& record() const { return record_; }
    /// Where the obstacles on the way are in the frame that was drawn last: computed when it is asked for, and only then. None
    /// where no terrain or no data are shown.
    [[nodiscard]] ObstaclePlaces obstacles_ahead();
    [[nodiscard]] const base::BudgetTable& budget() const { return settings_.device.budget; }
    [[nodiscard]] gl::Gl& gl() { return gl_; }
    [[nodiscard]] const terrain::View& view() const { return eye_.view; }
    [[nodiscard]] const terrain::TerrainDatabase* terrain_database() const {
        return terrain_.is_started() ? &terrain_.database() : nullptr;
    }
    /// What stands on the ground stands here; after draw().
    [[nodiscard]] terrain::DrawnPoint drawn_ground(double latitude_rad, double longitude_rad) {
        return terrain_.is_started() ? terrain_.drawn_point(latitude_rad, longitude_rad) : terrain::DrawnPoint{};
    }

private:
    /// To the design of another phase: one frame is drawn as it was, and kept; the next is drawn anew.
    enum class Turn : std::uint8_t { none, keeps };

    [[nodiscard]] std::uint32_t stereo_margin_px(const design::DesignSettings& design) const;
    [[nodiscard]] base::Error take_designs(const DisplaySettings& settings);
    [[nodiscard]] const design::DesignSettings& design_at(std::size_t place) const {
        return place == 0 ? design_ : phases_.at(place);
    }
    [[nodiscard]] draw::DrawnDesign drawn_design(const design::DesignSettings& design, bool has_focus) const;
    void follow_foci();
    [[nodiscard]] bool can_show(const design::DesignSettings& possible) const;
    void follow_phase(const flight::PhaseStatus& phase, base::Time now);
    void show_design(std::size_t place);
    [[nodiscard]] base::Error start_drawers(draw::DrawnDesigns designs);
    [[nodiscard]] base::Error start_drawing(const TerrainInput& terrain);
    [[nodiscard]] base::Error start_data(base::ByteSource* scene);
    [[nodiscard]] policy::TerrainSource terrain_source(const flight::OwnShipEstimate& own_ship);
    void begin_update(const flight::AircraftState& state, const flight::PhaseStatus& phase, base::Time now);
    void decide(base::Time now);
    void weigh(base::Time now);
    void take_weights();
    void show_look();
    class Raises;
    void note_epochs();
    [[nodiscard]] policy::PredictedTrack track_of(const flight::OwnShipEstimate& own) const;
    [[nodiscard]] bool data_are_stale(const flight::FlightTime& time) const;
    [[nodiscard]] bool is_in_design(const scene::Layer& layer) const;
    void note_stale_data();
    void note_stale_source(const scene::Layer& source, const scene::AttributeEntry& made, double stale_after_s);
    [[nodiscard]] effects::EffectSet asked() const;
    void decide_labels();
    [[nodiscard]] bool is_map() const { return transition_.map_share() >= 1; }
    void plan_view();
    void magnify();
    void stop_magnifying();
    void keep_scene();
    [[nodiscard]] bool has_warning() const;
    draw::TerrainDrawResult draw_kept();
    void begin_fade(base::Time now);
    [[nodiscard]] double next_fade_share();
    [[nodiscard]] double undulation_m(const earth::Geodetic& place) const;
    void plan_foci();
    void plan_terrain();
    void plan_data();
    void plan_elements(const flight::FlownWay* way);
    void plan_effects();
    [[nodiscard]] bool shows_measure() const;
    void plan_crowding();
    [[nodiscard]] bool has_what_gives_way() const;
    void plan_detail_again(bool is_shown);
    void show_measured();
    void note_labels();
    draw::TerrainDrawResult paint_measured(base::Surface& surface);
    void measure_unseen(base::Surface& surface);
    void measure(base::Surface& surface);
    void note_clutter();
    [[nodiscard]] ShadowPlan plan_shadows();
    void count();
    void widen_bands();
    void begin_record(base::Time now);
    void give_up_terrain(policy::TerrainSource reason);
    void decide_again();
    [[nodiscard]] bool is_near() const { return free_view_active_ || !is_map(); }
    void set_elements();
    [[nodiscard]] DrawContext context() const { return context_of(eye_); }
    [[nodiscard]] DrawContext context_of(const Eye& eye) const;
    [[nodiscard]] ElementFrame element_frame(scene::Ground& ground, const terrain::View& view, const flight::FlownWay* way) const;
    draw::TerrainDrawResult draw_passes(const gl::DrawPlace& place, const Eye& eye, bool has_shadow_map = false);
    void prepare_elements();
    [[nodiscard]] bool shows_elements() const { return elements_.is_started() && decisions_.show_terrain; }
    void plan_signs(const Eye& eye, SignFrame signs);
    [[nodiscard]] draw::TerrainDrawResult paint(base::Surface& surface);
    [[nodiscard]] draw::TerrainDrawResult draw_scene(base::Surface& surface);
    [[nodiscard]] draw::TerrainDrawResult draw_eye(const EyePair& pair, draw::EyeSide side);
    [[nodiscard]] draw::TerrainDrawResult draw_eyes(base::Surface& surface);
    void draw_symbology(base::Surface& surface);
    [[nodiscard]] effects::TerrainTolerance terrain_tolerance() const {
        return {settings_.design.terrain.tau_px, settings_.design.degradation.terrain_error_px};
    }
    void put_symbology();

    DisplaySettings settings_;                                   ///< its design is the one that is shown
    design::DesignSettings design_;                              ///< as the device can show it; where no phase has another
    design::PhaseDesigns phases_;                                ///< likewise
    design::AspectWeights weights_;                              ///< of the shown design, in the planned frame
    bool shows_alert_ = false;                                   ///< terrain is ahead: the shown design has warning colours
    bool has_new_look_ = false;                                  ///< they have changed since the drawers were told
    effects::EffectSet asked_of_[design::kMaxPhaseDesigns + 1];  ///< by designs as they were handed over
    std::size_t shown_ = 0, turns_to_ = 0;                       ///< places of designs
    std::size_t chosen_foci_ = 0;                                ///< the first ones of every design
    Turn turn_ = Turn::none;
    base::Time turns_at_{0};  ///< with it
    bool is_new_to_phases_ = true;
    gl::Gl gl_;
    DisplayMemory memory_;
    TerrainPlanner terrain_;
    TerrainPainter terrain_painter_;
    SpatialData data_;
    SpatialDataPlan data_plan_;
    MapsBeside maps_beside_;
    ElementPlanner elements_;
    ElementPainter element_painter_;
    bool has_epochs_ = false;  ///< there is terrain, or some design has labels or weights
    policy::PriorityBoost raised_;
    FociPlan foci_;            ///< of the planned frame
    bool draws_foci_ = false;  ///< with what they change of the ground
    ClutterControl clutter_;
    policy::Declutter crowding_;  ///< of the planned frame
    bool is_unseen_ = false;      ///< what is drawn now, for the clutter to be measured
    ScenePasses passes_;
    draw::StereoPass stereo_;
    draw::SceneFade fade_;
    terrain::View kept_view_;   ///< of the scene as it was
    bool fades_next_ = false;   ///< from the next update() on
    base::Time fade_began_{0};  ///< with fade_lasts_
    bool fade_lasts_ = false;
    double fade_share_ = 0;  ///< of the planned frame
    SaliencyView saliency_;
    draw::Dimmer dimmer_;
    policy::PanelLight panel_;
    draw::QuadBatch symbology_;
    draw::QuadDrawer quad_drawer_;
    bool terrain_failed_ = false;
    effects::FrameBudget frame_budget_;
    effects::FrameCounters counters_;
    effects::FramePlan plan_;
    EffectWorkTable work_;  ///< of the frame that was drawn last
    PictureLayer last_layer_ = PictureLayer::symbology;
    draw::FocusRange focus_;
    ShadowPlan shadows_;
    bool effects_are_forced_ = false;
    double band_deviations_ = 0;  ///< of the design's coverage

    flight::AircraftState state_;  ///< of the planned frame
    policy::DisplayConditions conditions_;
    policy::DisplayDecisions decisions_;
    ViewTransition transition_;
    Eye eye_;
    terrain::View seen_;  ///< all that is drawn of the frame: eye_'s, or as wide as a picture for each eye
    EyePair eyes_;
    double unmagnified_near_m_ = 0, unmagnified_far_m_ = 0;  ///< planes of an eye with magnifiers before they made room
    const flight::FlownWay* way_ = nullptr;                  ///< of the planned frame, until it is drawn
    terrain::View free_view_;
    bool free_view_active_ = false;
    bool terrain_has_void_ = false;
    double aircraft_msl_m_ = 0;
    double eye_msl_m_ = 0;
    std::uint64_t frame_ = 0;
    FrameRecord record_;
};

}  // namespace tedavis::display
