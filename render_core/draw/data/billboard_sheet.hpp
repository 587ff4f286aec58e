/// Where the billboards of a frame stand: they face the eye, have sizes in pixels, and cover neither each other nor the
/// symbology, which has its room before them: who comes first has the room that is left. A sign is drawn whole or not at all:
/// over the picture where the eye sees its place, lifted by kStem (as high as icons stand on their stems), over the drawn
/// terrain; else it is hidden. Stems and links have the depths of their ends, and terrain hides them pixel by pixel, but says
/// nothing wrong by that.
///
///   start(arena) · begin(...) each frame · spot(place), claim(box, place), signs(), line()
///
/// Thread  one. Memory  from an arena, once. Failure  claim() refuses what has no room; the batch counts what it refuses.
#pragma once

#include <glm/vec3.hpp>

#include "render_core/base/memory_budget.hpp"
#include "render_core/draw/data/sign_view.hpp"
#include "render_core/draw/quad_batch.hpp"
#include "render_core/draw/screen_cover.hpp"
#include "render_core/terrain/line_of_sight.hpp"

namespace tedavis::draw {

/// A feature that may be shown. Of two the one with the smaller rank comes first, of equals the first.
struct BillboardCandidate {
    double rank = 0;
    std::uint32_t feature = 0;
};

class BillboardSheet {
public:
    static constexpr std::size_t kMaxCandidates = 256, kMaxBoxes = 256;
    static constexpr float kStem = kSignStem;

    [[nodiscard]] bool start(base::Arena& arena);
    struct Frame {
        QuadBatch &signs, &links;  ///< to be drawn over the picture, and among the terrain
        const terrain::View& view;
        double text_px = 16;                    ///< of the display's ordinary text
        terrain::LineOfSight* sight = nullptr;  ///< null: nothing stands in the way
        const QuadBatch* symbology = nullptr;   ///< of the frame, which signs keep clear of; null: there is none
        float margin_px = 0;                    ///< of the view's picture, that the screen does not show, on both sides together
        float screen_begins_px = 0;             ///< in that picture, where the symbology's left edge is
    };
    /// Empties the batches. What the frame refers to must stay until the last sign is drawn.
    void begin(const Frame& frame);

    [[nodiscard]] QuadBatch& signs() const { return *signs_; }
    [[nodiscard]] const SignView& eye() const { return eye_; }
    [[nodiscard]] const terrain::View& view() const { return eye_.view; }
    [[nodiscard]] float text_px() const { return eye_.text_px; }
    using Spot = SignSpot;
    /// Where the view's magnifiers show the place.
    [[nodiscard]] Spot spot(const glm::dvec3& place) const { return eye_.spot(place); }
    [[nodiscard]] double seen_distance_m(double distance_m) const { return eye_.seen_distance_m(distance_m); }
    /// From one place to another over a dark rim of the same opacity, both ends with their own depths; nothing where one is not
    /// ahead.
    void line(const Spot& from, const Spot& to, float width_px, design::Color color) const;
    /// The same from a spot to its sign, which stands as far away.
    void stem(const Spot& spot, Point to, float width_px, design::Color color) const;
    /// The same from what floats down to the ground, with a mark where it stands.
    void link(const Spot& ground, const Spot& top, design::Color color) const;
    static constexpr std::size_t kStemVertices = 4 * 2, kLinkVertices = 4 * 4;
    /// Whether the batches take so many vertices, so that nothing is drawn by half.
    [[nodiscard]] bool has_room(std::size_t sign_vertices, std::size_t link_vertices) const;
    /// The part of the picture that is shown.
    [[nodiscard]] const Rect& screen() const { return screen_; }
    [[nodiscard]] bool is_in_picture(const Rect& box) const { return screen_.contains(box); }
    /// Whether no drawn terrain stands before a place (ECEF), or what stands there as high as a stem.
    [[nodiscard]] bool is_seen(const glm::dvec3& place) const;
    /// Whether a box lies within the picture, clear of the symbology, and covers none that is taken.
    [[nodiscard]] bool is_free(const Rect& box) const;
    /// The same, whatever the symbology draws there.
    [[nodiscard]] bool is_clear_of_signs(const Rect& box) const;
    /// True, and the box is taken, where it is free and the eye sees the place (ECEF) of the sign that it holds.
    [[nodiscard]] bool claim(const Rect& box, const glm::dvec3& place) {
        return is_free(box) && claim_under_symbology(box, place);
    }
    /// The same, whatever the symbology draws over it: of what nobody may miss.
    [[nodiscard]] bool claim_under_symbology(const Rect& box, const glm::dvec3& place);
    /// That are taken.
    [[nodiscard]] base::Span<const Rect> boxes() const { return {boxes_.data(), box_count_}; }
    /// True, and the box is taken, where it is free: of what stands beside a sign that has its room.
    [[nodiscard]] bool claim_beside(const Rect& box);

    /// Candidates of one element: the best kMaxCandidates of those that are offered.
    void begin_candidates() { candidate_count_ = 0; }
    void offer(const BillboardCandidate& candidate);
    /// The best first.
    [[nodiscard]] base::Span<const BillboardCandidate> ranked();

private:
    /// A line's end stands nearer by what a sight ends before its place, or the ground that it stands on would cut into it.
    [[nodiscard]] double before_m(const Spot& spot) const { return spot.distance_m * terrain::LineOfSight::reach(view()); }
    void rimmed_line(Point from, Point to, float width_px, design::Color color) const;

    QuadBatch *signs_ = nullptr, *links_ = nullptr;
    terrain::LineOfSight* sight_ = nullptr;
    Rect screen_{};
    ScreenCover symbology_;
    SignView eye_;
    base::Span<Rect> boxes_;
    base::Span<BillboardCandidate> candidates_;
    std::size_t box_count_ = 0, candidate_count_ = 0;
};

}  // namespace tedavis::draw
