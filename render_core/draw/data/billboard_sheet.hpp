/// Where the billboards of a frame stand: they face the eye, have sizes in pixels, and never cover each other: who comes first
/// has the room. Depths are those of their places, so that terrain hides them (quad_drawer.hpp).
///
///   start(arena) · begin(...) each frame · spot(place), claim(box), batch()
///
/// Thread  one. Memory  from an arena, once. Failure  claim() refuses what has no room; the batch counts what it refuses.
#pragma once

#include <glm/vec3.hpp>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/memory_budget.hpp"
#include "render_core/draw/quad_batch.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::draw {

/// A feature that may be shown. Of two the one with the smaller rank comes first, of equals the first.
struct BillboardCandidate {
    double rank = 0;
    std::uint32_t feature = 0;
};

class BillboardSheet {
public:
    static constexpr std::size_t kMostCandidates = 256, kMostBoxes = 256;
    /// A place stands nearer by this share, or the ground that it stands on would cut into its billboard.
    static constexpr double kNearer = 0.995;

    [[nodiscard]] bool start(base::Arena& arena);
    /// Empties the batch. `batch` must stay; `text_px`: of the display's ordinary text.
    void begin(QuadBatch& batch, const terrain::View& view, double text_px);

    [[nodiscard]] QuadBatch& batch() const { return *batch_; }
    [[nodiscard]] const terrain::View& view() const { return view_; }
    [[nodiscard]] float text_px() const { return text_px_; }

    struct Spot {
        Point at;
        double distance_m = 0;  ///< along the view
        bool is_ahead = false;  ///< beyond the near plane; else the rest means nothing
    };
    [[nodiscard]] Spot spot(const glm::dvec3& place) const;
    /// What is drawn next stands there.
    void stand_at(const Spot& spot) const { batch_->set_distance(spot.distance_m * kNearer); }
    /// From one place to another, both with their own depths; nothing where one is not ahead.
    void line(const Spot& from, const Spot& to, float width_px, design::Color color) const;
    /// Whether the batch takes so many vertices, so that nothing is drawn by half.
    [[nodiscard]] bool has_room(std::size_t vertices) const;
    /// True, and the box is taken, where it lies within the picture and covers none that was taken before.
    bool claim(const Rect& box);

    /// Candidates of one element: the best kMostCandidates of those that are offered.
    void begin_candidates() { candidate_count_ = 0; }
    void offer(const BillboardCandidate& candidate);
    /// The best first.
    [[nodiscard]] base::Span<const BillboardCandidate> ranked();

private:
    QuadBatch* batch_ = nullptr;
    terrain::View view_{};
    float text_px_ = 16;
    base::Span<Rect> boxes_;
    base::Span<BillboardCandidate> candidates_;
    std::size_t box_count_ = 0, candidate_count_ = 0;
};

}  // namespace tedavis::draw
