/// Decides what a frame shows, and why: design, view, terrain, data, labels and effects. No GL, no clock, no file, no heap after
/// start().
///
///   start(...) · each frame plan(input, memory, frame), plan_again(findings, memory, frame) while the painter reports findings,
///   and conclude(memory, frame) when it has been drawn
///
/// PlannerMemory is the only state of earlier frames that influences decisions: the same input and memory give the same frame if
/// the same chunks have arrived. The planner also keeps built geometry and chunks, which only saves time.
///
/// Memory    the arenas of the device's budget table, at start(). Thread  the display's. Failure  start() gives one message.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/design/phase_designs.hpp"
#include "render_core/display/planner/display_memory.hpp"
#include "render_core/display/planner/display_settings.hpp"
#include "render_core/display/planner/frame_context.hpp"
#include "render_core/display/planner/obstacle_places.hpp"
#include "render_core/display/planner/plan_pair.hpp"
#include "render_core/display/planner/planned_frame.hpp"
#include "render_core/display/planner/planner_memory.hpp"
#include "render_core/draw/data/data_variant.hpp"
#include "render_core/draw/eye_side.hpp"
#include "render_core/draw/quad_batch.hpp"
#include "render_core/flight/frame_input.hpp"
#include "render_core/flight/terrain_heights.hpp"
#include "render_core/policy/predicted_track.hpp"
#include "render_core/policy/terrain_ahead.hpp"

namespace tedavis::display {

/// The abilities of the painter on which planning depends. They do not change after start().
struct PainterAbilities {
    bool is_stereo = false;  ///< it draws a picture for each eye
    bool fades = false;      ///< it can keep a picture
    std::uint32_t stereo_margin_px = 0;
    std::uint32_t ground_side = 0;  ///< posts across and down of data on the ground; 0: none
    bool reads_pages = false;
    draw::TraceState tracer = draw::TraceState::not_asked_for;
};

class FramePlanner final : public flight::TerrainHeights {
public:
    /// Takes the designs, as the device can show them; to be called first. Returns one message if they cannot be shown.
    [[nodiscard]] base::Error take_designs(const DisplaySettings& settings, PlannerMemory& memory);
    /// Prepares a memory for what the designs request to measure; plan() needs a memory that was prepared.
    void start_memory(draw::DrawnDesigns designs, PlannerMemory& memory) const;
    /// Starts the terrain for the designs that a painter is started with.
    [[nodiscard]] base::Error start_terrain(const TerrainInput& terrain, draw::DrawnDesigns designs, const TerrainMemory& memory);
    [[nodiscard]] base::Error start_symbology(base::Arena& memory);
    /// Starts the memory in which decide_interval() plans; to be called before it.
    [[nodiscard]] base::Error start_intervals(base::Arena& frames, base::Arena& memories) {
        return interval_.start(frames, memories);
    }
    /// `scene`: a scene database, or null. To be called after start_terrain() and after the painter's own start.
    [[nodiscard]] base::Error start_scene(base::ByteSource* scene, const SpatialData::Memory& memory, std::uint32_t ground_side);
    /// `has_instances`: draw::GlyphDrawer::has_instances() of the device. To be called after start_scene(), where
    /// has_data_to_show().
    [[nodiscard]] base::Error start_elements(bool has_instances, const ElementPlanner::Memory& memory);
    /// Takes the abilities of the painter, and ends the start.
    void follow_painter(const PainterAbilities& painter, draw::DrawnDesigns designs);

    /// Plans the frame of this input. `memory` is the state after the previous frame, and is updated.
    void plan(const flight::FrameInput& input, PlannerMemory& memory, PlannedFrame& frame);
    /// Plans the frame again with what the painter has found: terrain that cannot be drawn, or the edges of the picture that
    /// `frame.clutter.probe` requested. The painter passes nothing else to the planner.
    void plan_again(const PainterFindings& findings, PlannerMemory& memory, PlannedFrame& frame);
    /// Decides only what is decided once for each interval (flight/decision_interval.hpp): labels, priorities and the terrain
    /// alert. `input`: at the interval's first instant, but with the phase of the frame before, whose design the next one shows.
    /// Changes nothing else of `memory`, which need not be the memory of the frames that are shown; a replay decides all
    /// intervals since the log's start, so that they are the same however a frame is reached.
    void decide_interval(const flight::FrameInput& input, PlannerMemory& memory);

    /// Returns the planned frame as one camera of a pair sees it.
    [[nodiscard]] PlannedPicture plan_side(const StereoCameras& pair, draw::EyeSide side, PlannerMemory& memory,
                                           PlannedFrame& frame);
    /// Concludes a frame that has been drawn: states how the clutter budget was held, and remembers that saliency was measured.
    void conclude(PlannerMemory& memory, PlannedFrame& frame);

    /// Replaces the designs by others, which the painter must be able to show.
    void set_designs(const design::DesignSettings& design, const design::PhaseDesigns* phases, PlannerMemory& memory);
    /// accepts() returns false where the scene is no newer revision, or none was expected; take_scene() then returns false and
    /// changes nothing.
    [[nodiscard]] bool accepts(const scene::Scene& scene) const;
    [[nodiscard]] bool take_scene(const scene::Scene& scene, PlannerMemory& memory);
    /// States that the painter has kept the planned picture, which fades out in the next frames.
    void keep_scene(const PlannedFrame& frame, PlannerMemory& memory) const;

    /// Replaces the own ship's camera with another one until cleared: the simulator's free camera.
    void set_free_view(const terrain::View& view) {
        free_view_ = view;
        free_view_active_ = true;
    }
    void clear_free_view() { free_view_active_ = false; }
    /// If forced, no effect is left out for being invisible from the next plan() on, so that what leaving out saves can be
    /// measured.
    void force_effects(bool forced) { effects_are_forced_ = forced; }

    [[nodiscard]] std::size_t design_count() const { return phases_.size() + 1; }
    [[nodiscard]] const design::DesignSettings& design_at(std::size_t place) const {
        return place == 0 ? design_ : phases_.at(place);
    }
    /// Returns the place of the design that a phase has now.
    [[nodiscard]] std::size_t place_of(flight::FlightPhase phase) const;
    [[nodiscard]] std::uint32_t stereo_margin_px(const design::DesignSettings& design) const;
    [[nodiscard]] bool has_data_to_show() const;
    [[nodiscard]] draw::DataVariant data_variant() const;
    /// Whether a design leaves the choice between triangles and rays to the display.
    [[nodiscard]] bool chooses_renderer() const;
    /// Whether anything is decided by intervals.
    [[nodiscard]] bool has_intervals() const { return has_intervals_; }
    /// Whether design transitions are cross-faded.
    [[nodiscard]] bool fades() const { return painter_.fades; }
    /// Returns the height of the own ship above the terrain; missing also outside the database and over voids.
    [[nodiscard]] base::Stamped<double> height_above_terrain(const flight::OwnShipEstimate& own_ship, base::Time now) override;
    /// Returns where the obstacles ahead are in a frame that has been drawn; they are computed only by this call. Empty where no
    /// terrain or no data are shown.
    [[nodiscard]] ObstaclePlaces obstacles_ahead(const PlannedFrame& frame, const PlannerMemory& memory);

    [[nodiscard]] DisplaySettings& settings() { return settings_; }
    [[nodiscard]] const DisplaySettings& settings() const { return settings_; }
    [[nodiscard]] const base::BudgetTable& budget() const { return settings_.device.budget; }
    [[nodiscard]] TerrainPlanner& terrain() { return terrain_; }
    [[nodiscard]] const TerrainPlanner& terrain() const { return terrain_; }
    /// Null without terrain.
    [[nodiscard]] const terrain::TerrainDatabase* terrain_database() const {
        return terrain_.is_started() ? &terrain_.database() : nullptr;
    }
    [[nodiscard]] SpatialData& data() { return data_; }
    [[nodiscard]] const ElementPlanner& elements() const { return elements_; }
    [[nodiscard]] const draw::QuadBatch& symbology() const { return symbology_; }
    /// The design that is shown: PlannedFrame::shown of a frame before the first plan.
    [[nodiscard]] const design::DesignSettings& look() const { return look_; }
    /// PlannedFrame::look_key of the design that painters are started with.
    [[nodiscard]] std::uint64_t look_key() const { return look_key_; }

private:
    class Boosts;
    /// What determines the look of the shown design.
    struct LookOf {
        std::size_t shown = 0;
        design::AspectWeights weights;
    };
    void begin(const flight::FrameInput& input, PlannerMemory& memory, PlannedFrame& frame);
    void end();
    void plan_without_terrain();
    void plan_measured();
    void plan_probe();
    // Designs
    void sync_look();
    void take_look(const LookOf& of);
    [[nodiscard]] LookOf asked_look() const { return {memory_->shown, memory_->weights}; }
    void fit_palettes();
    void show_design(std::size_t place);
    void follow_phase();
    void follow_foci();
    [[nodiscard]] bool has_warning() const;
    void begin_fade(base::Time now);
    [[nodiscard]] double next_fade_share();
    // Failure policy and priorities
    void begin_plan();
    [[nodiscard]] policy::TerrainSource terrain_source() const;
    [[nodiscard]] bool terrain_ends_ahead() const;
    void apply_priorities();
    void decide();
    void decide_again();
    void give_up_terrain(policy::TerrainSource reason);
    void state_frame();
    [[nodiscard]] policy::PredictedTrack track_of(const flight::OwnShipEstimate& own) const;
    // View
    void plan_view();
    void plan_foci();
    void magnify();
    void stop_magnifying();
    [[nodiscard]] bool is_map() const { return memory_->view.map_share() >= 1; }
    [[nodiscard]] bool is_near() const { return free_view_active_ || !is_map(); }
    [[nodiscard]] double undulation_m(const earth::Geodetic& place) const;
    // Terrain, data, symbology, effects
    void plan_terrain();
    [[nodiscard]] effects::RendererDecision choose_renderer(const TerrainPlan& plan);
    [[nodiscard]] effects::TriangleFit fit_of(const TerrainPlan& plan) const;
    [[nodiscard]] bool is_to_be_removed(const TerrainPlan& plan) const;
    [[nodiscard]] double megapixels() const { return settings_.width_px * 1e-6 * settings_.height_px; }
    [[nodiscard]] double turn_radps() const;
    [[nodiscard]] design::HeightAccuracy height_accuracy() const;
    [[nodiscard]] policy::TrackUncertainty track_uncertainty() const;
    [[nodiscard]] policy::PriorityInstant priority_instant() const;
    [[nodiscard]] policy::TerrainWatchInput watched(const policy::PriorityInstant& instant) const;
    void plan_alert_zone();
    void state_alerts();
    void widen_bands();
    void plan_data();
    void set_elements(std::size_t shown);
    void find_intervals();
    void decide_labels();
    void plan_elements();
    void plan_detail_again(bool is_shown);
    void plan_signs(const Camera& camera, SignFrame signs);
    void state_labels();
    void state_stale_data();
    void state_stale_source(const scene::Layer& source, const scene::AttributeEntry& made, double stale_after_s);
    [[nodiscard]] bool data_are_stale(const flight::FlightTime& time) const;
    [[nodiscard]] bool is_in_design(const scene::Layer& layer) const;
    [[nodiscard]] ElementFrame element_frame(scene::Ground& ground, const terrain::View& view) const;
    [[nodiscard]] bool shows_elements() const { return elements_.is_started() && frame_->decisions.show_terrain; }
    void put_symbology();
    void plan_declutter();
    [[nodiscard]] bool shows_measure() const;
    [[nodiscard]] bool has_declutterable_data() const;
    void plan_effects();
    void state_view(effects::EffectFacts& facts);
    void state_data(effects::EffectFacts& facts);
    [[nodiscard]] ShadowPlan plan_shadows();
    [[nodiscard]] effects::EffectSet asked() const;
    void count();
    void set_camera();
    void set_camera_data();
    [[nodiscard]] effects::TerrainTolerance terrain_tolerance() const {
        return {look_.terrain.tau_px, look_.degradation.terrain_error_px};
    }

    DisplaySettings settings_;
    PainterAbilities painter_;
    design::DesignSettings design_;                              ///< as the device can show it; where no phase has another
    design::PhaseDesigns phases_;                                ///< likewise
    effects::EffectSet asked_of_[design::kMaxPhaseDesigns + 1];  ///< by designs as they were handed over

    design::DesignSettings look_;  ///< the shown design at the frame's weights
    LookOf look_of_;
    std::uint64_t look_key_ = 1, terrain_look_key_ = 0;
    bool draws_foci_ = false;     ///< in the look that painters were told last
    double band_deviations_ = 0;  ///< of the look's coverage

    TerrainPlanner terrain_;
    SpatialData data_;
    ElementPlanner elements_;
    draw::QuadBatch symbology_;
    bool has_intervals_ = false;  ///< there is terrain, or some design has labels or weights
    terrain::View free_view_;
    bool free_view_active_ = false;
    bool effects_are_forced_ = false;

    double unmagnified_near_m_ = 0, unmagnified_far_m_ = 0;  ///< planes of a view with magnifiers before they made room
    PlanPair interval_;                                      ///< of decide_interval(); it keeps no state between calls
    PlannerMemory* memory_ = nullptr;                        ///< while planning
    PlannedFrame* frame_ = nullptr;                          ///< likewise
};

}  // namespace tedavis::display
