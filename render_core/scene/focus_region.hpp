/// Where a focus lies (thesis, 5.2.3), and how much of it a place is: 1 in the focus, between in the intermediate context, 0 in
/// the context.
///
/// A region has a plane of its own, which touches the ellipsoid at the region's anchor: a place's coordinates in it are the
/// metres east and north of the anchor, two dot products,
///
///     east_m = dot(place - anchor, east),  north_m = dot(place - anchor, north),
///
/// in double here, and as two vec4 uniforms from eye-relative places in shaders (w = dot(eye - anchor, axis)). At a distance d
/// from the anchor lengths in the plane are short by d^2 / 2R^2 at most (3 m of 100 km: 1.2e-4), and a place h over the ellipsoid
/// lies d h / R farther out (3 km up, 10 km away: 5 m). All distances are those in the plane: on the ground, whatever the height
/// of a place. Points of a region lie in the same plane.
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
    double width_m = 5000;     ///< from the focus' rim to the context; 0: there is no intermediate context
    std::uint32_t levels = 1;  ///< equal steps of it; 0: the degree falls evenly
};

/// What the points are to each other.
enum class FocusPoints : std::uint8_t {
    places,  ///< each has a focus round it
    path,    ///< the focus is along the way from one to the next
};

struct FocusRegion {
    bool is_valid = false;  ///< false: it is nowhere, and every degree is 0
    FocusPoints kind = FocusPoints::places;
    /// Of places: squares, `radius_m` half their side, along north. A path is as wide everywhere by its context's distance.
    bool is_square = false;
    FocusContext context;
    double radius_m = 0;
    std::uint32_t point_count = 0;                     ///< of a valid one 1..kMaxFocusPoints
    std::array<glm::dvec2, kMaxFocusPoints> points{};  ///< east, north, m
    glm::dvec3 anchor{0};                              ///< on the ellipsoid
    glm::dvec3 east{0}, north{0}, up{0};               ///< unit vectors at the anchor
    /// A volume reaches from one to the other, above the ellipsoid; where it is a ball `radius_m` and these are of its middle's
    /// height. Not volumes: -inf, inf. The ground is in no matter what height.
    double lower_m = 0, upper_m = 0;
    bool is_ball = false, is_volume = false;
};
static_assert(std::is_trivially_copyable_v<FocusRegion>);

using FocusRegions = base::FixedVector<FocusRegion, kMaxFoci>;

/// A valid region without points, whose plane touches the ellipsoid below the place.
[[nodiscard]] FocusRegion focus_region_at(double latitude_rad, double longitude_rad) noexcept;

/// East and north of the anchor.
[[nodiscard]] glm::dvec2 in_focus_plane(const FocusRegion& region, const glm::dvec3& place) noexcept;

/// Places, or legs from one point to the next.
[[nodiscard]] std::uint32_t focus_part_count(const FocusRegion& region) noexcept;
/// From a part's rim by the context's distance; negative within, there the straight way to the rim of a leg, circle or square.
[[nodiscard]] double focus_part_distance_m(const FocusRegion& region, std::uint32_t part, const glm::dvec2& ground) noexcept;

/// From the focus' rim to a place of the plane by the context's distance; 0 within. Exact in the plane: of a round place by
/// Chebyshev's distance the largest square round the place that the circle does not reach into.
[[nodiscard]] double focus_distance_m(const FocusRegion& region, const glm::dvec2& ground) noexcept;

/// By the distance from the rim, of what is not in the focus: (0, 1) in the intermediate context, in `levels` steps; 0 beyond.
[[nodiscard]] double degree_at_distance(const FocusContext& context, double distance_m) noexcept;

/// Values of a data focus: those from low to high, and beside them the intermediate context.
struct FocusValueRange {
    double low = 0, high = -1;  ///< low > high: none has one
    double similar = 0;         ///< so far beyond, in the attribute's unit
    std::uint32_t levels = 1;   ///< as of FocusContext
};
/// 0 where the value is not a number: nobody knows that it belongs there.
[[nodiscard]] double degree_of_value(const FocusValueRange& range, double value) noexcept;

/// Of ground: whatever the heights of a volume.
[[nodiscard]] double ground_focus_degree(const FocusRegion& region, const glm::dvec2& ground) noexcept;

/// Over or under a volume, or round a ball's waist, is beside it: intermediate context, of this degree at most.
inline constexpr double kMaxBesideVolume = 0.75;

/// Of a place above the ellipsoid by its place in the plane: within 0.5 % of what the Earth bends by on the way (4 m of 100 km).
[[nodiscard]] double height_m(const FocusRegion& region, const glm::dvec3& place) noexcept;

/// Of a place in the air, ECEF, `height_m` above the ellipsoid; in volumes by that too.
[[nodiscard]] double focus_degree(const FocusRegion& region, const glm::dvec3& place, double height_m) noexcept;

/// The greatest of all; 1 where there is no valid region, for then nothing steps back.
[[nodiscard]] double ground_focus_degree(const FocusRegions& regions, const glm::dvec3& place) noexcept;
[[nodiscard]] double focus_degree(const FocusRegions& regions, const glm::dvec3& place, double height_m) noexcept;

}  // namespace tedavis::scene
