#include "render_core/scene/glyph_selection.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace tedavis::scene {
namespace {

constexpr double kLeastDistance_m = 0.01;

bool is_aggregate(const GlyphSummary& summary) { return summary.members > 1; }

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
    planes_[0] = {glm::normalize(forward * view.half_width_tangent + right), 0};
    planes_[1] = {glm::normalize(forward * view.half_width_tangent - right), 0};
    planes_[2] = {glm::normalize(forward * view.half_height_tangent + down), 0};
    planes_[3] = {glm::normalize(forward * view.half_height_tangent - down), 0};
    planes_[4] = {forward, -view.near_m};
    planes_[5] = {-forward, view.far_m};
    for (Plane& plane : planes_) plane.offset_m -= glm::dot(plane.inwards, eye_);
}

double GlyphSelection::distance_m(const GlyphSummary& summary) const {
    return std::fmax(glm::length(glm::dvec3(summary.place) - eye_), kLeastDistance_m);
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
    if (part.planes == 0 || is_in_view(summary, radius_m(summary) + 0.5 * summary.size_m, part.planes)) return true;
    counts_.hidden += summary.members;
    return false;
}

/// It is not to be parted: a leaf, or so small on the screen that its members have no glyphs of their own.
bool GlyphSelection::is_whole(const Part& part) {
    if (part.ref.is_leaf()) return true;
    const GlyphSummary& summary = field_->summary(part.ref);
    const double distance = distance_m(summary), nearest = distance - radius_m(summary);
    return px_of(extent_m(summary), distance) <= settings_.cell_px && nearest > 0 &&
           px_of(summary.size_m, nearest) < settings_.least_px;
}

void GlyphSelection::emit(const Part& part) {
    const GlyphSummary& summary = field_->summary(part.ref);
    unsigned planes = part.planes;
    const double distance = distance_m(summary);
    const double own_px = px_of(summary.size_m, distance);
    const double whole_px = std::fmin(px_of(extent_m(summary), distance), std::fmax(settings_.cell_px, own_px));
    const double size_px = std::fmin(std::fmax(whole_px, settings_.least_px), settings_.most_px);
    const double size_m = size_px * distance / focal_px_;
    if (planes != 0 && !is_in_view(summary, 0.5 * std::fmax(size_m, summary.size_m), planes)) {
        counts_.hidden += summary.members;
        return;
    }
    SelectedGlyph& glyph = glyphs_[counts_.glyphs++];
    glyph.summary = summary;
    glyph.summary.place = glm::vec3(field_->frame().axes * (glm::dvec3(summary.place) - eye_));
    glyph.size_m = static_cast<float>(size_m);
    glyph.size_px = static_cast<float>(size_px);
    glyph.is_aggregate = is_aggregate(summary);
    (glyph.is_aggregate ? counts_.aggregated : counts_.drawn) += summary.members;
}

/// False where there are more glyphs than may be drawn.
bool GlyphSelection::select_all() {
    Part stack[kMostParts];
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
