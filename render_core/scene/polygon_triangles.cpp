#include "render_core/scene/polygon_triangles.hpp"

namespace tedavis::scene {
namespace {

double cross(const glm::dvec2& o, const glm::dvec2& a, const glm::dvec2& b) {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

/// The corners that are left, counter-clockwise.
struct Rest {
    std::uint16_t corners[kMaxPolygonCorners];
    std::size_t count = 0;

    [[nodiscard]] std::uint16_t at(std::size_t n) const { return corners[n % count]; }
    void remove(std::size_t n) {
        --count;
        for (std::size_t k = n; k < count; ++k) corners[k] = corners[k + 1];
    }
};

bool is_ear(base::Span<const glm::dvec2> corners, const Rest& rest, std::size_t n) {
    const glm::dvec2 &a = corners[rest.at(n + rest.count - 1)], &b = corners[rest.at(n)], &c = corners[rest.at(n + 1)];
    if (!(cross(a, b, c) > 0)) return false;
    for (std::size_t k = 2; k + 1 < rest.count; ++k) {
        const glm::dvec2& p = corners[rest.at(n + k)];
        if (p == a || p == b || p == c) continue;
        if (cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0) return false;
    }
    return true;
}

/// Where nothing is an ear, a corner without area costs nothing; else the polygon crosses itself and any corner must do.
std::size_t next_cut(base::Span<const glm::dvec2> corners, const Rest& rest) {
    for (std::size_t n = 0; n < rest.count; ++n)
        if (is_ear(corners, rest, n)) return n;
    for (std::size_t n = 0; n < rest.count; ++n)
        if (cross(corners[rest.at(n + rest.count - 1)], corners[rest.at(n)], corners[rest.at(n + 1)]) == 0) return n;
    return 0;
}

}  // namespace

double twice_area(base::Span<const glm::dvec2> corners) noexcept {
    double sum = 0;
    for (std::size_t n = 0; n < corners.size(); ++n) {
        const glm::dvec2 &a = corners[n] - corners[0], &b = corners[(n + 1) % corners.size()] - corners[0];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

std::size_t triangulate(base::Span<const glm::dvec2> corners, base::Span<std::uint16_t> triangles) noexcept {
    if (corners.size() < 3 || corners.size() > kMaxPolygonCorners || triangles.size() < 3 * (corners.size() - 2)) return 0;
    Rest rest;
    rest.count = corners.size();
    const bool is_clockwise = twice_area(corners) < 0;
    for (std::size_t n = 0; n < rest.count; ++n)
        rest.corners[n] = static_cast<std::uint16_t>(is_clockwise ? rest.count - 1 - n : n);
    std::size_t count = 0;
    while (rest.count >= 3) {
        const std::size_t n = next_cut(corners, rest);
        const std::uint16_t a = rest.at(n + rest.count - 1), b = rest.at(n), c = rest.at(n + 1);
        if (cross(corners[a], corners[b], corners[c]) > 0) {
            triangles[count++] = a;
            triangles[count++] = b;
            triangles[count++] = c;
        }
        rest.remove(n);
    }
    return count;
}

}  // namespace tedavis::scene
