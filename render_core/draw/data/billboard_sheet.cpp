#include "render_core/draw/data/billboard_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace tedavis::draw {
namespace {

/// Depths of lines are interpolated in the picture; far outside of it floats do not hold their places.
constexpr float kFarthest_px = 32'000;

bool comes_first(const BillboardCandidate& a, const BillboardCandidate& b) {
    return a.rank < b.rank || (a.rank == b.rank && a.feature < b.feature);
}

}  // namespace

bool BillboardSheet::start(base::Arena& arena) {
    boxes_ = arena.allocate_array<Rect>(kMostBoxes);
    candidates_ = arena.allocate_array<BillboardCandidate>(kMostCandidates);
    return !boxes_.empty() && !candidates_.empty();
}

void BillboardSheet::begin(QuadBatch& batch, const terrain::View& view, double text_px) {
    batch_ = &batch;
    batch.clear();
    view_ = view;
    text_px_ = static_cast<float>(text_px);
    box_count_ = 0;
}

BillboardSheet::Spot BillboardSheet::spot(const glm::dvec3& place) const {
    const glm::dvec3 from_eye = place - view_.eye;
    Spot result;
    result.distance_m = glm::dot(from_eye, view_.forward);
    if (!(result.distance_m > view_.near_m)) return result;
    const double x = 0.5 * view_.width + view_.focal_px * glm::dot(from_eye, view_.right) / result.distance_m;
    const double y = 0.5 * view_.height + view_.focal_px * glm::dot(from_eye, view_.down) / result.distance_m;
    result.at = {static_cast<float>(x), static_cast<float>(y)};
    result.is_ahead = std::abs(result.at.x) < kFarthest_px && std::abs(result.at.y) < kFarthest_px;
    return result;
}

void BillboardSheet::line(const Spot& from, const Spot& to, float width_px, design::Color color) const {
    if (!from.is_ahead || !to.is_ahead) return;
    batch_->set_distance(from.distance_m * kNearer, to.distance_m * kNearer);
    static_cast<void>(batch_->line(from.at, to.at, width_px, color));
}

bool BillboardSheet::has_room(std::size_t vertices) const { return batch_->use().capacity - batch_->use().in_use >= vertices; }

bool BillboardSheet::claim(const Rect& box) {
    const Rect picture{0, 0, static_cast<float>(view_.width), static_cast<float>(view_.height)};
    if (!picture.contains(box) || box_count_ == boxes_.size()) return false;
    for (std::size_t n = 0; n < box_count_; ++n)
        if (boxes_[n].overlaps(box)) return false;
    boxes_[box_count_++] = box;
    return true;
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
