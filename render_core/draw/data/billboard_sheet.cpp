#include "render_core/draw/data/billboard_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace tedavis::draw {
namespace {

constexpr float kCell = 0.5f;  // of the text's size: how finely the symbology's room is known

bool comes_first(const BillboardCandidate& a, const BillboardCandidate& b) {
    return a.rank < b.rank || (a.rank == b.rank && a.feature < b.feature);
}

}  // namespace

bool BillboardSheet::start(base::Arena& arena) {
    boxes_ = arena.allocate_array<Rect>(kMaxBoxes);
    candidates_ = arena.allocate_array<BillboardCandidate>(kMaxCandidates);
    return !boxes_.empty() && !candidates_.empty();
}

void BillboardSheet::begin(const Frame& frame) {
    signs_ = &frame.signs;
    links_ = &frame.links;
    sight_ = frame.sight;
    signs_->clear();
    links_->clear();
    eye_ = {frame.view, static_cast<float>(frame.text_px)};
    box_count_ = 0;
    symbology_ = frame.symbology;
    symbology_right_px_ = frame.screen_begins_px;
    is_cover_found_ = false;
    screen_ = {frame.screen_begins_px, 0, static_cast<float>(view().width) - frame.margin_px, static_cast<float>(view().height)};
}

void BillboardSheet::line(const Spot& from, const Spot& to, float width_px, design::Color color) const {
    if (!from.is_ahead || !to.is_ahead) return;
    links_->set_distance(before_m(from), before_m(to));
    rimmed_line(from.at, to.at, width_px, color);
}

void BillboardSheet::stem(const Spot& spot, Point to, float width_px, design::Color color) const {
    links_->set_distance(before_m(spot));
    rimmed_line(spot.at, to, width_px, color);
}

void BillboardSheet::link(const Spot& ground, const Spot& top, design::Color color) const {
    constexpr float kLine_px = 1.5f, kHalfFoot_px = 4;
    Spot left = ground, right = ground;
    left.at.x -= kHalfFoot_px;
    right.at.x += kHalfFoot_px;
    line(left, right, kLine_px, color);
    line(ground, top, kLine_px, color);
}

void BillboardSheet::rimmed_line(Point from, Point to, float width_px, design::Color color) const {
    constexpr float kRims_px = 2;
    static_cast<void>(links_->line(from, to, width_px + kRims_px, {0, 0, 0, color.alpha}));
    static_cast<void>(links_->line(from, to, width_px, color));
}

bool BillboardSheet::has_room(std::size_t sign_vertices, std::size_t link_vertices) const {
    const auto left = [](const QuadBatch& batch) { return batch.use().capacity - batch.use().in_use; };
    return left(*signs_) >= sign_vertices && left(*links_) >= link_vertices;
}

bool BillboardSheet::is_free(const Rect& box) const { return is_clear_of_signs(box) && symbology_cover().is_free(box); }

const ScreenCover& BillboardSheet::symbology_cover() const {
    if (is_cover_found_) return symbology_cover_;
    is_cover_found_ = true;
    symbology_cover_.clear(view().width, view().height, kCell * text_px());
    if (symbology_ != nullptr) symbology_cover_.take(*symbology_, symbology_right_px_);
    return symbology_cover_;
}

bool BillboardSheet::is_clear_of_signs(const Rect& box) const {
    if (!screen_.contains(box) || box_count_ == boxes_.size()) return false;
    for (std::size_t n = 0; n < box_count_; ++n)
        if (boxes_[n].overlaps(box)) return false;
    return true;
}

bool BillboardSheet::claim_under_symbology(const Rect& box, const glm::dvec3& place) {
    if (!is_clear_of_signs(box) || !is_seen(place)) return false;
    boxes_[box_count_++] = box;
    return true;
}

bool BillboardSheet::claim_beside(const Rect& box) {
    if (!is_free(box)) return false;
    boxes_[box_count_++] = box;
    return true;
}

/// As high over its place as a stem in its length in the picture: upright, so that seen from above nothing beside it hides it.
bool BillboardSheet::is_seen(const glm::dvec3& place) const {
    if (sight_ == nullptr) return true;
    const double distance_m = glm::dot(place - view().eye, view().forward);  // as good as that where it is shown
    const double stem_m = static_cast<double>(kStem * text_px()) * distance_m / view().focal_px;
    return !sight_->is_hidden(place + glm::normalize(place) * stem_m);
}

/// A heap with the last one on top: a better one takes its place.
void BillboardSheet::offer(const BillboardCandidate& candidate) {
    if (!std::isfinite(candidate.rank)) return;
    BillboardCandidate* const first = candidates_.data();
    if (candidate_count_ == candidates_.size()) {
        if (!comes_first(candidate, first[0])) return;
        std::pop_heap(first, first + candidate_count_--, comes_first);
    }
    first[candidate_count_++] = candidate;
    std::push_heap(first, first + candidate_count_, comes_first);
}

base::Span<const BillboardCandidate> BillboardSheet::ranked() {
    BillboardCandidate* const first = candidates_.data();
    std::sort_heap(first, first + candidate_count_, comes_first);
    return {first, candidate_count_};
}

}  // namespace tedavis::draw
