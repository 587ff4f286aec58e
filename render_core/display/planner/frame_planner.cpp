#include "render_core/display/planner/frame_planner.hpp"

#include <cmath>

#include "render_core/base/budget_shortage.hpp"
#include "render_core/base/units.hpp"
#include "render_core/display/planner/data_legends.hpp"
#include "render_core/display/planner/frame_notes.hpp"
#include "render_core/display/planner/symbology_plan.hpp"
#include "render_core/display/planner/terrain_ground.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/effects/design_effects.hpp"

namespace tedavis::display {

using flight::Signal;

base::Error FramePlanner::start_terrain(const TerrainInput& terrain, draw::DrawnDesigns designs, const TerrainMemory& memory) {
    if (terrain.file == nullptr) return {};
    if (base::Error error = terrain_.start(terrain, designs, settings_.device, memory)) return error;
    fit_palettes();
    take_look(asked_look());
    return {};
}

base::Error FramePlanner::start_symbology(base::Arena& memory) {
    if (symbology_.start(memory, draw::kSymbologyVertices)) return {};
    return base::shortage_error(effects::kSymbology, memory);
}

base::Error FramePlanner::start_scene(base::ByteSource* scene, const SpatialData::Memory& memory, std::uint32_t ground_side) {
    return data_.start(scene, memory, ground_side);
}

bool FramePlanner::has_data_to_show() const {
    bool has_data = data_.has_scene() || settings_.expects_scene;
    for (std::size_t place = 0; place < design_count(); ++place) {
        const design::DesignSettings& design = design_at(place);
        has_data =
            has_data || !design.foci.empty() || asks_for_own(design.data.elements) || asks_for_traffic(design.data.elements);
    }
    return has_data && terrain_.is_started();
}

draw::DataVariant FramePlanner::data_variant() const {
    draw::DataVariant variant{design_.sky.air.is_shown};
    for (std::size_t place = 0; place < design_count(); ++place) {
        const design::DesignSettings& design = design_at(place);
        variant.grid = variant.grid || has_grid_on_data(design);
        variant.shadows = variant.shadows || design.effects.shadows.is_any();
        variant.magnified = variant.magnified || design::magnifies(design);
    }
    return variant;
}

base::Error FramePlanner::start_elements(bool has_instances, const ElementPlanner::Memory& memory) {
    set_elements(0);
    return elements_.start(has_instances, settings_.device.budget, memory);
}

void FramePlanner::start_memory(draw::DrawnDesigns designs, PlannerMemory& memory) const {
    bool shows_saliency = false;
    for (const draw::DrawnDesign& drawn : designs)
        shows_saliency = shows_saliency || drawn.design->effects.saliency.view != design::SaliencyView::none;
    memory.saliency.start(settings_.device.capability.lane, shows_saliency);
    memory.clutter.start(settings_.device.capability.lane, designs);
}

void FramePlanner::follow_painter(const PainterAbilities& painter, draw::DrawnDesigns designs) {
    painter_ = painter;
    if (terrain_.is_started()) terrain_.follow_painter(painter.reads_pages, painter.tracer);
    terrain_.set_design(designs[0]);
    terrain_look_key_ = look_key_;
    find_intervals();
}

void FramePlanner::plan(const flight::FrameInput& input, PlannerMemory& memory, PlannedFrame& frame) {
    begin(input, memory, frame);
    frame.frame = memory.frames++;
    follow_phase();
    begin_plan();
    plan_declutter();
    follow_foci();
    plan_terrain();
    plan_data();
    plan_elements();
    plan_effects();
    end();
    plan_probe();
}

void FramePlanner::plan_again(const PainterFindings& findings, PlannerMemory& memory, PlannedFrame& frame) {
    memory_ = &memory;
    frame_ = &frame;
    if (findings.terrain_failed) {
        plan_without_terrain();
    } else {
        memory.clutter.take(findings.edges);
        // Shadows on it are those of data, which differ from probe to probe.
        frame.clutter.has_terrain = !frame.effects.runs(effects::Effect::soft_shadows);
        if (memory.clutter.step() == DeclutterControl::Step::none) return plan_measured();
    }
    plan_probe();
}

void FramePlanner::begin(const flight::FrameInput& input, PlannerMemory& memory, PlannedFrame& frame) {
    memory_ = &memory;
    frame_ = &frame;
    frame = PlannedFrame{};
    frame.state = input.state;
    frame.time = input.time;
    frame.phase = input.phase;
    frame.trail = input.trail;
    frame.legend.show = input.legend.value_or(settings_.legend);
    sync_look();
    if (elements_.is_started()) elements_.labels().restore(memory.labels);
}

void FramePlanner::end() {
    memory_->had_warning = has_warning();
    frame_->keeps_scene = memory_->transition.keeps;
    if (frame_->keeps_scene) memory_->transition.kept_view = frame_->picture.camera.view;
    frame_->weights = memory_->weights;
    frame_->budget = memory_->budget.report();
    set_camera();
    if (elements_.is_started()) elements_.labels().keep(memory_->labels);
}

void FramePlanner::set_camera() {
    frame_->look_key = look_key_;
    frame_->picture.terrain = terrain_.seen_from(frame_->picture.camera.view);
    set_camera_data();
}

void FramePlanner::set_camera_data() {
    frame_->picture.data = elements_.planned();
    frame_->picture.casters = elements_.casters(look_.effects.shadows.casters);
}

void FramePlanner::plan_without_terrain() {
    memory_->terrain_failed = true;
    if (frame_->clutter.probe != Probe::none) frame_->declutter = frame_->clutter.before_probes;
    frame_->clutter = {};
    give_up_terrain(policy::TerrainSource::failed);
    frame_->labels = {};
    put_symbology();
    plan_effects();
    end();
}

/// Another phase's design may be used for decisions; the look that painters have taken remains.
void FramePlanner::decide_interval(const flight::FrameInput& input, PlannerMemory& memory) {
    const LookOf look = look_of_;
    const std::uint64_t look_key = look_key_;
    PlannerMemory& passing = *interval_.memory;
    passing = memory;
    passing.weights = look.weights;  // what the design looks like now is the least work to begin from
    passing.shown = phases_.place_of(input.phase.presented);
    passing.view = ViewTransition();
    begin(input, passing, *interval_.frame);
    begin_plan();
    if (elements_.is_started()) elements_.labels().keep(memory.labels);
    memory.boost = passing.boost;
    if (look_key_ != look_key) take_look(look);
    look_key_ = look_key;
}

/// Plans the camera and what may be shown: everything that does not depend on which terrain has arrived.
void FramePlanner::begin_plan() {
    const flight::AircraftState& state = frame_->state;
    frame_->flight_time = flight::flight_time(state.utc, frame_->time);
    frame_->conditions = {};
    frame_->conditions.terrain = terrain_source();
    frame_->conditions.phase = frame_->phase;
    frame_->conditions.generated_flight = settings_.generated_flight;
    frame_->conditions.databases = policy::currency_of(settings_.database_dates, frame_->flight_time);
    const DrapeState drape = terrain_.drape(look_.terrain.style);
    frame_->conditions.image_is_missing = drape == DrapeState::not_in_database || drape == DrapeState::not_on_device;
    if (frame_->conditions.terrain == policy::TerrainSource::ready &&
        state.is_valid(Signal::height_above_terrain, frame_->time) && state[Signal::height_above_terrain].value_or(0) < 0)
        frame_->conditions.terrain = policy::TerrainSource::above_own_ship;
    frame_->conditions.terrain_ends = terrain_ends_ahead();
    frame_->conditions.shows_measure = shows_measure();
    frame_->conditions.is_reduced = look_.degradation.show_reduced && memory_->budget.is_reduced();
    apply_priorities();
    memory_->view.step(look_.view.mode, look_.view.transition_s, frame_->time);
    decide();
    state_frame();
    plan_view();
    plan_foci();
    magnify();
    decide_labels();
}

policy::TerrainSource FramePlanner::terrain_source() const {
    const flight::OwnShipEstimate& own_ship = frame_->state.own_ship;
    if (!terrain_.is_started())
        return settings_.terrain_failed_at_start ? policy::TerrainSource::failed : policy::TerrainSource::none;
    if (memory_->terrain_failed) return policy::TerrainSource::failed;
    const bool inside =
        terrain_.database().lattice().point(own_ship.position.latitude_rad, own_ship.position.longitude_rad).inside;
    return inside || own_ship.state == base::SignalState::missing ? policy::TerrainSource::ready : policy::TerrainSource::outside;
}

/// Beyond the database there can be no terrain alert. The turn of the track may end at any time, so the straight track is checked
/// as well.
bool FramePlanner::terrain_ends_ahead() const {
    constexpr int kPlaces = 4;
    const flight::OwnShipEstimate& own = frame_->state.own_ship;
    if (frame_->conditions.terrain != policy::TerrainSource::ready || own.state != base::SignalState::valid) return false;
    policy::PredictedTrack track = track_of(own);
    if (track.ground_speed_mps() < policy::TerrainWatch::kSlowest_mps) return false;
    const auto leaves = [&](double turn_radps) {
        track.turn_radps = turn_radps;
        for (int n = 1; n <= kPlaces; ++n) {
            const earth::Geodetic at = track.at(policy::TerrainWatch::kLookAhead_s * n / kPlaces);
            if (!terrain_.database().lattice().point(at.latitude_rad, at.longitude_rad).inside) return true;
        }
        return false;
    };
    return leaves(0) || leaves(turn_radps());
}

void FramePlanner::decide() {
    frame_->conditions.is_map = is_map();
    frame_->decisions = policy::decide_display(frame_->state, frame_->time, frame_->conditions, look_);
    // During the transition between 3D and the map the rules of 3D apply; without terrain there is no transition.
    if (!memory_->view.is_under_way() || frame_->decisions.show_terrain) return;
    memory_->view.arrive();
    frame_->conditions.is_map = is_map();
    frame_->decisions = policy::decide_display(frame_->state, frame_->time, frame_->conditions, look_);
}

/// Handles terrain that turns out to be unavailable: the notice must be in this frame already.
void FramePlanner::give_up_terrain(policy::TerrainSource reason) {
    frame_->conditions.terrain = reason;
    frame_->alert_zone = {};
    decide_again();
}

void FramePlanner::decide_again() {
    frame_->decisions = policy::decide_display(frame_->state, frame_->time, frame_->conditions, look_);
    for (const auto& name : frame_->decisions.flags) flag(name.view(), *frame_);
    state_alerts();
}

void FramePlanner::state_frame() {
    frame_->own_ship = frame_->state.own_ship;
    frame_->heading_rad = draw::view_heading_rad(frame_->state, frame_->decisions);
    frame_->pitch_rad = frame_->state[Signal::pitch].value_or(0);
    frame_->roll_rad = frame_->state[Signal::roll].value_or(0);
    frame_->view.mode = look_.view.mode;
    const bool is_far = frame_->view.mode != design::ViewMode::perspective;
    frame_->view.transition = is_far ? memory_->view.map_share() : 1 - memory_->view.map_share();
    for (std::size_t n = 0; n < flight::kSignalCount; ++n)
        frame_->signals[n] = frame_->state.state_of(static_cast<Signal>(n), frame_->time);
    frame_->scene_revision = data_.has_scene() ? data_.scene().header().revision : 0;
    if (frame_->state.utc.state == base::SignalState::lost) flag(policy::RecordFlag::utc_lost, *frame_);
    frame_->light = policy::terrain_light(look_.terrain.style.shade, frame_->state.own_ship.position, frame_->flight_time.utc);
    frame_->symbology_light = settings_.light;
    for (const auto& name : frame_->decisions.flags) flag(name.view(), *frame_);
    state_alerts();
}

base::Stamped<double> FramePlanner::height_above_terrain(const flight::OwnShipEstimate& own_ship, base::Time now) {
    if (!terrain_.is_started() || own_ship.state != base::SignalState::valid) return {};
    const terrain::HeightAnswer ground = terrain_.true_height(own_ship.position.latitude_rad, own_ship.position.longitude_rad);
    if (ground.status != terrain::HeightStatus::land && ground.status != terrain::HeightStatus::sea) return {};
    const double undulation = own_ship.height_is_geometric ? ground.undulation.m : 0;
    const auto quality = own_ship.height_is_geometric ? base::Quality::good : base::Quality::degraded;
    return {own_ship.position.height.m - undulation - ground.height.m, now, quality};
}

double FramePlanner::undulation_m(const earth::Geodetic& place) const {
    return terrain_.is_started() ? terrain_.database().undulation(place.latitude_rad, place.longitude_rad).m : 0;
}

bool FramePlanner::is_to_be_removed(const TerrainPlan& plan) const {
    return plan.pending != 0 && plan.lod.worst_waiting_px > look_.degradation.terrain_removed_px;
}

effects::TriangleFit FramePlanner::fit_of(const TerrainPlan& plan) const {
    if (is_to_be_removed(plan)) return effects::TriangleFit::none;
    const bool is_coarse = plan.lod.worst_coarse_px > look_.degradation.terrain_error_px;
    return plan.is_short || is_coarse ? effects::TriangleFit::is_short : effects::TriangleFit::exact_enough;
}

/// Chooses the renderer where the design leaves the choice to the display, and has triangles drawn where they are chosen.
effects::RendererDecision FramePlanner::choose_renderer(const TerrainPlan& plan) {
    effects::FrameBudget& budget = memory_->budget;
    if (look_.terrain.renderer != design::TerrainRenderer::automatic || !terrain_.is_traced()) {
        budget.rest_renderer(frame_->time);
        return {};
    }
    effects::FrameCounters counters;
    counters.megapixels = megapixels();
    counters.triangles = plan.lod.triangles;
    const effects::RendererDecision decision =
        budget.choose_renderer(frame_->time, memory_->shown, counters, terrain_tolerance(), fit_of(plan));
    if (!decision.by_rays) terrain_.draw_triangles();
    return decision;
}

void FramePlanner::plan_terrain() {
    const double tau_factor = memory_->budget.tau_factor(terrain_tolerance());
    frame_->terrain.tau_px = look_.terrain.tau_px * tau_factor;
    Camera seen = frame_->picture.camera;
    seen.view = frame_->seen;
    if (!frame_->decisions.show_terrain) {
        memory_->budget.rest_renderer(frame_->time);
        const bool is_outside = frame_->conditions.terrain == policy::TerrainSource::outside &&
                                frame_->state.own_ship.state == base::SignalState::valid;
        return is_outside ? terrain_.approach(seen, look_, tau_factor) : terrain_.rest();
    }
    widen_bands();
    plan_alert_zone();
    TerrainPlan plan = terrain_.plan(seen, look_, tau_factor);
    if (plan.is_unmagnified) stop_magnifying();
    if (frame_->stereo_cameras.base_m > 0)
        for (const draw::EyeSide side : draw::kEyeSides)
            terrain_.widen_error(camera_of(frame_->picture.camera, frame_->stereo_cameras, side, painter_.stereo_margin_px).view,
                                 look_, plan.lod);
    const effects::RendererDecision decision = choose_renderer(plan);
    if (terrain_.is_traced()) plan = as_traced(plan, terrain_.shades_chunks());
    if (!plan.lod.within_budget) {
        give_up_terrain(policy::TerrainSource::over_budget);
        return;
    }
    frame_->terrain_has_void = plan.has_void;
    record_terrain(plan, *frame_);
    record_renderer(look_.terrain.renderer, terrain_.trace_state(), decision, *frame_);
    // Terrain within the budgets will not get better, and is stated as coarse.
    if (is_to_be_removed(plan)) {
        give_up_terrain(policy::TerrainSource::too_coarse);
        return;
    }
    if (plan.lod.worst_coarse_px <= look_.degradation.terrain_error_px) return;
    frame_->conditions.terrain_is_coarse = true;
    decide_again();
}

design::HeightAccuracy FramePlanner::height_accuracy() const {
    design::HeightAccuracy accuracy;
    if (frame_->state.is_valid(Signal::vertical_accuracy, frame_->time))
        accuracy.position_m = frame_->state[Signal::vertical_accuracy].value_or(0);
    accuracy.terrain_m = static_cast<double>(terrain_.database().header().le90_m);
    return accuracy;
}

void FramePlanner::widen_bands() {
    if (!frame_->decisions.show_warning_colors) return;
    frame_->bands = design::band_widening(look_.widening, band_deviations_, height_accuracy());
    if (frame_->bands.position_assumed) flag(policy::RecordFlag::vertical_accuracy_assumed, *frame_);
    if (frame_->bands.terrain_assumed) flag(policy::RecordFlag::terrain_accuracy_assumed, *frame_);
}

void FramePlanner::put_symbology() {
    frame_->maps_beside = {};
    if (free_view_active_) return;
    const draw::SymbolGround over = memory_->view.is_under_way() ? draw::SymbolGround::moving
                                    : frame_->conditions.is_map  ? draw::SymbolGround::map
                                                                 : draw::SymbolGround::perspective;
    const FrameContext frame = context_of(*frame_, frame_->picture.camera);
    frame_->maps_beside =
        plan_symbology({frame, frame_->state, settings_.aircraft, settings_.symbology.of(settings_.light), settings_.width_px,
                        settings_.height_px, over, data_, frame_->data, elements_.reports(), frame_->legend.show},
                       symbology_, *frame_);
}

void FramePlanner::plan_data() {
    frame_->data = data_.plan(look_.data, frame_->flight_time);
    frame_->ground_key = data_.ground_key();
    frame_->ground_slice = data_.ground();
    if (frame_->data.ground == GroundDataState::not_asked_for) return;
    if (frame_->data.ground != GroundDataState::shown) flag(policy::RecordFlag::ground_data_missing, *frame_);
    if (!frame_->flight_time.is_date) flag(policy::RecordFlag::ground_data_no_date, *frame_);
    const scene::GridSlice* const slice = data_.ground();
    if (slice != nullptr && is_in_another_unit(look_.data.ground.scale.palette, *slice->attribute()->entry))
        flag(policy::RecordFlag::ground_data_unit, *frame_);
}

}  // namespace tedavis::display
