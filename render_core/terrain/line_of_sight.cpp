#include "render_core/terrain/line_of_sight.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/earth/magnified_segment.hpp"
#include "render_core/terrain/chunk_mesh.hpp"
#include "render_core/terrain/stored_triangles.hpp"

namespace tedavis::terrain {
namespace {

constexpr double kWider_m = 1e-3;
constexpr double kBoxSlack_m = 1;  // boxes are kept in floats

/// From the eye; the way is looked at between two shares of it.
struct Sight {
    glm::dvec3 way;
    double from = 0, to = 0;
    glm::dvec3 across, above;  ///< unit normals of two planes that meet in it
};

glm::dvec3 normal_to(const glm::dvec3& way, const glm::dvec3& up) {
    const glm::dvec3 normal = glm::cross(way, up);
    const double length = glm::length(normal);
    constexpr double kMinSine = 1e-6;
    if (length > kMinSine * glm::length(way)) return normal / length;
    // Along the vertical any plane serves: the axis that the way follows least gives one.
    const glm::dvec3 size = glm::abs(way);
    const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                            : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                 : glm::dvec3(0, 0, 1);
    return glm::normalize(glm::cross(way, axis));
}

Sight sight_of(const glm::dvec3& eye, const glm::dvec3& way, double from, double to) {
    Sight sight{way, from, to, {}, {}};
    sight.across = normal_to(way, glm::normalize(eye));
    sight.above = glm::normalize(glm::cross(sight.across, way));
    return sight;
}

glm::dvec3 centre_of(const ChunkEntry& entry, const glm::dvec3& eye) {
    return glm::dvec3(entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]) - eye;
}

/// Of the chunk's box, stretched upwards by its lifts.
bool meets_box(const SelectedChunk& chunk, const glm::dvec3& eye, const Sight& sight) {
    const ChunkEntry& entry = *chunk.entry;
    const glm::dvec3 centre = centre_of(entry, eye);
    const double lift_m = double{greatest_lift_m(chunk.lift)};
    double first = sight.from, last = sight.to;
    for (int a = 0; a < 3; ++a) {
        const glm::dvec3 axis(entry.axes[3 * a], entry.axes[3 * a + 1], entry.axes[3 * a + 2]);
        const double half = double{entry.half_extent_m[a]} + kBoxSlack_m, along = glm::dot(sight.way, axis);
        const double middle = glm::dot(centre, axis);
        const double low = middle - half - (a == 2 ? lift_m : 0.0), high = middle + half;  // the third axis leads down
        if (along == 0) {
            if (low > 0 || high < 0) return false;
            continue;
        }
        const double at_low = low / along, at_high = high / along;
        first = std::fmax(first, std::fmin(at_low, at_high));
        last = std::fmin(last, std::fmax(at_low, at_high));
    }
    return first <= last;
}

/// Whether the sight passes at the left of the line from a to b, seen from the eye, or on it.
bool is_inside(const Sight& sight, const glm::dvec3& a, const glm::dvec3& b) {
    const double inside = -glm::dot(sight.way, glm::cross(a, b));
    return inside >= 0 || inside >= -kWider_m * glm::length(glm::cross(sight.way, b - a));
}

/// Whether the sight enters a triangle from its front, which is counter-clockwise.
bool enters(const Sight& sight, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double against = -glm::dot(normal, sight.way);
    if (!(against > 0)) return false;
    const double at = -glm::dot(normal, a) / against;
    return at >= sight.from && at <= sight.to && is_inside(sight, a, b) && is_inside(sight, b, c) && is_inside(sight, c, a);
}

/// A chunk whose box the sight meets.
class ChunkLook {
public:
    ChunkLook(const Lattice& lattice, const SelectedChunk& chunk, base::Span<const ChunkVertex> vertices, const glm::dvec3& eye,
              const Sight& sight)
        : lattice_(lattice),
          chunk_(chunk),
          vertices_(vertices.data()),
          count_(vertices.size() < kMaxChunkVertices ? static_cast<std::uint32_t>(vertices.size()) : kMaxChunkVertices),
          posts_(lattice.posts_of(chunk.key)),
          centre_(centre_of(*chunk.entry, eye)),
          sight_(sight) {
        record_sides();
        record_taken_out();
    }

    /// Whether the sight can meet the chunk at all.
    [[nodiscard]] bool reaches_both_sides() const { return (all_ & kBothSides) == kBothSides; }

    /// Of those that are drawn as they are stored; the others are noted for needs_drawn().
    [[nodiscard]] bool meets_stored(base::Span<const std::uint16_t> stored) {
        bool met = false;
        static_cast<void>(each_stored_triangle(*chunk_.entry, {vertices_, count_}, stored,
                                               [&](std::uint16_t a, std::uint16_t b, std::uint16_t c) {
                                                   if (a >= count_ || b >= count_ || c >= count_) return true;
                                                   const unsigned sides = sides_[a] | sides_[b] | sides_[c];
                                                   if ((sides & kTakenOut) != 0) {
                                                       if ((sides & kAcross) == kAcross) replaced_ |= kAcross;
                                                       replaced_ |= sides & kAbove;
                                                       return true;
                                                   }
                                                   met = (sides & kBothSides) == kBothSides && meets(a, b, c);
                                                   return !met;
                                               }));
        return met;
    }
    [[nodiscard]] bool needs_drawn() const { return (replaced_ & kBothSides) == kBothSides; }

    [[nodiscard]] bool meets_drawn(base::Span<const std::uint16_t> indices) const {
        const std::uint16_t* const index = indices.data();
        for (std::size_t n = 0; n + 2 < indices.size(); n += 3) {
            const std::uint16_t a = index[n], b = index[n + 1], c = index[n + 2];
            if (((sides_[a] | sides_[b] | sides_[c]) & kBothSides) == kBothSides && meets(a, b, c)) return true;
        }
        return false;
    }

private:
    static constexpr unsigned kAcross = 3, kAbove = 12, kBothSides = kAcross | kAbove, kTakenOut = 16;

    /// On both sides where it lies so near a plane that its lift or rounding may move it to the other.
    void record_sides() {
        const double margin = 2 * kWider_m + double{greatest_lift_m(chunk_.lift)};
        const glm::dvec3 &across = sight_.across, &above = sight_.above;
        const double across_0 = glm::dot(across, centre_), above_0 = glm::dot(above, centre_);
        for (std::uint32_t n = 0; n < count_; ++n) {
            const glm::dvec3 v(double{vertices_[n].x}, double{vertices_[n].y}, double{vertices_[n].z});
            const double x = across_0 + glm::dot(across, v), y = above_0 + glm::dot(above, v);
            const unsigned sides =
                (x >= -margin ? 1u : 0u) | (x <= margin ? 2u : 0u) | (y >= -margin ? 4u : 0u) | (y <= margin ? 8u : 0u);
            sides_[n] = static_cast<std::uint8_t>(sides);
            all_ |= sides;
        }
    }

    void record_taken_out() {
        if (chunk_.coarser_edges == 0) return;
        for (std::uint32_t n = 0; n < chunk_.entry->border_count && n < count_; ++n)
            if (is_taken_out(vertices_[n], posts_.i1 - posts_.i0, posts_.j1 - posts_.j0, chunk_.coarser_edges))
                sides_[n] = static_cast<std::uint8_t>(sides_[n] | kTakenOut);
    }

    [[nodiscard]] glm::dvec3 place(std::uint16_t n) const {
        return centre_ + drawn_position(lattice_, chunk_, posts_, vertices_[n]);
    }
    [[nodiscard]] bool meets(std::uint16_t a, std::uint16_t b, std::uint16_t c) const {
        return enters(sight_, place(a), place(b), place(c));
    }

    const Lattice& lattice_;
    const SelectedChunk& chunk_;
    const ChunkVertex* vertices_;
    std::uint32_t count_;
    PostRange posts_;
    glm::dvec3 centre_;
    const Sight& sight_;
    std::uint8_t sides_[kMaxChunkVertices];
    unsigned all_ = 0, replaced_ = 0;
};

}  // namespace

base::Span<const std::uint16_t> LineOfSight::drawn_indices(const SelectedChunk& chunk) {
    if (built_ != &chunk) built_indices_ = meshes_.drawn_indices(chunk);
    built_ = &chunk;
    return built_indices_;
}

double LineOfSight::reach(const View& view) { return 1 - kTail * std::fmin(2 * view.half_width_tangent(), 1.0); }

bool LineOfSight::is_hidden(const glm::dvec3& place) {
    const glm::dvec3 way = view_.magnifiers.moved(place) - view_.eye;
    const double depth_m = glm::dot(way, view_.forward);
    if (view_.is_flat() || !(depth_m * reach(view_) > view_.near_m)) return false;
    const double from = view_.near_m / depth_m, to = reach(view_);
    if (view_.magnifiers.empty()) return is_blocked(view_.eye, way, from, to);
    return earth::any_true_segment(
        view_.magnifiers, {view_.eye + way * from, view_.eye + way * to},
        [&](const earth::TrueSegment& part) { return is_blocked(part.begin, part.end - part.begin, 0, 1); });
}

bool LineOfSight::is_blocked(const glm::dvec3& eye, const glm::dvec3& way, double from, double to) {
    const Sight sight = sight_of(eye, way, from, to);
    for (const SelectedChunk& chunk : selected_) {
        if (!meets_box(chunk, eye, sight)) continue;
        ChunkLook look(lattice_, chunk, meshes_.vertices(chunk), eye, sight);
        if (!look.reaches_both_sides()) continue;
        if (look.meets_stored(meshes_.stored_indices(chunk))) return true;
        if (look.needs_drawn() && look.meets_drawn(drawn_indices(chunk))) return true;
    }
    return false;
}

}  // namespace tedavis::terrain
