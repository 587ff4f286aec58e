#include "render_core/display/display.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/design/weighted_design.hpp"
#include "render_core/display/data_legends.hpp"
#include "render_core/display/effect_calls.hpp"
#include "render_core/display/frame_notes.hpp"
#include "render_core/display/symbology_plan.hpp"
#include "render_core/display/terrain_ground.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::display {

using flight::Signal;

base::Error Display::start(const DisplaySettings& settings, base::Arena memory, base::Surface& surface,
                           const TerrainInput& terrain, base::ByteSource* scene) {
    settings_ = settings;
    if (base::Error error = take_designs(settings)) return error;
    if (base::Error error = memory_.cut(settings_.device.budget, memory)) return error;
    gl_.use_programs(settings.programs);
    if (auto opened = gl_.open(surface, settings_.device.capability); !opened.ok()) return opened.error();
    if (base::Error error = start_drawing(terrain)) return error;
    if (base::Error error = start_data(scene)) return error;
    note_epochs();
    gl_.seal();
    gl_.use_programs(nullptr);
    memory_.note_use(settings_.device.budget);
    return {};
}

/// Every design as its weights leave it, the one that is shown first; and as it was read, whose programs show it at any weights.
/// Those with foci also as they are where there is none.
base::Error Display::start_drawing(const TerrainInput& terrain) {
    constexpr std::size_t kMost = 2 * (design::kMaxPhaseDesigns + 1);
    design::DesignSettings weighted[design::kMaxPhaseDesigns + 1];
    base::FixedVector<const design::DesignSettings*, kMost> all;
    for (std::size_t place = 0; place <= phases_.size(); ++place) {
        weighted[place] = design::weighted(design_at(place));
        static_cast<void>(all.try_push_back(&weighted[place]));
    }
    for (std::size_t place = 0; place <= phases_.size(); ++place)
        if (design_at(place).priority.is_stated) static_cast<void>(all.try_push_back(&design_at(place)));
    base::FixedVector<draw::DrawnDesign, 2 * kMost> designs;
    for (const bool has_focus : {false, true})
        for (const design::DesignSettings* const design : all)
            if (const draw::DrawnDesign drawn = drawn_design(*design, has_focus); drawn.has_focus == has_focus)
                static_cast<void>(designs.try_push_back(drawn));
    if (base::Error error = start_drawers(designs)) return error;
    if (terrain.file == nullptr) return {};
    const TerrainMemory lines = memory_.terrain();
    if (base::Error error = terrain_.start(terrain, designs, settings_.device, lines)) return error;
    const draw::TracePlace traced{terrain.workers, &memory_.traced_terrain(), settings_.width_px + 2 * stereo_margin_px(design_),
                                  settings_.height_px};
    if (base::Error error = terrain_painter_.start(gl_, terrain_, designs, settings_.device, lines.staging, traced)) return error;
    terrain_.follow_painter(terrain_painter_.reads_pages(), terrain_painter_.tracer());
    terrain_.set_design(designs[0]);
    return {};
}

base::Error Display::start_data(base::ByteSource* scene) {
    const std::uint32_t ground_side = terrain_.is_started() ? terrain_painter_.ground_side() : 0;
    if (base::Error error = data_.start(scene, memory_.scene(), ground_side)) return error;
    bool has_data = data_.has_scene() || settings_.expects_scene;
    draw::DataVariant variant{design_.sky.air.is_shown};
    for (std::size_t place = 0; place <= phases_.size(); ++place) {
        const design::DesignSettings& design = design_at(place);
        has_data =
            has_data || !design.foci.empty() || asks_for_own(design.data.elements) || asks_for_traffic(design.data.elements);
        variant.grid = variant.grid || has_grid_on_data(design);
        variant.shadows = variant.shadows || design.effects.shadows.is_any();
        variant.magnified = variant.magnified || design::magnifies(design);
    }
    if (!has_data || !terrain_.is_started()) return {};
    set_elements();
    const ElementPlanner::Memory lines = memory_.elements();
    if (base::Error error = elements_.start(draw::GlyphDrawer::has_instances(gl_), settings_.device.budget, lines)) return error;
    return element_painter_.start(gl_, settings_.device.budget, lines, elements_, quad_drawer_, variant);
}

/// 0: one picture is for both eyes.
std::uint32_t Display::stereo_margin_px(const design::DesignSettings& design) const {
    if (design.effects.stereo.mode == design::StereoMode::none) return 0;
    return eye_margin_px(design.view.horizontal_field_of_view_rad, settings_.width_px);
}

base::Error Display::start_drawers(draw::DrawnDesigns designs) {
    const std::uint32_t width_px = settings_.width_px, height_px = settings_.height_px;
    const std::uint32_t margin_px = stereo_margin_px(design_);
    bool fades = false, dims = false;
    for (const draw::DrawnDesign& drawn : designs) {
        fades = fades || drawn.design->effects.fade_s > 0;
        dims = dims || drawn.design->effects.lighting != design::PanelLighting::day;
    }
    const bool is_stereo = margin_px > 0;
    if (is_stereo)
        if (base::Error error = stereo_.start(gl_, settings_.device.budget, width_px, height_px, margin_px)) return error;
    if (fades && !is_stereo)
        if (base::Error error = fade_.start(gl_, settings_.device.budget, width_px, height_px)) return error;
    if (base::Error error = passes_.start(gl_, settings_.device, designs, width_px + 2 * margin_px, height_px)) return error;
    if (base::Error error = saliency_.start(gl_, settings_.device.budget, designs, width_px, height_px)) return error;
    if (base::Error error = clutter_.start(gl_, settings_.device.budget, designs, width_px, height_px)) return error;
    if (dims)
        if (base::Error error = dimmer_.start(gl_, settings_.device.budget)) return error;
    if (!symbology_.start(memory_.symbology(), draw::kSymbologyVertices))
        return base::make_error("the budget line '", effects::kSymbology,
                                "' is too small for the symbology; raise it in the device file");
    return quad_drawer_.start(gl_, settings_.device.budget, symbology_);
}

void Display::stop() {
    gl_.retire();
    quad_drawer_.destroy(gl_);
    passes_.destroy(gl_);
    stereo_.destroy(gl_);
    fade_.destroy(gl_);
    saliency_.destroy(gl_);
    clutter_.destroy(gl_);
    dimmer_.destroy(gl_);
    element_painter_.destroy(gl_);
    terrain_painter_.destroy(gl_);
}

bool Display::take_scene(const scene::Scene& scene) {
    const bool is_unexpected = terrain_.is_started() && !data_.has_scene() && !settings_.expects_scene;
    if (is_unexpected || !data_.is_newer(scene)) return false;
    keep_scene();
    if (!data_.take(scene)) return false;
    note_epochs();
    clutter_.forget();
    if (!elements_.is_started()) return true;
    set_elements();
    elements_.labels().forget();
    return true;
}

base::Stamped<double> Display::height_above_terrain(const flight::OwnShipEstimate& own_ship, base::Time now) {
    if (!terrain_.is_started() || own_ship.state != base::SignalState::valid) return {};
    const terrain::HeightAnswer ground = terrain_.true_height(own_ship.position.latitude_rad, own_ship.position.longitude_rad);
    if (ground.status != terrain::HeightStatus::land && ground.status != terrain::HeightStatus::sea) return {};
    const double undulation = own_ship.height_is_geometric ? ground.undulation.m : 0;
    const auto quality = own_ship.height_is_geometric ? base::Quality::good : base::Quality::degraded;
    return {own_ship.position.height.m - undulation - ground.height.m, now, quality};
}

policy::TerrainSource Display::terrain_source(const flight::OwnShipEstimate& own_ship) {
    if (!terrain_.is_started())
        return settings_.terrain_failed_at_start ? policy::TerrainSource::failed : policy::TerrainSource::none;
    if (terrain_failed_) return policy::TerrainSource::failed;
    const bool inside =
        terrain_.database().lattice().point(own_ship.position.latitude_rad, own_ship.position.longitude_rad).inside;
    return inside || own_ship.state == base::SignalState::missing ? policy::TerrainSource::ready : policy::TerrainSource::outside;
}

void Display::update(const flight::AircraftState& state, const flight::PhaseStatus& phase, base::Time now,
                     const flight::FlownWay* way) {
    follow_phase(phase, now);
    begin_update(state, phase, now);
    plan_crowding();
    follow_foci();
    if (has_new_look_) show_look();
    plan_terrain();
    plan_data();
    plan_elements(way);
    plan_effects();
}

/// Where the eye is, and what it may be shown: all that does not depend on what has arrived of the terrain.
void Display::begin_update(const flight::AircraftState& state, const flight::PhaseStatus& phase, base::Time now) {
    state_ = state;
    conditions_ = {};
    conditions_.terrain = terrain_source(state.own_ship);
    conditions_.phase = phase;
    conditions_.generated_flight = settings_.generated_flight;
    const DrapeState drape = terrain_.drape(settings_.design.terrain.style);
    conditions_.image_is_missing = drape == DrapeState::not_in_database || drape == DrapeState::not_on_device;
    if (conditions_.terrain == policy::TerrainSource::ready && state.is_valid(Signal::height_above_terrain, now) &&
        state[Signal::height_above_terrain].value_or(0) < 0)
        conditions_.terrain = policy::TerrainSource::above_own_ship;
    conditions_.shows_measure = shows_measure();
    conditions_.is_reduced = settings_.design.degradation.show_reduced && frame_budget_.is_reduced();
    weigh(now);
    transition_.step(settings_.design.view.mode, settings_.design.view.transition_s, now);
    decide(now);
    begin_record(now);
    plan_view();
    plan_foci();
    magnify();
    decide_labels();
}

void Display::plan_effects() {
    EffectFacts facts{asked(), settings_.device.forbidden, effects_in_reserve(settings_.design), decisions_};
    facts.is_near = is_near();
    facts.light = record_.light.source;
    facts.drape = terrain_.drape(settings_.design.terrain.style);
    facts.ground_data = data_plan_.ground;
    facts.adjacent = maps_beside_.state;
    facts.adjacent_maps = maps_beside_.drawn;
    facts.haze_per_m = eye_.haze_per_m;
    if (decisions_.show_terrain && !elements_.has_anything()) {
        facts.nearest_m = terrain_.nearest_m(eye_.view);
        facts.farthest_m = terrain_.farthest_m(eye_.view);
    }
    facts.parallax_px = parallax_bound_px(eyes_, eye_.view.focal_px, facts.nearest_m, facts.farthest_m);
    shadows_ = plan_shadows();
    facts.shadows = shadows_;
    focus_ = focus_of(settings_.design.effects.depth_of_field, elements_, eye_.view.eye);
    facts.focus = focus_;
    panel_ = policy::panel_light(settings_.design.effects, state_.own_ship.position, record_.flight_time.utc);
    facts.panel = panel_;
    facts.cues = cue_states(elements_.reports());
    facts.air = settings_.design.sky.air;
    facts.has_foci = foci_.foci.is_any();
    facts.context_blur_px = terrain_of_context(settings_.design.foci).blur_px;
    facts.reads_distances = reads_distances(settings_.design);
    facts.shows_clutter = settings_.design.effects.clutter != design::ClutterView::none;
    const double held_clutter = settings_.design.priority.held_clutter();
    facts.has_what_gives_way = held_clutter < 1 && has_what_gives_way();
    facts.is_stereo = stereo_.is_started();
    facts.is_forced = effects_are_forced_;
    fade_share_ = next_fade_share();
    facts.fade_share = fade_share_;
    record_.design = design_at(turn_ == Turn::keeps ? turns_to_ : shown_).name;
    record_.earlier_share = fade_share_;
    facts.order = order_of(settings_.design);
    count();
    plan_ = frame_budget_.plan(effect_calls(facts), settings_.device.capability, counters_, terrain_tolerance(), record_.time);
    saliency_.plan(plan_.runs(effects::Effect::saliency), record_.time);
    const bool may_hold = facts.has_what_gives_way && !facts.is_stereo;
    clutter_.plan(plan_.runs(effects::Effect::clutter), record_.time, shown_, may_hold ? held_clutter : 1);
}

ShadowPlan Display::plan_shadows() {
    const design::ShadowSettings& settings = settings_.design.effects.shadows;
    if (!settings.is_any() || !decisions_.show_terrain || !elements_.is_started()) return {};
    const earth::Geodetic eye = earth::from_ecef(eye_.view.eye);
    const terrain::HeightAnswer ground = terrain_.true_height(eye.latitude_rad, eye.longitude_rad);
    const double lowest_m = double{terrain_.database().header().min_height_m};
    const bool is_known = ground.status == terrain::HeightStatus::land || ground.status == terrain::HeightStatus::sea;
    const double ground_m = eye_.view.is_flat() ? eye_.view.flat_msl_m : is_known ? ground.height.m : lowest_m;
    return display::plan_shadows({settings, record_.light, eye_.view, std::fmax(eye_msl_m_ - ground_m, 0), undulation_m(eye),
                                  std::fmin(lowest_m, ground_m), terrain_.nearest_m(eye_.view),
                                  settings_.device.capability.shadow_map_px, data_plan_.ground == GroundDataState::shown},
                                 elements_.casters(settings.casters));
}

void Display::count() {
    const ElementCounters elements = elements_.counters();
    counters_.megapixels = settings_.width_px * 1e-6 * settings_.height_px;
    counters_.triangles = record_.terrain.triangles;
    counters_.maps = maps_beside_.drawn;
    counters_.elements = elements.features;
    counters_.glyphs = elements.glyphs;
}

void Display::decide(base::Time now) {
    conditions_.is_map = is_map();
    decisions_ = policy::decide_display(state_, now, conditions_, settings_.design);
    // On the way between 3D and the map what holds for 3D holds; without terrain there is no way to be seen.
    if (!transition_.is_under_way() || decisions_.show_terrain) return;
    transition_.arrive();
    conditions_.is_map = is_map();
    decisions_ = policy::decide_display(state_, now, conditions_, settings_.design);
}

/// Terrain that turns out not to be had: its notice must be on this frame already.
void Display::give_up_terrain(policy::TerrainSource reason) {
    conditions_.terrain = reason;
    decide_again();
}

void Display::decide_again() {
    decisions_ = policy::decide_display(state_, record_.time, conditions_, settings_.design);
    for (const auto& name : decisions_.flags) flag(name.view(), record_);
}

void Display::begin_record(base::Time now) {
    record_ = FrameRecord{};
    record_.frame = frame_++;
    record_.time = now;
    record_.phase = conditions_.phase;
    record_.own_ship = state_.own_ship;
    record_.heading_rad = draw::view_heading_rad(state_, decisions_);
    record_.pitch_rad = state_[Signal::pitch].value_or(0);
    record_.roll_rad = state_[Signal::roll].value_or(0);
    record_.view.mode = settings_.design.view.mode;
    const bool is_far = record_.view.mode != design::ViewMode::perspective;
    record_.view.transition = is_far ? transition_.map_share() : 1 - transition_.map_share();
    for (std::size_t n = 0; n < flight::kSignalCount; ++n) record_.signals[n] = state_.state_of(static_cast<Signal>(n), now);
    record_.scene_revision = data_.has_scene() ? data_.scene().header().revision : 0;
    record_.flight_time = flight::flight_time(state_.utc, now);
    if (state_.utc.state == base::SignalState::lost) flag("utc.lost", record_);
    record_.light =
        policy::terrain_light(settings_.design.terrain.style.shade, state_.own_ship.position, record_.flight_time.utc);
    for (const auto& name : decisions_.flags) flag(name.view(), record_);
}

void Display::plan_view() {
    const earth::Geodetic& place = state_.own_ship.position;
    const double undulation = undulation_m(place);
    aircraft_msl_m_ = place.height.m - (state_.own_ship.height_is_geometric ? undulation : 0);
    record_.altitude_msl_m = aircraft_msl_m_;
    EyeInput input;
    input.own_ship = {place.latitude_rad, place.longitude_rad, {aircraft_msl_m_ + undulation}};
    input.msl_m = aircraft_msl_m_;
    input.above_ground_m = state_[Signal::height_above_terrain].value_or(aircraft_msl_m_);
    input.heading_rad = record_.heading_rad;
    input.pitch_rad = record_.pitch_rad;
    input.roll_rad = record_.roll_rad;
    input.map_up_rad = draw::map_up_rad(state_, decisions_);
    input.map_share = free_view_active_ ? 0 : transition_.map_share();
    input.width_px = settings_.width_px;
    input.height_px = settings_.height_px;
    eye_ = make_eye(input, settings_.design.view, settings_.design.sky.haze_distance_m);
    if (free_view_active_) eye_.view = free_view_;
    if (settings_.design.view.reference == design::Reference::flat) eye_.view.flat_msl_m = settings_.design.view.flat_msl_m;
    const earth::Geodetic eye_place = earth::from_ecef(eye_.view.eye);
    eye_msl_m_ = eye_place.height.m - undulation_m(eye_place);
    eyes_ = {};
    if (stereo_.is_started() && is_near())
        eyes_ = eye_pair(settings_.design.effects.stereo, eye_.view.focal_px, eye_.view.near_m, stereo_.margin_px());
    seen_ = seen_by_both(eye_.view, eyes_);
}

double Display::undulation_m(const earth::Geodetic& place) const {
    return terrain_.is_started() ? terrain_.database().undulation(place.latitude_rad, place.longitude_rad).m : 0;
}

void Display::plan_terrain() {
    const double tau_factor = frame_budget_.tau_factor(terrain_tolerance());
    record_.terrain.tau_px = settings_.design.terrain.tau_px * tau_factor;
    if (!decisions_.show_terrain) {
        terrain_.rest();
        return;
    }
    widen_bands();
    Eye seen = eye_;
    seen.view = seen_;
    TerrainPlan plan = terrain_.plan(seen, settings_.design, tau_factor);
    if (plan.is_unmagnified) stop_magnifying();
    if (eyes_.base_m > 0)
        for (const draw::EyeSide side : draw::kEyeSides)
            terrain_.widen_error(eye_of(eye_, eyes_, side, stereo_.margin_px()).view, settings_.design, plan.lod);
    if (terrain_.is_traced()) plan = as_traced(plan);
    if (!plan.lod.within_budget) {
        give_up_terrain(policy::TerrainSource::over_budget);
        return;
    }
    terrain_has_void_ = plan.has_void;
    note_terrain(plan, record_);
    note_renderer(settings_.design.terrain.renderer, terrain_.trace_state(), record_);
    // What budgets leave is the best there will be, and is said to be coarse.
    if (plan.pending != 0 && plan.lod.worst_waiting_px > settings_.design.degradation.terrain_removed_px) {
        give_up_terrain(policy::TerrainSource::too_coarse);
        return;
    }
    if (plan.lod.worst_coarse_px <= settings_.design.degradation.terrain_error_px) return;
    conditions_.terrain_is_coarse = true;
    decide_again();
}

void Display::widen_bands() {
    if (!decisions_.show_warning_colors) return;
    design::HeightAccuracy accuracy;
    if (state_.is_valid(Signal::vertical_accuracy, record_.time))
        accuracy.position_m = state_[Signal::vertical_accuracy].value_or(0);
    accuracy.terrain_m = static_cast<double>(terrain_.database().header().le90_m);
    record_.bands = design::band_widening(settings_.design.widening, band_deviations_, accuracy);
    if (record_.bands.position_assumed) flag("vertical_accuracy.assumed", record_);
    if (record_.bands.terrain_assumed) flag("terrain.accuracy_assumed", record_);
}

void Display::put_symbology() {
    maps_beside_ = {};
    if (free_view_active_) return;
    const draw::SymbolGround over = transition_.is_under_way() ? draw::SymbolGround::moving
                                    : conditions_.is_map       ? draw::SymbolGround::map
                                                               : draw::SymbolGround::perspective;
    const DrawContext frame = context();
    maps_beside_ =
        plan_symbology({frame, state_, settings_.width_px, settings_.height_px, over, data_, data_plan_, elements_.reports()},
                       symbology_, record_);
}

void Display::plan_data() {
    data_plan_ = data_.plan(settings_.design.data, record_.flight_time);
    if (data_plan_.ground == GroundDataState::not_asked_for) return;
    if (data_plan_.ground != GroundDataState::shown) flag("ground_data.missing", record_);
    if (!record_.flight_time.is_date) flag("ground_data.no_date", record_);
    const scene::GridSlice* const slice = data_.ground();
    if (slice != nullptr && is_in_another_unit(settings_.design.data.ground.scale.palette, *slice->attribute()->entry))
        flag("ground_data.unit", record_);
}

}  // namespace tedavis::display
