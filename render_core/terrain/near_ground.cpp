#include "render_core/terrain/near_ground.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render_core/base/units.hpp"
#include "render_core/terrain/projected_error.hpp"
#include "render_core/terrain/regular_chunk.hpp"

namespace tedavis::terrain {
namespace {

constexpr std::int64_t kCellsToEachSide = 6;
constexpr double kMarginOfNear = 0.02;      // errors beyond it are many pixels and call for finer chunks in any case
constexpr double kLeastRadius_m = 6335000;  // below the least radius of curvature of WGS84
constexpr double kRounding_m = 1e-6;        // of places in space, computed in doubles
constexpr double kFar_m = 1e9;

/// Cells of the lattice round the eye, by their posts. Columns of a lattice round the Earth may reach beyond its seam.
struct Zone {
    std::int64_t i0 = 0, i1 = 0, j0 = 0, j1 = 0;
};

/// The part of a zone that an exact chunk holds; columns as the zone counts them.
struct Piece {
    std::int64_t i0, i1, j0, j1;
};

enum class Cut : std::uint8_t { whole, too_many, unknown };

struct Pieces {
    Piece list[HeightQuery::kKeptChunks];
    std::uint32_t count = 0;
    double error_m = 0;        ///< largest of their chunks
    std::int64_t spacing = 1;  ///< of the coarsest, lattice posts
};

std::uint32_t column_of(const Lattice& lattice, std::int64_t i) {
    const std::int64_t round = std::int64_t{lattice.columns()} - 1;
    return static_cast<std::uint32_t>(lattice.is_closed() ? ((i % round) + round) % round : i);
}

Zone zone_round(const Lattice& lattice, std::int64_t i, std::int64_t j, std::int64_t reach) {
    Zone zone{i - reach, i + 1 + reach, std::max<std::int64_t>(j - reach, 0),
              std::min<std::int64_t>(j + 1 + reach, std::int64_t{lattice.rows()} - 1)};
    if (lattice.is_closed()) return zone;
    zone.i0 = std::max<std::int64_t>(zone.i0, 0);
    zone.i1 = std::min<std::int64_t>(zone.i1, std::int64_t{lattice.columns()} - 1);
    return zone;
}

bool goes_round_or_to_pole(const Lattice& lattice, const Zone& zone) {
    if (lattice.is_closed() && zone.i1 - zone.i0 + 1 >= std::int64_t{lattice.columns()}) return true;
    if ((lattice.flags() & kLatticeNorthPole) != 0 && zone.j0 == 0) return true;
    return (lattice.flags() & kLatticeSouthPole) != 0 && zone.j1 == std::int64_t{lattice.rows()} - 1;
}

/// Row by row from chunk to chunk.
Cut cut(HeightQuery& heights, const Zone& zone, Pieces& pieces) {
    const Lattice& lattice = heights.lattice();
    pieces = {};
    for (std::int64_t j = zone.j0, next_j = 0; j < zone.j1; j = next_j) {
        next_j = zone.j1;
        const std::uint32_t first = pieces.count;
        for (std::int64_t i = zone.i0, next_i = 0; i < zone.i1; i = next_i) {
            if (pieces.count == HeightQuery::kKeptChunks) return Cut::too_many;
            const std::uint32_t column = column_of(lattice, i);
            const ExactChunk chunk = heights.exact_chunk(column, static_cast<std::uint32_t>(j));
            if (chunk.entry == nullptr) return Cut::unknown;
            const PostRange posts = lattice.posts_of(key_of(*chunk.entry));
            next_i = std::min<std::int64_t>(zone.i1, i + posts.i1 - column);
            next_j = std::min<std::int64_t>(next_j, posts.j1);
            pieces.error_m = std::max({pieces.error_m, double{chunk.entry->above_m}, double{chunk.entry->below_m}});
            pieces.spacing = std::max(pieces.spacing, std::int64_t{1} << chunk.entry->level);
            pieces.list[pieces.count++] = {i, next_i, j, 0};
        }
        for (std::uint32_t n = first; n < pieces.count; ++n) pieces.list[n].j1 = next_j;
    }
    return Cut::whole;
}

/// Between posts a flat triangle reaches a little beyond its meridians and parallels: by less than a cell, except at a pole.
Zone without_border(const Lattice& lattice, Zone zone, std::int64_t spacing) {
    if (lattice.is_closed() || zone.i0 > 0) zone.i0 += spacing;
    if (lattice.is_closed() || zone.i1 + 1 < std::int64_t{lattice.columns()}) zone.i1 -= spacing;
    if (zone.j0 > 0) zone.j0 += spacing;
    if (zone.j1 + 1 < std::int64_t{lattice.rows()}) zone.j1 -= spacing;
    return zone;
}

/// The surface beyond a zone's sides is farther from the eye than this.
double distance_beyond(const Lattice& lattice, const Zone& zone, const glm::dvec3& eye, const earth::Geodetic& place) {
    const double axis_m = std::hypot(eye.x, eye.y);
    const auto to_meridian = [&](std::int64_t i, double sign) {
        const double angle = sign * earth::angle_difference(place.longitude_rad, lattice.longitude_rad(column_of(lattice, i)));
        return axis_m * std::sin(std::clamp(angle, 0.0, 0.5 * base::kPi));
    };
    // All points of a latitude lie on a cone about the Earth's axis.
    const auto to_parallel = [&](std::int64_t j, double sign) {
        const double latitude = lattice.latitude_rad(static_cast<std::uint32_t>(j)), sine = std::sin(latitude);
        const double tip_m = -earth::kEccentricitySquared * earth::prime_vertical_radius_m(latitude) * sine;
        return std::max(sign * (axis_m * sine - (eye.z - tip_m) * std::cos(latitude)), 0.0);
    };
    double distance_m = kFar_m;
    if (lattice.is_closed() || zone.i0 > 0) distance_m = std::min(distance_m, to_meridian(zone.i0, 1));
    if (lattice.is_closed() || zone.i1 + 1 < std::int64_t{lattice.columns()})
        distance_m = std::min(distance_m, to_meridian(zone.i1, -1));
    if (zone.j0 > 0) distance_m = std::min(distance_m, to_parallel(zone.j0, 1));
    if (zone.j1 + 1 < std::int64_t{lattice.rows()}) distance_m = std::min(distance_m, to_parallel(zone.j1, -1));
    return distance_m;
}

/// Pixels that a metre of vertical error is, at most, on triangles in a view.
///
/// A point drawn at the tangents (x, y) by e above or below the true one, which is z deep, is e * focal * |u_xy - (x, y) u_z| / z
/// pixels off (projected_error.hpp). On a flat triangle 1/z is linear in x and y, and the length convex: over a polygon with
/// corners i their product stays below the largest (length_i / z_j + length_j / z_i) / 2, its Bernstein coefficients. The true
/// points lie within `error_m` of the triangles, straight above or below, and the drawn ones within `margin_m` of those.
class GroundScan {
public:
    GroundScan(const View& view, const glm::dvec3& down, double margin_m, double error_m)
        : view_(view),
          down_(in_view(down)),
          off_axis_(std::hypot(view.half_width_tangent(), view.half_height_tangent())),
          error_m_(error_m + kRounding_m),
          aside_m_(margin_m + error_m_),
          side_{{view.half_width_tangent(), aside_m_ * std::hypot(1.0, view.half_width_tangent())},
                {view.half_height_tangent(), aside_m_ * std::hypot(1.0, view.half_height_tangent())}} {}

    void include(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        Polygon part{{seen(a), seen(b), seen(c)}, 3};
        part = clipped(part, [this](const glm::dvec3& p) { return p.z - (view_.near_m - aside_m_); });
        for (int axis = 0; axis < 2; ++axis)
            for (const double sign : {-1.0, 1.0}) {
                const Side& side = side_[axis];
                part = clipped(part, [&](const glm::dvec3& p) { return side.tangent * p.z + side.margin_m - sign * p[axis]; });
            }
        include(part);
    }
    [[nodiscard]] double px_per_m() const { return view_.focal_px * largest_; }
    /// Of the highest corner below the eye.
    [[nodiscard]] double drop_m() const { return drop_m_; }

private:
    static constexpr int kMostCorners = 3 + 5;  // each plane adds one, but for slivers that rounding bends
    struct Polygon {
        glm::dvec3 corner[kMostCorners];
        int count;
        bool overflown = false;

        void add(const glm::dvec3& p) {
            if (count < kMostCorners)
                corner[count++] = p;
            else
                overflown = true;
        }
    };
    struct Side {
        double tangent, margin_m;
    };

    /// Right, down and ahead.
    [[nodiscard]] glm::dvec3 in_view(const glm::dvec3& d) const {
        return {glm::dot(d, view_.right), glm::dot(d, view_.down), glm::dot(d, view_.forward)};
    }
    [[nodiscard]] glm::dvec3 seen(const glm::dvec3& place) {
        const glm::dvec3 d = in_view(place - view_.eye);
        drop_m_ = std::min(drop_m_, glm::dot(d, down_));
        return d;
    }

    /// What lies where `inside` is not below zero: Sutherland and Hodgman, Reentrant polygon clipping (CACM 17, 1974).
    template <class Inside>
    static Polygon clipped(const Polygon& polygon, const Inside& inside) {
        Polygon part{{}, 0, polygon.overflown};
        for (int n = 0; n < polygon.count; ++n) {
            const glm::dvec3 &a = polygon.corner[n], &b = polygon.corner[n + 1 < polygon.count ? n + 1 : 0];
            const double of_a = inside(a), of_b = inside(b);
            if (of_a >= 0) part.add(a);
            if ((of_a >= 0) != (of_b >= 0)) part.add(a + (b - a) * (of_a / (of_a - of_b)));
        }
        return part;
    }

    void include(const Polygon& part) {
        if (part.overflown) largest_ = std::numeric_limits<double>::infinity();
        double farthest_m = 0, length[kMostCorners], nearness[kMostCorners];
        for (int n = 0; n < part.count; ++n) farthest_m = std::max(farthest_m, glm::length(part.corner[n]));
        for (int n = 0; n < part.count; ++n) {
            const glm::dvec3& p = part.corner[n];
            // The vertical there is another one, and the drawn point stands elsewhere in the picture.
            const double turned = farthest_m / kLeastRadius_m + aside_m_ / (p.z - aside_m_);
            length[n] = std::hypot(down_.x - p.x / p.z * down_.z, down_.y - p.y / p.z * down_.z) + turned * (1 + off_axis_);
            nearness[n] = 1 / (p.z - error_m_);
        }
        for (int a = 0; a < part.count; ++a)
            for (int b = 0; b <= a; ++b) largest_ = std::max(largest_, 0.5 * (length[a] * nearness[b] + length[b] * nearness[a]));
    }

    const View& view_;
    const glm::dvec3 down_;
    const double off_axis_, error_m_, aside_m_;
    const Side side_[2];
    double largest_ = 0, drop_m_ = kFar_m;
};

bool is_finite(const View& view) {
    return std::isfinite(glm::dot(view.forward, view.forward) + glm::dot(view.right, view.right) +
                         glm::dot(view.down, view.down) + view.focal_px + view.near_m);
}

/// The same of all that is farther away: the longest that the length can be is that of the view's farthest corner.
double px_per_m_beyond(const View& view, double distance_m, double margin_m) {
    const double corner = std::hypot(1.0, view.half_width_tangent(), view.half_height_tangent());
    const double depth_m = (distance_m - margin_m) / corner - margin_m;
    return depth_m > view.near_m ? view.focal_px * corner / depth_m : std::numeric_limits<double>::infinity();
}

/// The cells of an exact chunk.
class ChunkScan {
public:
    ChunkScan(const Lattice& lattice, const ExactChunk& chunk)
        : posts_(lattice.posts_of(key_of(*chunk.entry))),
          grid_(regular_grid(posts_.i1 - posts_.i0, posts_.j1 - posts_.j0, chunk.entry->level)),
          level_(chunk.entry->level),
          vertices_(chunk.vertices),
          centre_(chunk.entry->centre_m[0], chunk.entry->centre_m[1], chunk.entry->centre_m[2]) {}

    /// Those that a piece overlaps, whose first column is `column` of the lattice.
    void run(const Piece& piece, std::uint32_t column, GroundScan& scan) const {
        const Range columns = cells(std::int64_t{column} - posts_.i0, piece.i1 - piece.i0, grid_.columns);
        const Range rows = cells(piece.j0 - posts_.j0, piece.j1 - piece.j0, grid_.rows);
        for (std::uint32_t b = rows.first; b < rows.end; ++b)
            for (std::uint32_t a = columns.first; a < columns.end; ++a) {
                glm::dvec3 place[4];
                if (!corners_of(a, b, place)) continue;
                scan.include(place[0], place[2], place[1]);
                scan.include(place[3], place[1], place[2]);
            }
    }

private:
    struct Range {
        std::uint32_t first, end;
    };
    [[nodiscard]] Range cells(std::int64_t from, std::int64_t count, std::uint32_t posts) const {
        const std::int64_t end = (from + count + (std::int64_t{1} << level_) - 1) >> level_;
        return {static_cast<std::uint32_t>(from >> level_),
                static_cast<std::uint32_t>(std::min<std::int64_t>(end, std::int64_t{posts} - 1))};
    }
    /// North-west, north-east, south-west, south-east. False where all are void; triangles beside a void reach a little beyond
    /// their cells as well.
    bool corners_of(std::uint32_t a, std::uint32_t b, glm::dvec3* place) const {
        bool any = false;
        for (std::uint32_t n = 0; n < 4; ++n) {
            const ChunkVertex& v = vertices_[grid_.index_of(a + n % 2, b + n / 2)];
            any = any || v.post_class() != PostClass::void_;
            place[n] = centre_ + glm::dvec3(double{v.x}, double{v.y}, double{v.z});
        }
        return any;
    }

    const PostRange posts_;
    const RegularGrid grid_;
    const std::uint32_t level_;
    const base::Span<const ChunkVertex> vertices_;
    const glm::dvec3 centre_;
};

/// The widest zone round a cell that few chunks hold; false where there is none or not all of it can be had.
bool cut_round(HeightQuery& heights, std::int64_t i, std::int64_t j, std::int64_t most_reach, Zone& zone, Pieces& pieces) {
    Cut found = Cut::too_many;
    for (std::int64_t reach = most_reach; reach > 0 && found == Cut::too_many; reach /= 2) {
        zone = zone_round(heights.lattice(), i, j, reach);
        if (goes_round_or_to_pole(heights.lattice(), zone)) return false;
        found = cut(heights, zone, pieces);
    }
    return found == Cut::whole;
}

bool scan_pieces(HeightQuery& heights, const Pieces& pieces, GroundScan& scan) {
    for (std::uint32_t n = 0; n < pieces.count; ++n) {
        const Piece& piece = pieces.list[n];
        const std::uint32_t column = column_of(heights.lattice(), piece.i0);
        const ExactChunk chunk = heights.exact_chunk(column, static_cast<std::uint32_t>(piece.j0));
        if (chunk.entry == nullptr) return false;
        ChunkScan(heights.lattice(), chunk).run(piece, column, scan);
    }
    return true;
}

}  // namespace

NearGround near_ground(HeightQuery& heights, const View& view) {
    const Lattice& lattice = heights.lattice();
    const earth::Geodetic place = earth::from_ecef(view.eye);
    const LatticePoint point = lattice.point(place.latitude_rad, place.longitude_rad);
    if (!point.inside || !is_finite(view)) return {};
    const auto i = static_cast<std::int64_t>(std::fmin(point.i, lattice.columns() - 2.0));
    const auto j = static_cast<std::int64_t>(std::fmin(point.j, lattice.rows() - 2.0));
    // High above the ground no vertices need be read.
    const ChunkEntry* const below = heights.exact_entry(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
    if (below == nullptr) return {};
    const std::int64_t most_reach = kCellsToEachSide << below->level;
    Zone zone = zone_round(lattice, i, j, most_reach);
    if (box_distance_m(*below, view) > distance_beyond(lattice, zone, view.eye, place)) return {};
    Pieces pieces;
    const double margin_m = kMarginOfNear * view.near_m;
    if (!cut_round(heights, i, j, most_reach, zone, pieces) || !(pieces.error_m <= margin_m)) return {};

    const double beyond_m = distance_beyond(lattice, without_border(lattice, zone, pieces.spacing), view.eye, place);
    GroundScan scan(view, earth::north_east_down(place.latitude_rad, place.longitude_rad)[2], margin_m, pieces.error_m);
    if (!scan_pieces(heights, pieces, scan) || !(scan.drop_m() < beyond_m)) return {};
    const double px_per_m = std::max(scan.px_per_m(), px_per_m_beyond(view, beyond_m, margin_m));
    if (!std::isfinite(px_per_m)) return {};
    return {px_per_m, margin_m};
}

}  // namespace tedavis::terrain
