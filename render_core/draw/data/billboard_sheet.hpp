/// Allocates the room of a frame's billboards. They face the viewer, have sizes in pixels, and cover neither each other nor the
/// symbology, which is placed before them; among billboards the first one claims the room. A sign is drawn whole, over the
/// picture, where its position, lifted by kStem (the height of icons on their stems), is visible above the drawn terrain; else
/// it is hidden. Stems and links have depths, and terrain hides them pixel by pixel.
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

/// A feature that may be shown. Smaller ranks come first; equal ranks keep their order.
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
        QuadBatch &signs, &links;  ///< drawn over the picture; drawn with depth test
        const terrain::View& view;
        double text_px = 16;                    ///< size of the display's ordinary text
        terrain::LineOfSight* sight = nullptr;  ///< null: nothing is hidden
        const QuadBatch* symbology = nullptr;   ///< the frame's symbology, which signs must not cover; null: none
        float margin_px = 0;                    ///< off-screen width of the view's picture, both sides
        float screen_begins_px = 0;             ///< left edge of the screen in that picture
    };
    /// Begins a frame and clears the batches. Everything that `frame` refers to must stay valid until the last sign is drawn.
    void begin(const Frame& frame);

    [[nodiscard]] QuadBatch& signs() const { return *signs_; }
    [[nodiscard]] const SignView& eye() const { return eye_; }
    [[nodiscard]] const terrain::View& view() const { return eye_.view; }
    [[nodiscard]] float text_px() const { return eye_.text_px; }
    using Spot = SignSpot;
    /// Returns the screen position of a point, with the view's magnifiers applied.
    [[nodiscard]] Spot spot(const glm::dvec3& place) const { return eye_.spot(place); }
    [[nodiscard]] double seen_distance_m(double distance_m) const { return eye_.seen_distance_m(distance_m); }
    /// Draws a line between two points over a dark rim of the same opacity, with the depths of both ends; nothing where one of
    /// them is not ahead.
    void line(const Spot& from, const Spot& to, float width_px, design::Color color) const;
    /// The same from a point to its sign, which has the same depth.
    void stem(const Spot& spot, Point to, float width_px, design::Color color) const;
    /// The same from an object in the air down to the ground, with a mark on the ground.
    void link(const Spot& ground, const Spot& top, design::Color color) const;
    static constexpr std::size_t kStemVertices = 4 * 2, kLinkVertices = 4 * 4;
    /// True where the batches have room for this many vertices, so that nothing is drawn partly.
    [[nodiscard]] bool has_room(std::size_t sign_vertices, std::size_t link_vertices) const;
    /// The part of the picture that is on the screen.
    [[nodiscard]] const Rect& screen() const { return screen_; }
    [[nodiscard]] bool is_in_picture(const Rect& box) const { return screen_.contains(box); }
    /// True where no drawn terrain hides a point (ECEF) lifted by a stem.
    [[nodiscard]] bool is_seen(const glm::dvec3& place) const;
    /// True where a box lies within the picture and overlaps neither the symbology nor claimed boxes.
    [[nodiscard]] bool is_free(const Rect& box) const;
    /// The same, ignoring the symbology.
    [[nodiscard]] bool is_clear_of_signs(const Rect& box) const;
    /// Claims the box and returns true where it is free and the sign's position (ECEF) is visible.
    [[nodiscard]] bool claim(const Rect& box, const glm::dvec3& place) {
        return is_free(box) && claim_under_symbology(box, place);
    }
    /// The same, ignoring the symbology: for signs that must be shown.
    [[nodiscard]] bool claim_under_symbology(const Rect& box, const glm::dvec3& place);
    /// The claimed boxes.
    [[nodiscard]] base::Span<const Rect> boxes() const { return {boxes_.data(), box_count_}; }
    /// Claims a free box and returns true: for parts beside a sign that has been placed.
    [[nodiscard]] bool claim_beside(const Rect& box);

    /// Begins the candidates of one element; the best kMaxCandidates are kept.
    void begin_candidates() { candidate_count_ = 0; }
    void offer(const BillboardCandidate& candidate);
    /// Returns the candidates, the best first.
    [[nodiscard]] base::Span<const BillboardCandidate> ranked();

private:
    /// Depth of a line's end: a line of sight ends before its target by the same share, so that the ground does not cut the
    /// line.
    [[nodiscard]] double before_m(const Spot& spot) const { return spot.distance_m * terrain::LineOfSight::reach(view()); }
    void rimmed_line(Point from, Point to, float width_px, design::Color color) const;
    [[nodiscard]] const ScreenCover& symbology_cover() const;

    QuadBatch *signs_ = nullptr, *links_ = nullptr;
    terrain::LineOfSight* sight_ = nullptr;
    Rect screen_{};
    const QuadBatch* symbology_ = nullptr;
    float symbology_right_px_ = 0;
    mutable ScreenCover symbology_cover_;  ///< found when a sign first asks for it: most frames have none
    mutable bool is_cover_found_ = false;
    SignView eye_;
    base::Span<Rect> boxes_;
    base::Span<BillboardCandidate> candidates_;
    std::size_t box_count_ = 0, candidate_count_ = 0;
};

}  // namespace tedavis::draw
