#include "render_core/scene/glyph_selection.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace tedavis::scene {
namespace {

constexpr double kMinDistance_m = 0.01;

bool is_aggregate(const GlyphSummary& summary) { return summary.members > 1; }

double value_of(const GlyphSummary& summary, GlyphValues values) {
    if (summary.state == ValueState::missing) return std::numeric_limits<double>::quiet_NaN();
    return static_cast<double>(values == GlyphValues::wind ? summary.speed_mps : summary.value);
}

std::uint8_t code_of(double degree) {
    if (degree >= 1) return SelectedGlyph::kInFocus;
    if (degree <= 0) return 0;
    constexpr double kMaxBeside = SelectedGlyph::kInFocus - 1;
    return static_cast<std::uint8_t>(std::fmin(std::fmax(std::round(degree * SelectedGlyph::kInFocus), 1.0), kMaxBeside));
}

}  // namespace

std::uint64_t GlyphSelection::bytes_needed(std::uint32_t glyphs) {
    return glyphs * std::uint64_t{sizeof(SelectedGlyph) + sizeof(Part)} + 2 * alignof(std::max_align_t);
}

bool GlyphSelection::start(base::Arena& arena, std::uint32_t most_glyphs) {
    glyphs_ = arena.allocate_array<SelectedGlyph>(most_glyphs);
    waiting_ = arena.allocate_array<Part>(most_glyphs);
    return most_glyphs > 0 && !glyphs_.empty() && !waiting_.empty();
}

const GlyphCounts& GlyphSelection::select(const GlyphField& field, const GlyphView& view, const GlyphSettings& settings) {
    counts_ = {};
    if (!field.is_ready() || field.leaves() == 0) {
        counts_.hidden = field.given();
        return counts_;
    }
    set_view(field, view, settings);
    counts_.hidden = field.misplaced();
    if (!select_all()) {
        counts_ = {};
        counts_.hidden = field.misplaced();
        select_largest();
    }
    return counts_;
}

void GlyphSelection::set_view(const GlyphField& field, const GlyphView& view, const GlyphSettings& settings) {
    field_ = &field;
    settings_ = settings;
    settings_.most_drawn = std::min<std::uint32_t>(settings.most_drawn, static_cast<std::uint32_t>(glyphs_.size()));
    const double coarser = std::pow(settings.coarsest, 1 - std::fmin(std::fmax(settings.detail, 0), 1));
    settings_.least_px = settings.least_px * coarser;
    settings_.cell_px = std::fmax(settings.cell_px, settings.least_px) * coarser;
    focal_px_ = view.focal_px;
    const glm::dmat3 to_field = glm::transpose(field.frame().axes);
    eye_ = to_field * (view.eye - field.frame().anchor);
    const glm::dvec3 forward = to_field * view.forward, right = to_field * view.right, down = to_field * view.down;
    forward_ = forward;
    right_ = right / view.half_width_tangent;
    down_ = down / view.half_height_tangent;
    planes_[0] = {glm::normalize(forward * view.half_width_tangent + right), 0};
    planes_[1] = {glm::normalize(forward * view.half_width_tangent - right), 0};
    planes_[2] = {glm::normalize(forward * view.half_height_tangent + down), 0};
    planes_[3] = {glm::normalize(forward * view.half_height_tangent - down), 0};
    planes_[4] = {forward, -view.near_m};
    planes_[5] = {-forward, view.far_m};
    for (Plane& plane : planes_) plane.offset_m -= glm::dot(plane.inwards, eye_);
    if (settings.focus == nullptr) return;
    for (std::size_t n = 0; n < settings.focus->regions->size(); ++n) {
        const FocusRegion& region = (*settings.focus->regions)[n];
        focus_planes_[n] = {to_field * region.east, to_field * region.north, in_focus_plane(region, field.frame().anchor)};
    }
}

/// Of any place of the box round the members; where similar values may be, no less than that of the intermediate context.
double GlyphSelection::greatest_degree(const GlyphSummary& summary) const {
    const GlyphFocus& focus = *settings_.focus;
    const glm::dvec3 place(summary.place), reach(summary.reach_m);
    double greatest = 0;
    for (std::size_t n = 0; n < focus.regions->size(); ++n) {
        const FocusRegion& region = (*focus.regions)[n];
        if (!region.is_valid) continue;
        const FocusPlane& plane = focus_planes_[n];
        const glm::dvec2 ground = plane.offset_m + glm::dvec2(glm::dot(plane.east, place), glm::dot(plane.north, place));
        const double half_m =
            glm::length(glm::dvec2(glm::dot(glm::abs(plane.east), reach), glm::dot(glm::abs(plane.north), reach)));
        const double distance_m = focus_distance_m(region, ground) - half_m;
        const double degree = distance_m > 0 ? degree_at_distance(region.context, distance_m) : 1;
        greatest = std::fmax(greatest, focus.by_value[n] ? std::fmax(degree, focus.least_degree) : degree);
    }
    return greatest;
}

/// Of its detail, 0..1, by the region of its mean place and beside foci.
double GlyphSelection::decluttered_share(const GlyphSummary& summary) const {
    if (settings_.regions == nullptr) return 0;
    const glm::dvec3 way = glm::dvec3(summary.place) - eye_;
    const double ahead_m = glm::dot(way, forward_);
    if (!(ahead_m > 0)) return 0;
    const double kept =
        settings_.regions->at(0.5 + 0.5 * glm::dot(way, right_) / ahead_m, 0.5 + 0.5 * glm::dot(way, down_) / ahead_m);
    if (settings_.focus == nullptr || kept >= 1) return 1 - kept;
    return (1 - kept) * (1 - static_cast<double>(step_of(summary)) / GlyphFocus::kSteps);
}

std::size_t GlyphSelection::step_of(const GlyphSummary& summary) const {
    return static_cast<std::size_t>(std::round(greatest_degree(summary) * GlyphFocus::kSteps));
}

double GlyphSelection::coarser(const GlyphSummary& summary) const {
    const double given = decluttered_share(summary);
    const double crowded = given > 0 ? std::pow(settings_.coarsest, settings_.detail * given) : 1;
    return settings_.focus == nullptr ? crowded : crowded * settings_.focus->coarser[step_of(summary)];
}

/// By its width in glyphs, however large they are on the screen.
bool GlyphSelection::stands_for_all(const GlyphSummary& summary) const {
    double across = 1 + (kCrowdedAcross - 1) * decluttered_share(summary);
    if (settings_.focus != nullptr) across = std::fmax(across, settings_.focus->across[step_of(summary)]);
    const glm::dvec3 sides = 2.0 * glm::dvec3(summary.reach_m) + static_cast<double>(summary.size_m);
    return across > 1 && std::fmax(sides.x, std::fmax(sides.y, sides.z)) <= across * static_cast<double>(summary.size_m);
}

/// What stands for several that a focus may reach into is in it as a whole.
std::uint8_t GlyphSelection::degree_of(const GlyphSummary& summary) const {
    if (settings_.focus == nullptr) return SelectedGlyph::kInFocus;
    const GlyphFocus& focus = *settings_.focus;
    const double value = value_of(summary, field_->values());
    double greatest = 0;
    for (std::size_t n = 0; n < focus.regions->size(); ++n) {
        const FocusRegion& region = (*focus.regions)[n];
        if (!region.is_valid) continue;
        const glm::dvec3 place = field_->frame().anchor + field_->frame().axes * glm::dvec3(summary.place);
        const double by_place = focus_degree(region, place, height_m(region, place));
        const double by_value = focus.by_value[n] ? degree_of_value(focus.ranges[n], value) : 0;
        greatest = std::fmax(greatest, focus.by_value[n] ? by_value : by_place);
    }
    return code_of(is_aggregate(summary) && greatest_degree(summary) >= 1 ? 1 : greatest);
}

double GlyphSelection::distance_m(const GlyphSummary& summary) const {
    return std::fmax(glm::length(glm::dvec3(summary.place) - eye_), kMinDistance_m);
}

/// Of a square that covers as much of the view as the box round the members' glyphs, which are taken half as high as wide; of one
/// place its own size.
double GlyphSelection::extent_m(const GlyphSummary& summary) const {
    if (!is_aggregate(summary)) return summary.size_m;
    const double half_m = 0.5 * summary.size_m;
    const glm::dvec3 sides = 2.0 * (glm::dvec3(summary.reach_m) + glm::dvec3(half_m, half_m, 0.5 * half_m));
    const glm::dvec3 ray = glm::abs(glm::dvec3(summary.place) - eye_) / distance_m(summary);
    return std::sqrt(ray.x * sides.y * sides.z + ray.y * sides.x * sides.z + ray.z * sides.x * sides.y);
}

double GlyphSelection::px_of(double length_m, double distance_m) const { return length_m * focal_px_ / distance_m; }

/// Takes those planes away within which the sphere lies wholly.
bool GlyphSelection::is_in_view(const GlyphSummary& summary, double room_m, unsigned& planes) const {
    for (int n = 0; n < kPlanes; ++n) {
        if ((planes >> n & 1u) == 0) continue;
        const double inside_m = glm::dot(planes_[n].inwards, glm::dvec3(summary.place)) + planes_[n].offset_m;
        if (inside_m < -room_m) return false;
        if (inside_m >= room_m) planes &= ~(1u << n);
    }
    return true;
}

/// False, and its members are hidden, where none of it is in view.
bool GlyphSelection::enters(Part& part) {
    const GlyphSummary& summary = field_->summary(part.ref);
    if (settings_.focus != nullptr && settings_.focus->hides_context && !(greatest_degree(summary) > 0)) {
        counts_.hidden += summary.members;
        return false;
    }
    if (part.planes == 0 || is_in_view(summary, radius_m(summary) + 0.5 * summary.size_m, part.planes)) return true;
    counts_.hidden += summary.members;
    return false;
}

/// It is not to be parted: a leaf, or so small on the screen that its members have no glyphs of their own.
bool GlyphSelection::is_whole(const Part& part) {
    if (part.ref.is_leaf()) return true;
    const GlyphSummary& summary = field_->summary(part.ref);
    if (stands_for_all(summary)) return true;
    const double distance = distance_m(summary), nearest = distance - radius_m(summary), larger = coarser(summary);
    return px_of(extent_m(summary), distance) <= settings_.cell_px * larger && nearest > 0 &&
           px_of(summary.size_m, nearest) < settings_.least_px * larger;
}

void GlyphSelection::emit(const Part& part) {
    const GlyphSummary& summary = field_->summary(part.ref);
    unsigned planes = part.planes;
    const double distance = distance_m(summary);
    const double own_px = px_of(summary.size_m, distance);
    const double larger = coarser(summary);
    const double whole_px = std::fmin(px_of(extent_m(summary), distance), std::fmax(settings_.cell_px * larger, own_px));
    const double size_px = std::fmin(std::fmax(whole_px, settings_.least_px), settings_.most_px);
    const double size_m = size_px * distance / focal_px_;
    if (planes != 0 && !is_in_view(summary, 0.5 * std::fmax(size_m, summary.size_m), planes)) {
        counts_.hidden += summary.members;
        return;
    }
    const std::uint8_t degree = degree_of(summary);
    if (degree == 0 && settings_.focus->hides_context) {
        counts_.hidden += summary.members;
        return;
    }
    SelectedGlyph& glyph = glyphs_[counts_.glyphs++];
    glyph.summary = summary;
    glyph.summary.place = glm::vec3(field_->frame().axes * (glm::dvec3(summary.place) - eye_));
    glyph.size_m = static_cast<float>(size_m);
    glyph.size_px = static_cast<float>(size_px);
    glyph.is_aggregate = is_aggregate(summary);
    glyph.degree = degree;
    (glyph.is_aggregate ? counts_.aggregated : counts_.drawn) += summary.members;
}

/// False where there are more glyphs than may be drawn.
bool GlyphSelection::select_all() {
    Part stack[kMaxParts];
    std::size_t count = 0;
    Part root{field_->root(), kAllPlanes, 0};
    if (enters(root)) stack[count++] = root;
    while (count > 0) {
        const Part part = stack[--count];
        if (is_whole(part)) {
            if (counts_.glyphs >= settings_.most_drawn) return false;
            emit(part);
            continue;
        }
        for (const GlyphRef ref : field_->group(part.ref).parts) {
            Part half{ref, part.planes, 0};
            if (enters(half)) stack[count++] = half;
        }
    }
    return true;
}

/// Those that wait and those selected are never more than may be drawn, so that what waits at the end can be drawn as it is.
void GlyphSelection::select_largest() {
    const auto comes_after = [](const Part& a, const Part& b) {
        if (a.extent_px != b.extent_px) return a.extent_px < b.extent_px;
        return a.ref.index() > b.ref.index();
    };
    std::uint32_t count = 0;
    const auto take = [&](Part part) {
        if (!enters(part)) return;
        if (is_whole(part)) {
            emit(part);
            return;
        }
        const GlyphSummary& summary = field_->summary(part.ref);
        part.extent_px = static_cast<float>(px_of(extent_m(summary), distance_m(summary)));
        waiting_[count++] = part;
        std::push_heap(waiting_.begin(), waiting_.begin() + count, comes_after);
    };
    if (settings_.most_drawn == 0) {
        counts_.over_most = counts_.hidden = field_->given();
        return;
    }
    take({field_->root(), kAllPlanes, 0});
    while (count > 0 && counts_.glyphs + count < settings_.most_drawn) {
        const Part part = waiting_[0];
        std::pop_heap(waiting_.begin(), waiting_.begin() + count, comes_after);
        --count;
        for (const GlyphRef ref : field_->group(part.ref).parts) take({ref, part.planes, 0});
    }
    for (std::uint32_t n = 0; n < count; ++n) {
        counts_.over_most += field_->summary(waiting_[n].ref).members;
        emit(waiting_[n]);
    }
}

}  // namespace tedavis::scene
