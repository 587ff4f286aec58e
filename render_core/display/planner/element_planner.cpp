#include "render_core/display/planner/element_planner.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render_core/display/planner/approach_frame.hpp"
#include "render_core/display/planner/ghost_element.hpp"
#include "render_core/draw/data/area_prisms.hpp"
#include "render_core/draw/data/feature_sight.hpp"
#include "render_core/draw/data/ground_strips.hpp"
#include "render_core/draw/data/model_solids.hpp"
#include "render_core/draw/data/obstacle_solids.hpp"
#include "render_core/draw/data/pathway_solids.hpp"
#include "render_core/draw/data/place_ellipsoids.hpp"
#include "render_core/draw/data/runway_strips.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::display {
namespace {

using design::DataTechnique;

bool shows_solids(const scene::Layer& layer) {
    const scene::LayerRole role = layer.entry->role;
    switch (layer.entry->shape) {
        case scene::LayerShape::points: return role == scene::LayerRole::obstacle;
        case scene::LayerShape::lines: return role == scene::LayerRole::obstacle || role == scene::LayerRole::runway;
        case scene::LayerShape::meshes: return true;
        default: return false;
    }
}

bool shows(DataTechnique technique, const scene::Layer& layer) {
    switch (technique) {
        case DataTechnique::prism: return layer.entry->shape == scene::LayerShape::areas;
        case DataTechnique::tube:
        case DataTechnique::space_time: return draw::shows_tubes(layer);
        case DataTechnique::pathway: return draw::shows_pathways(layer);
        case DataTechnique::solid: return shows_solids(layer);
        case DataTechnique::ribbon: return layer.entry->shape == scene::LayerShape::lines;
        case DataTechnique::diagram: return layer.entry->shape == scene::LayerShape::points;
        case DataTechnique::billboard: return layer.entry->shape != scene::LayerShape::grid;
        case DataTechnique::isosurface: return draw::shows_isosurfaces(layer);
        default: return is_glyph_technique(technique);
    }
}

bool shows_own(const design::DataElement& element) {
    if (element.own == design::OwnData::wind) return element.technique == DataTechnique::barbs;
    return element.technique == DataTechnique::tube || element.technique == DataTechnique::space_time ||
           element.technique == DataTechnique::ribbon;
}

bool shows(const design::DataElement& element, const scene::Layer& layer) {
    return element.own == design::OwnData::none ? shows(element.technique, layer) : shows_own(element);
}

bool is_runway_solid(const design::DataElement& element, const scene::Layer& layer) {
    return element.technique == DataTechnique::solid && layer.entry->role == scene::LayerRole::runway &&
           layer.entry->shape == scene::LayerShape::lines;
}

bool is_traffic(const scene::Layer& layer) {
    return layer.entry->role == scene::LayerRole::traffic && layer.entry->shape == scene::LayerShape::lines;
}

/// Of its solids; billboards are built every frame anyway. A runway's outline is as wide on the screen in each.
bool moves(const design::DataElement& element, const scene::Layer& layer) {
    if (element.own != design::OwnData::none) return true;
    const DataTechnique technique = element.technique;
    if (technique == DataTechnique::pathway) return true;
    if (technique == DataTechnique::isosurface) return draw::isosurfaces_move(layer);
    return is_traffic(layer) || is_runway_solid(element, layer) ||
           (technique == DataTechnique::prism && draw::prisms_move(layer));
}

draw::OwnPlace own_place(const OwnFlightFrame& own) {
    if (own.aircraft == nullptr) return {};
    const flight::OwnShipEstimate& estimate = own.aircraft->own_ship;
    const bool is_valid = estimate.state == base::SignalState::valid;
    return {estimate.position, is_valid, is_valid && estimate.height_is_geometric};
}

draw::ElementCount build_solids(draw::SolidBatch& batch, draw::SolidMesh& mesh, const draw::ElementInput& input) {
    if (input.layer.entry->shape == scene::LayerShape::meshes) return draw::add_models(batch, mesh, input);
    return input.layer.entry->shape == scene::LayerShape::points ? draw::add_obstacle_points(batch, mesh, input)
                                                                 : draw::add_cables(batch, mesh, input);
}

}  // namespace

bool ElementPlanner::distances_m(scene::LayerRole role, const glm::dvec3& eye, terrain::DepthSpan& distances_m) const {
    bool is_any = false;
    for (const draw::SolidBatch* const solids : {&standing_, &moving_})
        for (const draw::SolidPiece& piece : solids->pieces()) {
            const std::size_t report = piece.look.group;
            if (report >= reports_.size() || (shown_ >> report & 1u) == 0 || reports_[report].layer->entry->role != role)
                continue;
            const double middle_m = glm::distance(piece.anchor, eye), reach_m = static_cast<double>(piece.radius_m);
            distances_m.near_m = std::fmin(is_any ? distances_m.near_m : middle_m, std::fmax(middle_m - reach_m, 0));
            distances_m.far_m = std::fmax(is_any ? distances_m.far_m : 0, middle_m + reach_m);
            is_any = true;
        }
    return is_any;
}

void ElementPlanner::set(const scene::Scene* scene, const design::DataElementList& elements, const design::LabelSettings& labels,
                         std::size_t design) {
    labels_.set(scene, elements, labels, design);
    scene_ = scene;
    elements_ = &elements;
    has_changed_ = true;
    // The objects that they point to may no longer exist.
    reports_.clear();
    glyphs_.clear();
    shown_ = 0;
}

ElementState ElementPlanner::state_of(const ElementReport& report) const {
    if (report.layer == nullptr) return ElementState::no_such_layer;
    if (!shows(*report.element, *report.layer)) return ElementState::wrong_layer;
    if (report.element->own != design::OwnData::none || report.layer == &traffic_.layer())
        return report.layer->entry->feature_count > 0 ? ElementState::shown : ElementState::not_measured;
    if (is_glyph_technique(report.element->technique) && report.slot == GlyphElements::kSlots) return ElementState::no_room;
    return is_valid_at(*report.layer, time_) ? ElementState::shown : ElementState::out_of_date;
}

void ElementPlanner::plan(const ElementFrame& frame) {
    time_ = frame.time;
    shown_ = 0;
    if (elements_ == nullptr) return;
    receive_traffic(frame);
    if (has_changed_) begin_reports();
    own_.take(frame.own, frame.time, frame.ground);
    for (std::size_t n = 0; n < reports_.size(); ++n) {
        reports_[n].state = state_of(reports_[n]);
        if (reports_[n].state != ElementState::shown) continue;
        shown_ |= 1u << n;
        reports_[n].suppressed_labels = labels_.suppressed(*reports_[n].element, *reports_[n].layer);
    }
    take_foci(frame);
    take_alerts(frame);
    if (has_changed_) build(standing_, false, frame);
    build(moving_, true, frame);
    count_out_of_view(frame);
    glyphs_.begin_plan();
    plan_glyphs(frame, nullptr);
    standing_key_ += has_changed_ ? 1 : 0;
    has_changed_ = false;
}

/// Geometry that does not move has the look that the foci give it.
void ElementPlanner::take_foci(const ElementFrame& frame) {
    const bool changes = frame.foci != nullptr && frame.foci->changes_data();
    const std::uint64_t key = changes ? draw::key_of(*frame.foci, time_.utc.ns, time_.is_date) : 0;
    has_changed_ = has_changed_ || key != foci_key_;
    foci_key_ = key;
    for (std::size_t n = 0; n < reports_.size(); ++n)
        foci_[n] = reports_[n].layer == nullptr ? draw::LayerFoci()
                                                : draw::LayerFoci(frame.foci, *reports_[n].layer, time_.utc.ns, time_.is_date);
}

/// Obstacles do not move, and those in the way have another colour.
void ElementPlanner::take_alerts(const ElementFrame& frame) {
    const std::uint64_t key = frame.alerts == nullptr ? 0 : frame.alerts->key();
    has_changed_ = has_changed_ || key != alerts_key_;
    alerts_key_ = key;
}

draw::FocusCounts ElementPlanner::count_in_focus(const ElementFrame& frame, std::size_t focus) const {
    draw::FocusCounts counts;
    for (std::size_t n = 0; n < reports_.size(); ++n) {
        if (reports_[n].state != ElementState::shown) continue;
        const draw::FocusCounts one = draw::count_in_focus(*frame.foci, focus, foci_[n], input_of(n, frame));
        counts.in_focus += one.in_focus;
        counts.intermediate += one.intermediate;
        counts.context += one.context;
    }
    return counts;
}

/// The layer is there from the first frame on in which there is a receiver.
void ElementPlanner::receive_traffic(const ElementFrame& frame) {
    const bool receives = frame.own.aircraft != nullptr && frame.own.aircraft->traffic.is_received;
    has_changed_ = has_changed_ || receives != receives_traffic_;
    receives_traffic_ = receives;
    if (receives) traffic_.take(frame.own.aircraft->traffic, frame.time.utc - frame.own.now);
}

void ElementPlanner::rest() {
    shown_ = 0;
    labels_.rest();
    label_counts_ = {};
    for (ElementReport& report : reports_) report.state = ElementState::no_terrain;
}

void ElementPlanner::begin_reports() {
    reports_.clear();
    glyphs_.clear();
    for (const design::DataElement& element : *elements_) {
        if (element.own == design::OwnData::none)
            begin_scene_reports(element);
        else
            begin_report(element, element.own == design::OwnData::trail ? &own_.trail() : &own_.winds());
    }
    if (scene_ == nullptr) return;
    for (const scene::Layer& layer : scene_->layers())
        if (needs_ghost_element(*elements_, layer)) begin_report(ghost_element(), &layer);
}

void ElementPlanner::begin_scene_reports(const design::DataElement& element) {
    const std::size_t before = reports_.size();
    if (receives_traffic_ && is_meant(element, traffic_.layer())) begin_report(element, &traffic_.layer());
    if (scene_ != nullptr)
        for (const scene::Layer& layer : scene_->layers())
            if (is_meant(element, layer)) {
                begin_report(element, &layer);
                const std::size_t slot = glyphs_.size();
                if (is_glyph_technique(element.technique) && glyphs_.add(element, layer)) reports_.back().slot = slot;
            }
    if (reports_.size() == before && !element.layer.view().empty()) begin_report(element, nullptr);
}

/// Glyphs, signs and surfaces count by themselves what is not in view.
void ElementPlanner::count_out_of_view(const ElementFrame& frame) {
    for (std::size_t n = 0; n < reports_.size(); ++n) {
        ElementReport& report = reports_[n];
        const DataTechnique technique = report.element->technique;
        const bool counts_itself =
            is_glyph_technique(technique) || is_billboard_technique(technique) || technique == DataTechnique::isosurface;
        const bool is_judged = report.state == ElementState::shown && !counts_itself;
        report.out_of_view = is_judged ? draw::count_out_of_view(input_of(n, frame), frame.view) : 0;
    }
}

/// With a sheet plans the elements that are on it, else the others.
void ElementPlanner::plan_glyphs(const ElementFrame& frame, draw::BillboardSheet* sheet) {
    for (std::size_t n = 0; n < reports_.size(); ++n) {
        const ElementReport& report = reports_[n];
        if (report.state == ElementState::shown && report.slot < GlyphElements::kSlots &&
            is_sign_technique(report.element->technique) == (sheet != nullptr))
            plan_glyphs_of(n, frame, sheet);
    }
}

/// Fields may be sampled more sparsely; glyphs that represent one object each may not.
void ElementPlanner::plan_glyphs_of(std::size_t n, const ElementFrame& frame, draw::BillboardSheet* sheet) {
    ElementReport& report = reports_[n];
    const scene::LayerRole role = report.layer->entry->role;
    const bool is_sampled = role == scene::LayerRole::field || role == scene::LayerRole::wind || role == scene::LayerRole::sample;
    report.detail_factor = is_sampled ? frame.detail_factor : 1;
    const scene::DetailRegions* const regions =
        frame.declutter == nullptr ? nullptr
                                   : frame.declutter->regions_of(*report.element, role, draw::is_protected(*report.layer));
    report.count = glyphs_.plan(report.slot, {frame.ground, frame.view, frame.missing, time_.utc.ns, time_.is_date, sheet,
                                              report.detail_factor, &foci_[n], regions});
}

/// A full list has counted the refusal itself.
void ElementPlanner::begin_report(const design::DataElement& element, const scene::Layer* layer) {
    static_cast<void>(reports_.try_push_back({ElementState::no_such_layer, &element, layer, {}}));
}

draw::ElementInput ElementPlanner::input_of(std::size_t report, const ElementFrame& frame) const {
    const scene::Layer& layer = *reports_[report].layer;
    // What is received is as old as the source's own time says, whether UTC is known or not.
    const bool is_received = &layer == &traffic_.layer();
    return {*reports_[report].element,
            static_cast<std::uint8_t>(report),
            layer,
            frame.ground,
            frame.missing,
            time_.utc.ns,
            time_.is_date || is_received,
            frame.view.eye,
            0,
            time_.is_confirmed || is_received,
            &foci_[report],
            own_place(frame.own),
            layer.entry->role == scene::LayerRole::obstacle ? frame.alerts : nullptr,
            layer_number(layer),
            frame.units};
}

/// A layer that is not in the scene has a number that no layer of the scene has.
std::uint16_t ElementPlanner::layer_number(const scene::Layer& layer) const {
    for (std::size_t n = 0; scene_ != nullptr && n < scene_->layers().size(); ++n)
        if (&scene_->layers()[n] == &layer) return static_cast<std::uint16_t>(n);
    return std::numeric_limits<std::uint16_t>::max();
}

/// Geometry that does not move is built even where it is not valid now, since it may become valid.
void ElementPlanner::build(draw::SolidBatch& batch, bool moving, const ElementFrame& frame) {
    batch.clear();
    for (std::size_t n = 0; n < reports_.size(); ++n) {
        ElementReport& report = reports_[n];
        if (report.layer == nullptr || !shows(*report.element, *report.layer)) continue;
        if (is_glyph_technique(report.element->technique)) continue;
        if (moves(*report.element, *report.layer) != moving) continue;
        const draw::ElementInput input = input_of(n, frame);
        if (is_runway_solid(*report.element, *report.layer))
            report.count = draw::add_runways(batch, mesh_, input, approach_frame(frame, scene_));
        else if (!is_billboard_technique(report.element->technique))
            report.count = build_element(batch, input);
        static_cast<void>(draw::add_place_ellipsoids(batch, mesh_, input));
    }
    build_cues(batch, moving, frame);
}

/// In the room that all elements have left. Lines that travel are built every frame, whatever they stand on.
void ElementPlanner::build_cues(draw::SolidBatch& batch, bool moving, const ElementFrame& frame) {
    for (std::size_t n = 0; n < reports_.size(); ++n) {
        ElementReport& report = reports_[n];
        if (report.layer == nullptr || !shows(*report.element, *report.layer)) continue;
        const design::ElementCues& asked = report.element->cues;
        for (std::size_t kind = 0; kind < draw::kCues; ++kind) {
            const auto cue = static_cast<draw::Cue>(kind);
            const bool travels = cue == draw::Cue::vertical_lines && asked.lines_move != design::LineMotion::still;
            if (draw::asks_for(asked, cue) && (travels || moves(*report.element, *report.layer)) == moving)
                report.cues[kind] = cues_.add(batch, mesh_, input_of(n, frame), cue);
        }
    }
}

draw::ElementCount ElementPlanner::build_element(draw::SolidBatch& batch, const draw::ElementInput& input) {
    switch (input.element.technique) {
        case DataTechnique::prism: return draw::add_area_prisms(batch, mesh_, input);
        case DataTechnique::tube:
        case DataTechnique::space_time: return tubes_.add(batch, mesh_, input);
        case DataTechnique::pathway: return draw::add_pathway(batch, mesh_, input);
        case DataTechnique::solid: return build_solids(batch, mesh_, input);
        case DataTechnique::ribbon: return draw::add_ribbons(batch, mesh_, input);
        case DataTechnique::isosurface: return isosurfaces_.add(batch, mesh_, input);
        default: return {};
    }
}

ElementCounters ElementPlanner::counters() const {
    ElementCounters counters;
    if (shown_ == 0) return counters;
    for (const ElementReport& report : reports_)
        if (report.state == ElementState::shown && report.slot == GlyphElements::kSlots) counters.features += report.count.drawn;
    counters.glyphs = glyphs_.glyphs();
    return counters;
}

CasterSet ElementPlanner::casters(const design::CasterRoles& roles) const {
    CasterSet casters{{&standing_, &moving_}, {}, &glyphs_.batch(), shown_ == 0 ? 0 : glyphs_.slots_of(roles)};
    for (std::size_t n = 0; n < reports_.size(); ++n) {
        if ((shown_ >> n & 1u) == 0 || !roles.has(reports_[n].layer->entry->role)) continue;
        casters.groups.all |= 1u << n;
        if (reports_[n].layer->entry->role == scene::LayerRole::obstacle) casters.groups.thin |= 1u << n;
    }
    return casters;
}

}  // namespace tedavis::display
