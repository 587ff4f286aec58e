/// Five cameras over a square field, with the rays of their pixels: three that look level in several directions, and two
/// that look down, one of them banked.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "render_core/raytrace/view_kernels.hpp"

namespace tedavis::test_support {

/// The ray of a pixel runs through `corner + x * right + y * down`, for x and y from its middle. Lengths are those of cells.
struct TraceCamera {
    const char* name;
    glm::dvec3 eye, corner, right, down;
    std::uint32_t width, height;

    /// The same picture where a cell is `steps` height steps wide: t keeps its value.
    [[nodiscard]] TraceCamera in_steps(double steps) const {
        const glm::dvec3 scale(1, 1, steps);
        return {name, eye * scale, corner * scale, right * scale, down * scale, width, height};
    }
    [[nodiscard]] raytrace::GridCamera view() const { return {eye, corner, right, down}; }
    [[nodiscard]] raytrace::Ray ray(std::uint32_t x, std::uint32_t y) const { return view().ray(x, y); }
};

/// 60 degrees wide, over the middle of a field of `side` posts whose hills are 0.15 side high. In cells.
inline std::array<TraceCamera, 5> trace_cameras(std::uint32_t side, std::uint32_t width, std::uint32_t height) {
    constexpr double kDegree = 0.017453292519943295;
    const double pixel = 2 * std::tan(30 * kDegree) / width, down = std::tan(14 * kDegree);
    const glm::dvec3 eye = glm::vec3(0.5 * side + 0.3, 0.5 * side + 0.4, 0.16 * side);
    const auto camera = [&](const char* name, double yaw, double pitch, double roll, double drop) {
        const glm::dvec3 level(std::cos(yaw), std::sin(yaw), 0), side_of(-std::sin(yaw), std::cos(yaw), 0), up(0, 0, 1);
        const glm::dvec3 forward = level * std::cos(pitch) + up * std::sin(pitch);
        const glm::dvec3 below = level * std::sin(pitch) - up * std::cos(pitch);
        const glm::dvec3 r = (side_of * std::cos(roll) + below * std::sin(roll)) * pixel;
        const glm::dvec3 d = (below * std::cos(roll) - side_of * std::sin(roll)) * pixel;
        // Rounded here, so that they are the same numbers in steps.
        const glm::vec3 corner(forward - up * drop - r * (width * 0.5) - d * (height * 0.5));
        return TraceCamera{name, eye, corner, glm::vec3(r), glm::vec3(d), width, height};
    };
    return {camera("level 0", 0, 0, 0, down), camera("level 0.7", 0.7, 0, 0, down), camera("level 2.1", 2.1, 0, 0, down),
            camera("banked", 0.7, -14 * kDegree, 20 * kDegree, 0), camera("pitched", 0.7, -14 * kDegree, 0, 0)};
}

}  // namespace tedavis::test_support
