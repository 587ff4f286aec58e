#include "render_core/display/planner/glyph_elements.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/budget_shortage.hpp"
#include "render_core/draw/data/glyph_focus.hpp"
#include "render_core/draw/data/glyph_room.hpp"
#include "render_core/draw/data/wind_barbs.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/scene/data_time.hpp"

namespace tedavis::display {
namespace {

using design::DataTechnique;
using design::ElementUncertainty;

constexpr std::uint32_t kSitesAhead = 4096;  // a frame, of the field that will be shown next
constexpr double kBarSlenderness = 3;        // bars are as large as they are high, and take that much less of the picture
constexpr std::uint32_t kAll = 0xFFFFFFFFu;
constexpr std::uint32_t kMaxFields = 2 * GlyphElements::kSlots;

/// Widens the view so that magnifiers cannot bring other places into it.
double magnified_tangent(const terrain::View& view) {
    double most_m = 0;
    for (const earth::Magnifier& magnifier : view.magnifiers) most_m = std::fmax(most_m, magnifier.farthest_move_m());
    return most_m / view.near_m;
}

scene::GlyphView glyph_view(const terrain::View& view) {
    const double more = magnified_tangent(view);
    return {
        view.eye,      view.forward, view.right, view.down, view.half_width_tangent() + more, view.half_height_tangent() + more,
        view.focal_px, view.near_m,  view.far_m};
}

draw::GlyphForm form_of(DataTechnique technique) {
    switch (technique) {
        case DataTechnique::flat_arrows: return draw::GlyphForm::flat_arrow;
        case DataTechnique::spheres: return draw::GlyphForm::sphere;
        case DataTechnique::bars: return draw::GlyphForm::bar;
        default: return draw::GlyphForm::arrow;
    }
}

draw::GlyphForm form_of(ElementUncertainty uncertainty) {
    switch (uncertainty) {
        case ElementUncertainty::triangles: return draw::GlyphForm::triangle;
        case ElementUncertainty::tetrahedra: return draw::GlyphForm::tetrahedron;
        default: return draw::GlyphForm::circle;
    }
}

/// Where no scale is stated, it reaches from 0 to the largest value.
void set_range(const design::DataElement& element, const scene::Attribute& attribute, draw::GlyphStyle& style) {
    if (element.by_color.is_used()) {
        style.least_value = element.by_color.scale.palette.stops[0].value;
        style.full_value = element.by_color.scale.palette.stops.back().value;
        return;
    }
    style.least_value = std::min(0.0, static_cast<double>(attribute.entry->minimum));
    style.full_value = std::max(std::fabs(static_cast<double>(attribute.entry->minimum)),
                                std::fabs(static_cast<double>(attribute.entry->maximum)));
}

draw::GlyphStyle value_style(const design::DataElement& element, const scene::Attribute& attribute, design::Color missing) {
    constexpr std::uint32_t kDirectionsOfClasses = 16;
    draw::GlyphStyle style;
    style.form = form_of(element.technique);
    const bool has_classes = element.by_color.is_used() && !element.by_color.scale.breaks.empty();
    style.sizing = has_classes ? draw::GlyphSizing::classes : draw::GlyphSizing::continuous;
    set_range(element, attribute, style);
    style.opacity = element.opacity;
    style.fading = element.uncertainty == ElementUncertainty::transparency ? element.uncertainty_strength : 0;
    style.greying = element.uncertainty == ElementUncertainty::saturation ? element.uncertainty_strength : 0;
    style.directions = has_classes ? kDirectionsOfClasses : 0;
    style.is_colored = element.by_color.is_used();
    style.plain = element.color;
    style.missing = missing;
    return style;
}

draw::GlyphStyle uncertainty_style(const design::DataElement& element) {
    draw::GlyphStyle style;
    style.form = form_of(element.uncertainty);
    style.subject = draw::GlyphSubject::uncertainty;
    style.opacity = element.uncertainty_strength;
    return style;
}

const draw::FrameFoci* foci_of(const GlyphFrameInput& frame) { return frame.foci == nullptr ? nullptr : frame.foci->frame(); }

/// Instances of a site's glyphs.
std::uint32_t parts_of(const design::DataElement& element) {
    const bool is_twice = is_glyph_uncertainty(element.uncertainty) && element.technique != DataTechnique::uncertainty_only;
    return (is_twice ? 2 : 1) + (element.link ? draw::kLinkParts : 0);
}

}  // namespace

bool is_glyph_technique(DataTechnique technique) noexcept {
    return technique == DataTechnique::arrows || technique == DataTechnique::flat_arrows || technique == DataTechnique::spheres ||
           technique == DataTechnique::bars || technique == DataTechnique::barbs || technique == DataTechnique::uncertainty_only;
}

bool is_glyph_uncertainty(ElementUncertainty uncertainty) noexcept {
    return uncertainty == ElementUncertainty::circles || uncertainty == ElementUncertainty::triangles ||
           uncertainty == ElementUncertainty::tetrahedra;
}

design::DataScale uncertainty_scale(const design::DataElement& element) noexcept {
    constexpr design::Color kSure{255, 255, 204}, kUnsure{189, 0, 38};
    design::DataScale scale;
    scale.palette.name = "uncertainty";
    static_cast<void>(scale.palette.stops.try_push_back({0, kSure}));
    static_cast<void>(scale.palette.stops.try_push_back({1, kUnsure}));
    for (std::uint32_t n = 1; n < element.uncertainty_levels; ++n)
        static_cast<void>(scale.breaks.try_push_back(static_cast<double>(n) / element.uncertainty_levels));
    return scale;
}

base::Error GlyphElements::start(bool has_instances, const base::BudgetTable& budget, base::Arena& memory) {
    const std::uint64_t gpu_bytes = budget.find(effects::kSceneGlyphVertices)->bytes;
    const draw::GlyphRoom room = draw::glyph_room(has_instances, memory.use().capacity, gpu_bytes, kMaxFields);
    batch_ = draw::GlyphBatch(memory.allocate_array<draw::GlyphInstance>(room.glyphs));
    const bool has_selection = selection_.start(memory, room.glyphs);
    const std::uint64_t for_sites = kMaxFields * scene::GlyphField::bytes_needed(room.sites / kMaxFields);
    site_memory_ = memory.carve(for_sites);
    most_glyphs_ = room.glyphs;
    if (room.sites > 0 && has_selection && site_memory_.use().capacity == for_sites) return {};
    base::ResourceUse use = memory.use();
    use.in_use = 0;
    return base::shortage_error(effects::kSceneGlyphs, use, draw::least_glyph_bytes(has_instances, gpu_bytes, kMaxFields));
}

draw::ElementInput GlyphElements::input_of(const Slot& slot, const GlyphFrameInput& frame) const {
    draw::ElementInput input{*slot.element, 0, *slot.layer, frame.ground, frame.missing, frame.time_ns, frame.has_date};
    input.foci = frame.foci;
    return input;
}

bool GlyphElements::add(const design::DataElement& element, const scene::Layer& layer) {
    const scene::LayerShape shape = layer.entry->shape;
    const bool has_sites = shape == scene::LayerShape::grid || shape == scene::LayerShape::points;
    if (used_ == kSlots || !has_sites || draw::glyph_attribute(element, layer) == nullptr) return false;
    Slot& slot = slots_[used_++];
    slot.element = &element;
    slot.layer = &layer;
    is_shared_out_ = false;
    return true;
}

void GlyphElements::clear() {
    used_ = 0;
    is_shared_out_ = false;
}

void GlyphElements::begin_plan() {
    batch_.clear();
    if (!is_shared_out_) share_out();
}

/// Divides the memory in the order of what the slots need; each gets an even share of what the slots before it have left.
void GlyphElements::share_out() {
    is_shared_out_ = true;
    site_memory_.reset();
    std::uint64_t needed[kSlots] = {};
    std::uint32_t fields_left = 0;
    for (std::size_t n = 0; n < used_; ++n) {
        Slot& slot = slots_[n];
        slot.field_count = draw::glyphs_change(*slot.layer, *draw::glyph_attribute(*slot.element, *slot.layer)) ? 2 : 1;
        fields_left += slot.field_count;
        const std::uint32_t sites =
            std::clamp(draw::glyph_count(*slot.element, *slot.layer), scene::kMinGlyphSites, scene::kMaxGlyphSites);
        needed[n] = scene::GlyphField::bytes_needed(sites);
    }
    std::uint64_t bytes_left = site_memory_.use().capacity;
    bool is_served[kSlots] = {};
    for (std::size_t round = 0; round < used_; ++round) {
        std::size_t least = kSlots;
        for (std::size_t n = 0; n < used_; ++n)
            if (!is_served[n] && (least == kSlots || needed[n] < needed[least])) least = n;
        is_served[least] = true;
        const std::uint64_t share = std::min(needed[least], bytes_left / fields_left);
        start_fields(slots_[least], share);
        bytes_left -= share * slots_[least].field_count;
        fields_left -= slots_[least].field_count;
    }
}

/// An even share of the least there is holds kMinGlyphSites: start() has seen to it.
void GlyphElements::start_fields(Slot& slot, std::uint64_t bytes_a_field) {
    const std::uint32_t sites = scene::GlyphField::sites_within(bytes_a_field);
    for (std::uint32_t n = 0; n < slot.field_count; ++n) TEDAVIS_CHECK(slot.fields[n].start(site_memory_, sites));
    slot.shown = 0;
    for (std::size_t n = 0; n < 2; ++n) slot.is_begun[n] = slot.is_given[n] = false;
}

void GlyphElements::advance(Slot& slot, std::uint32_t field, std::int64_t time_ns, const GlyphFrameInput& frame,
                            std::uint32_t most_sites) {
    scene::GlyphField& sites = slot.fields[field];
    if (!slot.is_begun[field] || slot.times_ns[field] != time_ns) {
        slot.is_begun[field] = slot.sites.begin(input_of(slot, frame), time_ns, sites);
        slot.is_given[field] = false;
        slot.times_ns[field] = time_ns;
    }
    if (!slot.is_given[field])
        slot.is_given[field] = slot.sites.step(frame.ground, sites, most_sites);
    else
        static_cast<void>(sites.step(most_sites));
}

void GlyphElements::show(Slot& slot, const GlyphFrameInput& frame) {
    const bool changes = draw::glyphs_change(*slot.layer, *draw::glyph_attribute(*slot.element, *slot.layer));
    const bool follows = frame.has_date && changes;
    const std::int64_t time_ns = follows ? scene::start_of_data_step(frame.time_ns) : scene::own_time_ns(*slot.layer);
    const auto is_of = [&](std::uint32_t n) {
        return slot.is_begun[n] && slot.times_ns[n] == time_ns && slot.fields[n].is_ready();
    };
    if (!is_of(slot.shown) && slot.field_count == 2) slot.shown = 1 - slot.shown;
    while (!is_of(slot.shown)) advance(slot, slot.shown, time_ns, frame, kAll);  // three times at most
    if (follows) advance(slot, 1 - slot.shown, time_ns + scene::kDataStep_ns, frame, kSitesAhead);
}

void GlyphElements::encode(const Slot& slot, const GlyphFrameInput& frame) {
    const design::DataElement& element = *slot.element;
    const scene::Attribute& attribute = *draw::glyph_attribute(element, *slot.layer);
    const scene::GlyphValues values = draw::glyph_values(*slot.layer, attribute);
    const bool shows_values = element.technique != DataTechnique::uncertainty_only;
    const std::size_t first = batch_.instances().size();
    const double link_per_px = element.link ? 1 / frame.view.focal_px : 0;
    if (shows_values) {
        draw::GlyphStyle style = value_style(element, attribute, frame.missing);
        style.link_per_px = link_per_px;
        style.foci = foci_of(frame);
        draw::encode_glyphs(selection_.glyphs(), values, style, element.by_color.scale, frame.view.eye, batch_);
    }
    if (is_glyph_uncertainty(element.uncertainty)) {
        draw::GlyphStyle style = uncertainty_style(element);
        if (!shows_values) style.link_per_px = link_per_px;
        style.foci = foci_of(frame);
        draw::encode_glyphs(selection_.glyphs(), values, style, uncertainty_scale(element), frame.view.eye, batch_);
    }
    batch_.move_to_shown(first, frame.view.magnifiers, frame.view.eye);
}

/// So far apart that they have room.
draw::ElementCount GlyphElements::plan_barbs(const Slot& slot, const GlyphFrameInput& frame) {
    const bool is_wind =
        draw::glyph_values(*slot.layer, *draw::glyph_attribute(*slot.element, *slot.layer)) == scene::GlyphValues::wind;
    const bool is_shown = is_wind && frame.sheet != nullptr;
    scene::GlyphSettings settings;
    settings.detail = slot.element->detail * frame.detail_factor;
    settings.least_px = settings.cell_px = is_shown ? draw::barb_spacing_px(*frame.sheet) : 1;
    settings.most_drawn = std::min<std::uint32_t>(most_glyphs_, draw::BillboardSheet::kMaxCandidates);
    const scene::GlyphFocus focus = draw::glyph_focus(foci_of(frame), *slot.element, *slot.layer, settings.coarsest);
    if (focus.regions != nullptr) settings.focus = &focus;
    settings.regions = frame.regions;
    const scene::GlyphCounts& counts = selection_.select(slot.fields[slot.shown], glyph_view(frame.view), settings);
    if (!is_shown) return {0, 0, counts.drawn + counts.aggregated + counts.hidden};
    draw::ElementCount count = draw::add_wind_barbs(*frame.sheet, input_of(slot, frame), selection_.glyphs());
    count.hidden += counts.hidden;
    return count;
}

draw::ElementCount GlyphElements::plan(std::size_t n, const GlyphFrameInput& frame) {
    Slot& slot = slots_[n];
    batch_.set_slot(static_cast<std::uint8_t>(n));
    show(slot, frame);
    if (slot.element->technique == DataTechnique::barbs) return plan_barbs(slot, frame);
    scene::GlyphSettings settings;
    settings.detail = slot.element->detail * frame.detail_factor;
    if (slot.element->technique == DataTechnique::bars) settings.coarsest *= kBarSlenderness;
    settings.most_drawn = most_glyphs_ / (static_cast<std::uint32_t>(used_) * parts_of(*slot.element));
    const scene::GlyphFocus focus = draw::glyph_focus(foci_of(frame), *slot.element, *slot.layer, settings.coarsest);
    if (focus.regions != nullptr) settings.focus = &focus;
    settings.regions = frame.regions;
    const scene::GlyphCounts& counts = selection_.select(slot.fields[slot.shown], glyph_view(frame.view), settings);
    encode(slot, frame);
    batch_eye_ = frame.view.eye;
    return {counts.drawn, counts.aggregated, counts.hidden};
}

std::uint32_t GlyphElements::slots_of(const design::CasterRoles& roles) const {
    std::uint32_t slots = 0;
    for (std::size_t n = 0; n < used_; ++n)
        if (roles.has(slots_[n].layer->entry->role)) slots |= 1u << n;
    return slots;
}

void GlyphElements::set_camera(const glm::dvec3& eye) {
    batch_.move(glm::vec3(batch_eye_ - eye));
    batch_eye_ = eye;
}

}  // namespace tedavis::display
