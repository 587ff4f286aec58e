/// What all programs of this folder agree on: the raster, the poses, and the pictures that they hand over.
///
/// Frame     flat, metres: x east, y north, z up; the post in the south-west corner is the origin.
/// Raster    `ground.i16`: kSide x kSide posts, int16 metres, little-endian, rows from the north.
/// Pose      x, y, z in metres; heading clockwise from north, pitch nose up, roll right wing down, in degrees (ISO 1151).
/// Picture   float a pixel, rows from the top: the depth along the camera's axis in metres, infinite where nothing was met.
///           The ray of a pixel runs through its middle.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace tedavis::peers {

inline constexpr std::uint32_t kSide = 2049;
inline constexpr double kSpacing_m = 30;
inline constexpr double kExtent_m = (kSide - 1) * kSpacing_m;
inline constexpr double kVerticalField_deg = 45;
inline constexpr double kNear_m = 30, kFar_m = 100'000;  ///< clip planes of the rasterizers
inline constexpr double kRadian = 0.017453292519943295;

struct Pose {
    double x_m = 0, y_m = 0, z_m = 0, heading_deg = 0, pitch_deg = 0, roll_deg = 0;
};

/// Unit vectors east, north, up.
struct Axes {
    glm::dvec3 forward, right, down;
};

inline Axes axes_of(const Pose& pose) {
    const double h = pose.heading_deg * kRadian, p = pose.pitch_deg * kRadian, r = pose.roll_deg * kRadian;
    const glm::dvec3 forward(std::sin(h) * std::cos(p), std::cos(h) * std::cos(p), std::sin(p));
    const glm::dvec3 level(std::cos(h), -std::sin(h), 0), below = glm::cross(forward, level);
    return {forward, level * std::cos(r) + below * std::sin(r), below * std::cos(r) - level * std::sin(r)};
}

struct PictureSize {
    std::uint32_t width = 1024, height = 768;
    [[nodiscard]] double focal_px() const { return 0.5 * height / std::tan(0.5 * kVerticalField_deg * kRadian); }
    [[nodiscard]] std::size_t pixels() const { return std::size_t{width} * height; }
};

inline bool parse_pose(const std::string& text, Pose& pose) {
    return std::sscanf(text.c_str(), "%lf %lf %lf %lf %lf %lf", &pose.x_m, &pose.y_m, &pose.z_m, &pose.heading_deg,
                       &pose.pitch_deg, &pose.roll_deg) == 6;
}

template <class Value>
std::vector<Value> read_values(const std::string& file, std::size_t count) {
    std::vector<Value> values(count);
    std::ifstream in(file, std::ios::binary);
    in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(Value)));
    if (!in) throw std::runtime_error(file + " cannot be read, or is too short");
    return values;
}

inline std::vector<std::int16_t> read_ground(const std::string& folder) {
    return read_values<std::int16_t>(folder + "/ground.i16", std::size_t{kSide} * kSide);
}

inline void write_picture(const std::string& file, const std::vector<float>& depth_m) {
    std::ofstream out(file, std::ios::binary);
    out.write(reinterpret_cast<const char*>(depth_m.data()), static_cast<std::streamsize>(depth_m.size() * sizeof(float)));
    if (!out.flush()) throw std::runtime_error(file + " cannot be written");
}

/// A fragment shader's depth in the colour: 24 bits of log2(depth in metres) / 17, red first; black where nothing was drawn.
/// A step is 7e-7 of the depth.
inline constexpr const char* kDepthColorCode =
    "float level = floor(clamp(log2(1.0 / gl_FragCoord.w) / 17.0, 0.0, 1.0) * 16777215.0 + 0.5);\n"
    "vec3 depth_color = vec3(floor(level / 65536.0), mod(floor(level / 256.0), 256.0), mod(level, 256.0)) / 255.0;\n";

inline float depth_of_color(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    const std::uint32_t level = (std::uint32_t{red} << 16) + (std::uint32_t{green} << 8) + blue;
    return level == 0 ? std::numeric_limits<float>::infinity() : static_cast<float>(std::exp2(17.0 * level / 16777215.0));
}

}  // namespace tedavis::peers
