/// Attribute maps of the terrain: their channels, the meaning of their 8-bit codes, and the 16 directions of the horizon. The
/// terrain builder writes these codes, and shaders repeat the decoding formulas. All codes may be filtered linearly. Angles in
/// radians, directions (east, north, up) at the post.
///
/// | channel              | code → value                          | range       | step                                 |
/// |----------------------|---------------------------------------|-------------|--------------------------------------|
/// | normal east, north   | s = (c - 128)/127                     | -1..1       | 1/127                                |
/// | sky view             | c/255                                 | 0..1        | 1/255                                |
/// | curvature            | s·|s|; ridges positive                | -1..1       | 6e-5 at 0, 0.016 at 1                |
/// | light                | 1.25·c/255                            | 0..1.25     | 0.0049                               |
/// | openness, both       | (1 + s·|s|)·π/2                       | 0..180°     | 0.006° at 90°, 0.33° at 85°, 1° at 45° |
/// | local relief         | 1000 m·s·|s|                          | ±1000 m     | 0.06 m at 0, 5 m at 100 m            |
/// | aperture east, north | s                                     | -1..1       | 1/127                                |
/// | aperture radius      | its cosine = c/255                    | 0..90°      | 0.22° at 90°, 0.45° at 60°           |
/// | horizon              | its sine = (c/255)²                   | 0..90°      | 0.001° at 0°, 0.06° at 1°, 0.5° at 45° |
///
/// Zero, 90° of openness and the ends of a range have exact codes, so level open ground is coded without error.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "render_core/base/units.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::terrain {

/// The channels, in the order of the bytes in the three RGBA8 maps.
enum class AttributeChannel : std::uint8_t {
    normal_east,      ///< of the unit normal
    normal_north,     ///< of the unit normal
    sky_view,         ///< share of a uniform sky's light that reaches the surface; 1 on level open ground
    curvature,        ///< mean curvature times post spacing: dimensionless; positive on ridges
    light,            ///< light from one fixed light, the sky and one bounce; 1: full direct and sky light
    openness_above,   ///< positive openness: 90° on level ground, more on ridges
    local_relief,     ///< height above the mean of its surroundings
    post_class,       ///< class_code()
    aperture_east,    ///< of the unit vector to the middle of the visible sky
    aperture_north,   ///< of the unit vector to the middle of the visible sky
    aperture_radius,  ///< cosine of the radius of a cap as large as the visible sky
    openness_below,   ///< negative openness: 90° on level ground, more in valleys
};
inline constexpr int kAttributeChannels = 12;
inline constexpr int kAttributeMaps = 3;  ///< channel n lies in map n / 4, byte n % 4

inline constexpr float kBrightestLight = 1.25f;
inline constexpr float kLargestRelief_m = 1000;

/// Rounds to the nearest integer, halves up; for 0..255.
[[nodiscard]] inline int nearest_step(float steps) {
    return static_cast<int>(steps + 0.5f);  // faster than lround, and equal to it below 256. NOLINT(bugprone-incorrect-roundings)
}

/// NaN counts as 0.
[[nodiscard]] inline std::uint8_t encode_unit(float value) {
    if (value >= 1) return 255;
    return value > 0 ? static_cast<std::uint8_t>(nearest_step(value * 255)) : std::uint8_t{0};
}
[[nodiscard]] inline float decode_unit(std::uint8_t code) { return static_cast<float>(code) / 255; }

/// Codes 1..255 for -1..1; 128 is 0 exactly, and opposite values have opposite codes. NaN counts as 0.
[[nodiscard]] inline std::uint8_t encode_signed(float value) {
    const float size = std::fabs(value);
    const int steps = size >= 1 ? 127 : size > 0 ? nearest_step(size * 127) : 0;
    return static_cast<std::uint8_t>(value < 0 ? 128 - steps : 128 + steps);
}
/// Code 0 is never written and counts as -1.
[[nodiscard]] inline float decode_signed(std::uint8_t code) { return code == 0 ? -1.0f : static_cast<float>(code - 128) / 127; }

/// Like encode_signed(), but of the root of the magnitude, for fine steps near 0.
[[nodiscard]] inline std::uint8_t encode_signed_root(float value) {
    return encode_signed(std::copysign(std::sqrt(std::fabs(value)), value));
}
[[nodiscard]] inline float decode_signed_root(std::uint8_t code) {
    const float root = decode_signed(code);
    return root * std::fabs(root);
}

[[nodiscard]] inline std::uint8_t encode_openness(float openness_rad) {
    constexpr float kRight = static_cast<float>(base::kPi / 2);
    return encode_signed_root((openness_rad - kRight) / kRight);
}
[[nodiscard]] inline float decode_openness_rad(std::uint8_t code) {
    return (1 + decode_signed_root(code)) * static_cast<float>(base::kPi / 2);
}
[[nodiscard]] inline std::uint8_t encode_light(float light) { return encode_unit(light / kBrightestLight); }
[[nodiscard]] inline float decode_light(std::uint8_t code) { return decode_unit(code) * kBrightestLight; }
[[nodiscard]] inline std::uint8_t encode_relief(float relief_m) { return encode_signed_root(relief_m / kLargestRelief_m); }
[[nodiscard]] inline float decode_relief_m(std::uint8_t code) { return decode_signed_root(code) * kLargestRelief_m; }
/// Encodes the sine of a horizon's elevation; elevations below the horizontal count as 0.
[[nodiscard]] inline std::uint8_t encode_horizon(float sine) { return encode_unit(sine > 0 ? std::sqrt(sine) : 0.0f); }
[[nodiscard]] inline float decode_horizon_sine(std::uint8_t code) { return decode_unit(code) * decode_unit(code); }

/// Decodes the slope at a post, radians, from its normal's codes.
[[nodiscard]] inline float decode_slope_rad(std::uint8_t normal_east, std::uint8_t normal_north) {
    const float east = decode_signed(normal_east), north = decode_signed(normal_north);
    const float level = east * east + north * north;
    return std::atan2(std::sqrt(level), std::sqrt(level < 1 ? 1 - level : 0.0f));
}

/// Codes are far apart, so that a filtered texel near a border still tells the classes apart.
[[nodiscard]] constexpr std::uint8_t class_code(PostClass post_class) {
    return static_cast<std::uint8_t>(85 * static_cast<int>(post_class));
}
[[nodiscard]] constexpr PostClass class_of_code(std::uint8_t code) { return static_cast<PostClass>((code + 42) / 85); }

// -- the directions of the horizon ------------------------------------------------------------------------------------

/// Horizon maps hold one value for every second post along rows and columns.
inline constexpr int kHorizonPostStep = 2;

/// A direction on the lattice, in half posts: the larger component is 2, so that each step ends on a row or column of posts.
struct LatticeDirection {
    std::int8_t east2 = 0, north2 = 0;
};
/// The directions, clockwise from north. Their azimuths are 0°, 26.6°, 45°, 63.4°, 90° ... on square cells; see
/// horizon_azimuth_rad() for others.
inline constexpr std::array<LatticeDirection, kHorizonDirections> kHorizonDirection = {{{0, 2},
                                                                                        {1, 2},
                                                                                        {2, 2},
                                                                                        {2, 1},
                                                                                        {2, 0},
                                                                                        {2, -1},
                                                                                        {2, -2},
                                                                                        {1, -2},
                                                                                        {0, -2},
                                                                                        {-1, -2},
                                                                                        {-2, -2},
                                                                                        {-2, -1},
                                                                                        {-2, 0},
                                                                                        {-2, 1},
                                                                                        {-2, 2},
                                                                                        {-1, 2}}};

/// Returns the azimuth, clockwise from north, 0..2π, where posts are `east_m` apart along a row and `north_m` along a column;
/// both positive.
[[nodiscard]] inline double horizon_azimuth_rad(int direction, double east_m, double north_m) {
    const LatticeDirection d = kHorizonDirection[static_cast<std::size_t>(direction)];
    const double azimuth = std::atan2(d.east2 * east_m, d.north2 * north_m);
    return azimuth < 0 ? azimuth + 2 * base::kPi : azimuth;
}

/// A horizon at any azimuth is (1 - weight) times that of `first` plus weight times that of `second`.
struct HorizonBracket {
    int first = 0, second = 1;
    double weight = 0;  ///< 0..1
};
[[nodiscard]] inline HorizonBracket bracket_azimuth(double azimuth_rad, double east_m, double north_m) {
    const double turn = 2 * base::kPi;
    const double azimuth = azimuth_rad - turn * std::floor(azimuth_rad / turn);
    int first = kHorizonDirections - 1;
    while (first > 0 && horizon_azimuth_rad(first, east_m, north_m) > azimuth) --first;
    const int second = (first + 1) % kHorizonDirections;
    const double begin = horizon_azimuth_rad(first, east_m, north_m);
    const double end = second == 0 ? turn : horizon_azimuth_rad(second, east_m, north_m);
    return {first, second, (azimuth - begin) / (end - begin)};
}

}  // namespace tedavis::terrain
