/// Shows one place on the Earth larger and the ground round it smaller, so that everything else keeps its place (thesis, 5.2.3,
/// distortion).
///
/// Plane  tangent to the ellipsoid at the middle: metres east and north of it.
/// Map    a regular polygon round the focus (a square, or the octagon round a circle) grows by 2^power. The ground from there
///        to a larger polygon is compressed radially by 2^-compression, and beyond that nothing moves. The ground between the
///        polygons is cut into triangles, three per sector: one on the inner edge, which has the factor of the focus along that
///        edge, and two on the outer edge, which have factor 1 along theirs. In a sector's coordinates, `out` at right angles
///        to its edges and `along` them, r and R the edges' distances, s = (out - r) / (R - r) and k = 2^power:
///
///            out'   = k r + (out - r) / 2^compression
///            along' = along + (k - 1) clamp(along, -h (1 - s), h (1 - s)),     h = r tan(pi / sides)
///
///        The map is affine in each triangle, with slopes that are powers of two, continuous, and one to one. Its Jacobian
///        determinant is 4^power in the focus, 2^(power - compression) or 2^-compression round it and 1 beyond.
/// Height the height above the plane is kept, so that in each part straight lines stay straight, objects on the ground stay on
///        it, and slopes in the focus look flatter by the factor. Ground that moves by d at a distance D from the middle rises
///        above the ellipsoid by d (2 D + d) / 2 R at most: one metre where a focus of 2 km is doubled.
///
/// Pure functions of double; any thread.
#pragma once

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <type_traits>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::earth {

inline constexpr std::uint32_t kMaxMagnifierPower = 4, kMaxCompression = 3;

struct MagnifierSettings {
    double latitude_rad = 0, longitude_rad = 0;
    bool is_square = false;   ///< square with sides along east and north; else a circle
    double radius_m = 0;      ///< of the focus; half the side of a square
    double context_m = 0;     ///< width of the context, from the focus to where nothing moves
    std::uint32_t power = 1;  ///< 1..kMaxMagnifierPower
};

class Magnifier {
public:
    static constexpr std::size_t kMaxSides = 8, kTrianglesOfSector = 3, kMaxCells = 2 + kTrianglesOfSector * kMaxSides;
    static constexpr double kMinRadius_m = 1, kFarthest_m = 200'000;

    /// A magnifier that moves nothing.
    Magnifier() = default;
    /// Chooses the least compression for which the context is wide enough. Returns false, and leaves `magnifier` unchanged,
    /// where no compression suffices or a setting is out of range.
    [[nodiscard]] static bool make(const MagnifierSettings& settings, Magnifier& magnifier);
    /// Width of the context that a compression of 1..kMaxCompression needs.
    [[nodiscard]] static double context_needed_m(const MagnifierSettings& settings, std::uint32_t compression);

    [[nodiscard]] std::uint32_t power() const { return power_; }
    [[nodiscard]] std::uint32_t compression() const { return compression_; }
    [[nodiscard]] double factor() const { return factor_; }
    /// Distance from the middle beyond which nothing moves; nothing is moved to beyond it either.
    [[nodiscard]] double reach_m() const { return reach_m_; }
    [[nodiscard]] double farthest_move_m() const { return (factor_ - 1) * corner_m_; }
    /// Upper bound of the ground's rise above the ellipsoid.
    [[nodiscard]] double farthest_rise_m() const { return farthest_move_m() * reach_m_ / kMinCurvatureRadius_m; }
    [[nodiscard]] const Ecef& middle() const { return middle_; }
    [[nodiscard]] const glm::dvec3& east() const { return east_; }
    [[nodiscard]] const glm::dvec3& north() const { return north_; }
    [[nodiscard]] const glm::dvec3& up() const { return up_; }

    /// 2D coordinates below are metres east and north of the middle. Returns false where nothing within `within_m` of a place
    /// moves.
    [[nodiscard]] bool reaches(const Ecef& place, double within_m) const {
        return glm::distance(place, middle_) <= reach_m_ + within_m;
    }
    [[nodiscard]] glm::dvec2 in_plane(const Ecef& place) const;
    [[nodiscard]] glm::dvec2 moved(const glm::dvec2& ground) const;
    [[nodiscard]] glm::dvec2 moved_back(const glm::dvec2& shown) const;
    /// Determinant of the map's derivative; on a border that of either side.
    [[nodiscard]] double jacobian(const glm::dvec2& ground) const;

    [[nodiscard]] Ecef moved(const Ecef& place) const;
    [[nodiscard]] Ecef moved_back(const Ecef& shown) const;
    /// Moves a point over `from` in the plane to the same height over `to`.
    [[nodiscard]] Ecef shifted(const Ecef& place, const glm::dvec2& from, const glm::dvec2& to) const;

    /// The edges of a cell at which the scale of the focus, or of the ground outside, ends.
    enum class Borders : std::uint8_t { none, all, first };
    /// A part of the plane in which the map is affine. It includes its edges.
    struct Cell {
        glm::dmat2 slope{1.0};                      ///< shown = slope * ground + shift
        glm::dvec2 shift{0};                        ///< m
        std::array<glm::dvec3, kMaxSides> edges{};  ///< inside where dot(edge, (east, north, 1)) >= 0, m, for all
        Borders borders = Borders::none;            ///< `none` for the outside cell: its borders belong to the triangles
        bool is_outside = false;                    ///< true for the cell outside all others, where nothing moves
        [[nodiscard]] double inside_m(const glm::dvec2& ground) const;  ///< least distance from an edge; 0 or more inside
        /// Returns false where no point of the rectangle is inside; true where one may be.
        [[nodiscard]] bool touches(const glm::dvec2& middle, const glm::dvec2& half) const;
    };
    /// The focus, the triangles, and the outside.
    [[nodiscard]] std::size_t cell_count() const { return 2 + kTrianglesOfSector * sides_; }
    [[nodiscard]] Cell cell(std::size_t n) const;

private:
    /// Coordinates of a sector.
    struct Sector {
        glm::dvec2 axis{1, 0};
        double out = 0, along = 0;
    };
    [[nodiscard]] glm::dvec2 axis(std::size_t sector) const;
    [[nodiscard]] Sector sector_of(const glm::dvec2& place) const;
    [[nodiscard]] double half_base_m(double out) const;
    [[nodiscard]] Cell triangle(std::size_t sector, std::size_t n) const;

    Ecef middle_{0};
    glm::dvec3 east_{0}, north_{0}, up_{0};
    std::uint32_t power_ = 0, compression_ = 0;
    std::uint32_t sides_ = 0;
    double factor_ = 1, shrink_ = 1;     ///< 2^power, 2^-compression
    double inner_m_ = 0, outer_m_ = 0;   ///< distances of the polygons' edges
    double corner_m_ = 0, reach_m_ = 0;  ///< distances of the polygons' corners
    double tangent_ = 0;                 ///< tangent of half a sector's angle
};
static_assert(std::is_trivially_copyable_v<Magnifier>);

/// A set of magnifiers with disjoint moved areas.
class Magnifiers {
public:
    static constexpr std::size_t kMax = 4;
    static constexpr double kMinApart_m = 200;  ///< between the areas that two magnifiers move

    /// Adds a magnifier. Returns false, and changes nothing, where it is too near to another one or the set is full.
    [[nodiscard]] bool add(const Magnifier& magnifier);
    void clear() { all_.clear(); }
    [[nodiscard]] bool empty() const { return all_.empty(); }
    [[nodiscard]] std::size_t size() const { return all_.size(); }
    [[nodiscard]] const Magnifier* begin() const { return all_.begin(); }
    [[nodiscard]] const Magnifier* end() const { return all_.end(); }

    [[nodiscard]] Ecef moved(const Ecef& place) const;
    [[nodiscard]] Ecef moved_back(const Ecef& shown) const;

private:
    base::FixedVector<Magnifier, kMax> all_;
};
static_assert(std::is_trivially_copyable_v<Magnifiers>);

}  // namespace tedavis::earth
