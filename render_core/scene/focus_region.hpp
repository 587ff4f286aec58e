/// A focus region (thesis, 5.2.3) and the focus degree of a point: 1 in the focus, between 0 and 1 in the intermediate context,
/// 0 in the context.
///
/// A region has its own plane, which touches the ellipsoid at the region's anchor. A point's coordinates in it are metres east
/// and north of the anchor,
///
///     east_m = dot(place - anchor, east),  north_m = dot(place - anchor, north),
///
/// computed in double here, and in shaders from eye-relative positions with two vec4 uniforms (w = dot(eye - anchor, axis)). At
/// a distance d from the anchor, lengths in the plane are too short by d^2 / 2R^2 at most (1.2e-4 at 100 km), and a point at a
/// height h above the ellipsoid lies d h / R farther out (5 m at a height of 3 km and a distance of 10 km). All distances are
/// measured in the plane, whatever the height of a point. The points of a region lie in the same plane.
///
/// Pure; any thread. Metres, ECEF where a vector has three components.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string_view>
#include <type_traits>

#include "render_core/base/fixed_vector.hpp"

namespace tedavis::scene {

inline constexpr std::size_t kMaxFoci = 4;
inline constexpr std::size_t kMaxFocusPoints = 16;

enum class FocusDistance : std::uint8_t { euclidean, chebyshev };
inline constexpr std::array<std::string_view, 2> kFocusDistanceNames{"euclidean", "chebyshev"};

struct FocusContext {
    FocusDistance distance = FocusDistance::euclidean;
    double width_m = 5000;     ///< from the focus' edge to the context; 0: there is no intermediate context
    std::uint32_t levels = 1;  ///< number of equal steps; 0: the degree decreases continuously
};

/// The meaning of the region's points.
enum class FocusPoints : std::uint8_t {
    places,  ///< there is a focus round each point
    path,    ///< the focus follows the path from one point to the next
};

struct FocusRegion {
    bool is_valid = false;  ///< false: the region is empty, and every degree is 0
    FocusPoints kind = FocusPoints::places;
    /// For places: they are squares along north, and `radius_m` is half their side. A path has the same half width everywhere,
    /// measured by its context's distance.
    bool is_square = false;
    FocusContext context;
    double radius_m = 0;
    std::uint32_t point_count = 0;                     ///< 1..kMaxFocusPoints in a valid region
    std::array<glm::dvec2, kMaxFocusPoints> points{};  ///< east, north, m
    glm::dvec3 anchor{0};                              ///< on the ellipsoid
    glm::dvec3 east{0}, north{0}, up{0};               ///< unit vectors at the anchor
    /// Heights above the ellipsoid between which a volume reaches; for a ball both are those of its centre, and `radius_m` is
    /// its radius. -inf and inf where the region is not a volume. Heights do not matter for the ground.
    double lower_m = 0, upper_m = 0;
    bool is_ball = false, is_volume = false;
};
static_assert(std::is_trivially_copyable_v<FocusRegion>);

using FocusRegions = base::FixedVector<FocusRegion, kMaxFoci>;

/// Returns a valid region without points, whose plane touches the ellipsoid at the given latitude and longitude.
[[nodiscard]] FocusRegion focus_region_at(double latitude_rad, double longitude_rad) noexcept;

/// Returns a point's coordinates in the plane: metres east and north of the anchor.
[[nodiscard]] glm::dvec2 in_focus_plane(const FocusRegion& region, const glm::dvec3& place) noexcept;

/// Number of parts: places, or legs from one point to the next.
[[nodiscard]] std::uint32_t focus_part_count(const FocusRegion& region) noexcept;
/// Returns the distance from a part's edge, by the context's distance measure; negative inside, where it is the Euclidean
/// distance to the edge of the leg, circle or square.
[[nodiscard]] double focus_part_distance_m(const FocusRegion& region, std::uint32_t part, const glm::dvec2& ground) noexcept;

/// Returns the distance from the focus' edge to a point of the plane, by the context's distance measure; 0 inside. It is exact
/// in the plane; for a circle and Chebyshev's distance it is half the side of the largest square round the point that the
/// circle does not enter.
[[nodiscard]] double focus_distance_m(const FocusRegion& region, const glm::dvec2& ground) noexcept;

/// Returns the degree at a distance outside the focus: in (0, 1) in the intermediate context, in `levels` steps; 0 beyond.
[[nodiscard]] double degree_at_distance(const FocusContext& context, double distance_m) noexcept;

/// The values of a data focus: low..high is the focus, and values near it are the intermediate context.
struct FocusValueRange {
    double low = 0, high = -1;  ///< low > high: there is no data focus
    double similar = 0;         ///< width of the intermediate context, in the attribute's unit
    std::uint32_t levels = 1;   ///< as in FocusContext
};
/// Returns the degree of a value; 0 for NaN.
[[nodiscard]] double degree_of_value(const FocusValueRange& range, double value) noexcept;

/// Returns the degree of a point of the ground; the heights of a volume are ignored.
[[nodiscard]] double ground_focus_degree(const FocusRegion& region, const glm::dvec2& ground) noexcept;

/// Points over or under a focus that lie outside its volume in height are intermediate context with at most this degree.
inline constexpr double kMaxBesideVolume = 0.75;

/// Returns a point's height above the ellipsoid, m, computed in the plane. Its error is within 0.5 % of the Earth's curvature
/// drop over the distance (4 m at 100 km).
[[nodiscard]] double height_m(const FocusRegion& region, const glm::dvec3& place) noexcept;

/// Returns the degree of a point in the air (ECEF, `height_m` above the ellipsoid); in volumes it depends on the height too.
[[nodiscard]] double focus_degree(const FocusRegion& region, const glm::dvec3& place, double height_m) noexcept;

/// Return the greatest degree of all regions; 1 where no region is valid, since nothing is context then.
[[nodiscard]] double ground_focus_degree(const FocusRegions& regions, const glm::dvec3& place) noexcept;
[[nodiscard]] double focus_degree(const FocusRegions& regions, const glm::dvec3& place, double height_m) noexcept;

}  // namespace tedavis::scene
