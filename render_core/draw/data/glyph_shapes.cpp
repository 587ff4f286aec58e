#include "render_core/draw/data/glyph_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render_core/base/units.hpp"

namespace tedavis::draw {
namespace {

using glm::vec2;
using glm::vec3;

constexpr float kRim = 0.05f;  // of a flat shape, as a share of its length
constexpr float kHalf = 0.5f;
constexpr float kShaftRadius = 0.14f, kTipRadius = 0.4f, kTipBegin = 0.12f;                     // of arrows
constexpr float kInnerRing = 0.34f, kBarHalf = 0.09f, kCrossReach = 0.45f, kPlusReach = 0.19f;  // of signs' bars
constexpr int kRoundSides = 16;
constexpr std::uint8_t kFull = 255;

vec2 on_circle(int n, int sides, float radius, float turn = 0) {
    const double angle = 2 * base::kPi * (n + static_cast<double>(turn)) / sides;
    return {radius * static_cast<float>(std::cos(angle)), radius * static_cast<float>(std::sin(angle))};
}

std::int8_t in_127ths(float share) { return static_cast<std::int8_t>(std::lround(share * 127)); }

}  // namespace

class GlyphShapeMaker {
public:
    explicit GlyphShapeMaker(GlyphShapes& shapes) : shapes_(shapes) {}

    void begin() { mesh_ = {vertex_count(), 0, index_count(), 0}; }
    void end(GlyphShape shape) {
        mesh_.vertices = static_cast<std::uint16_t>(vertex_count() - mesh_.first_vertex);
        mesh_.indices = static_cast<std::uint16_t>(index_count() - mesh_.first_index);
        shapes_.meshes_[static_cast<std::size_t>(shape)] = mesh_;
    }

    /// Along x: a prism with a pyramid on it.
    void arrow(int sides) {
        shell_along_x(sides, -kHalf, kShaftRadius, kTipBegin, kShaftRadius);
        disc_facing_back(sides, -kHalf, kShaftRadius);
        shell_along_x(sides, kTipBegin, kTipRadius, kHalf, 0);
        disc_facing_back(sides, kTipBegin, kTipRadius);
    }
    /// Along z, on its base.
    void cone(int sides) {
        for (int n = 0; n < sides; ++n) {
            const vec2 a = on_circle(n, sides, kHalf), b = on_circle(n + 1, sides, kHalf),
                       middle = on_circle(n, sides, kHalf, kHalf);
            const std::uint16_t low = vertex(vec3(a, 0), vec3(a, kHalf * kHalf)),
                                next = vertex(vec3(b, 0), vec3(b, kHalf * kHalf));
            triangle(low, next, vertex({0, 0, 1}, vec3(middle, kHalf * kHalf)));
        }
        const std::uint16_t first = vertex_count();
        for (int n = 0; n < sides; ++n) vertex(vec3(on_circle(-n, sides, kHalf), 0), {0, 0, -1});
        fan(first, sides);
    }
    /// Three sides and a base, each with its own normal.
    void tetrahedron() {
        const vec3 top(0, 0, 1), a(on_circle(0, 3, kHalf), 0), b(on_circle(1, 3, kHalf), 0), c(on_circle(2, 3, kHalf), 0);
        for (const auto& side : {Corners{a, b, top}, Corners{b, c, top}, Corners{c, a, top}, Corners{a, c, b}}) {
            const vec3 normal = glm::cross(side.b - side.a, side.c - side.a);
            triangle(vertex(side.a, normal), vertex(side.b, normal), vertex(side.c, normal));
        }
    }
    void box() {
        const vec2 corners[4] = {{-kHalf, -kHalf}, {kHalf, -kHalf}, {kHalf, kHalf}, {-kHalf, kHalf}};
        for (int n = 0; n < 4; ++n) {
            const vec2 a = corners[n], b = corners[(n + 1) % 4];
            const vec3 normal(a + b, 0);
            quad(vec3(a, 0), vec3(b, 0), vec3(b, 1), vec3(a, 1), normal);
        }
        quad(vec3(corners[0], 1), vec3(corners[1], 1), vec3(corners[2], 1), vec3(corners[3], 1), {0, 0, 1});
    }
    /// Between circles of latitude, smooth.
    void sphere(int rings, int sides) {
        const std::uint16_t bottom = vertex({0, 0, -kHalf}, {0, 0, -1});
        for (int ring = 1; ring < rings; ++ring) {
            const double angle = base::kPi * ring / rings;
            for (int n = 0; n < sides; ++n) {
                const vec3 place(on_circle(n, sides, kHalf * static_cast<float>(std::sin(angle)), ring % 2 == 0 ? 0 : kHalf),
                                 -kHalf * static_cast<float>(std::cos(angle)));
                vertex(place, place);
            }
        }
        const std::uint16_t top = vertex({0, 0, kHalf}, {0, 0, 1});
        const auto at = [&](int ring, int n) {
            return static_cast<std::uint16_t>(bottom + 1 + (ring - 1) * sides + (n + sides) % sides);
        };
        for (int n = 0; n < sides; ++n) {
            triangle(bottom, at(1, n + 1), at(1, n));
            triangle(top, at(rings - 1, n), at(rings - 1, n + 1));
            for (int ring = 1; ring + 1 < rings; ++ring) {
                const int upper = ring % 2 == 0 ? n : n + 1;  // odd rings are turned by half a side
                triangle(at(ring, n), at(ring, n + 1), at(ring + 1, upper));
                triangle(at(ring + 1, upper), at(ring + 1, upper - 1), at(ring, n));
            }
        }
    }

    void flat_arrow() {
        const vec2 corners[] = {{-kHalf, -kShaftRadius}, {kTipBegin, -kShaftRadius}, {kTipBegin, -kTipRadius}, {kHalf, 0},
                                {kTipBegin, kTipRadius}, {kTipBegin, kShaftRadius},  {-kHalf, kShaftRadius}};
        const std::uint16_t first = outlined(corners);
        for (const auto& [a, b, c] : {Part{0, 1, 5}, Part{0, 5, 6}, Part{1, 2, 3}, Part{1, 3, 5}, Part{5, 3, 4}})
            triangle(at(first, a), at(first, b), at(first, c));
    }
    /// Four bars from the middle, the first turned by so much.
    void bars(float reach, float turn_rad) {
        vec2 corners[12];
        for (int n = 0; n < 4; ++n) {
            const double angle = turn_rad + n * base::kPi / 2;
            const vec2 along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
            corners[3 * n] = along * reach - across * kBarHalf;
            corners[3 * n + 1] = along * reach + across * kBarHalf;
            corners[3 * n + 2] = (along + across) * kBarHalf;
        }
        const std::uint16_t first = outlined(corners);
        for (int n = 0; n < 4; ++n) {
            const int inner = (3 * n + 11) % 12;
            triangle(at(first, inner), at(first, 3 * n), at(first, 3 * n + 1));
            triangle(at(first, inner), at(first, 3 * n + 1), at(first, 3 * n + 2));
        }
        triangle(at(first, 2), at(first, 5), at(first, 8));
        triangle(at(first, 2), at(first, 8), at(first, 11));
    }
    void ring() {
        band(kInnerRing, kHalf - kRim, kFull);
        band(kInnerRing - kRim, kInnerRing, 0);
        band(kHalf - kRim, kHalf, 0);
    }
    void circle() { polygon_of(kRoundSides, kHalf - kRim); }
    void flat_triangle() { polygon_of(3, kHalf - 2 * kRim); }
    void puff() {
        constexpr std::uint8_t kMiddle = 150;
        const std::uint16_t middle = vertex({0, 0, 0}, vec3(0));
        for (const float radius : {0.28f, kHalf})
            for (int n = 0; n < kRoundSides; ++n)
                vertex(vec3(on_circle(n, kRoundSides, radius), 0), vec3(0), kFull, radius < kHalf ? kMiddle : std::uint8_t{0});
        const auto at = [&](int ring, int n) {
            return static_cast<std::uint16_t>(middle + 1 + ring * kRoundSides + n % kRoundSides);
        };
        for (int n = 0; n < kRoundSides; ++n) {
            triangle(middle, at(0, n), at(0, n + 1));
            triangle(at(0, n), at(1, n), at(1, n + 1));
            triangle(at(1, n + 1), at(0, n + 1), at(0, n));
        }
    }
    /// Dark along one side, so that it stands out against any ground: two triangles, as it may be long and often there.
    void stem() {
        const std::uint16_t first = vertex_count();
        for (const vec2& corner : {vec2(-kHalf, -kHalf), vec2(kHalf, -kHalf), vec2(kHalf, kHalf), vec2(-kHalf, kHalf)})
            vertex(vec3(corner, 0), vec3(0), corner.y < 0 ? std::uint8_t{0} : kFull);
        fan(first, 4);
    }

private:
    struct Part {
        int a, b, c;
    };
    struct Corners {
        vec3 a, b, c;
    };
    [[nodiscard]] std::uint16_t vertex_count() const { return static_cast<std::uint16_t>(shapes_.vertices_.size()); }
    [[nodiscard]] std::uint16_t index_count() const { return static_cast<std::uint16_t>(shapes_.indices_.size()); }

    std::uint16_t vertex(const vec3& place, const vec3& normal, std::uint8_t tone = kFull, std::uint8_t opacity = kFull) {
        const vec3 n = glm::dot(normal, normal) > 0 ? glm::normalize(normal) : vec3(0);
        const GlyphVertex made{
            {place.x, place.y, place.z}, {in_127ths(n.x), in_127ths(n.y), in_127ths(n.z), 0}, tone, opacity, {}};
        TEDAVIS_CHECK(shapes_.vertices_.try_push_back(made));
        return static_cast<std::uint16_t>(vertex_count() - 1);
    }
    void triangle(std::uint16_t a, std::uint16_t b, std::uint16_t c) {
        for (const std::uint16_t index : {a, b, c}) TEDAVIS_CHECK(shapes_.indices_.try_push_back(index));
    }
    void fan(std::uint16_t first, int corners) {
        for (int n = 1; n + 1 < corners; ++n)
            triangle(first, static_cast<std::uint16_t>(first + n), static_cast<std::uint16_t>(first + n + 1));
    }
    void quad(const vec3& a, const vec3& b, const vec3& c, const vec3& d, const vec3& normal) {
        const std::uint16_t first = vertex(a, normal);
        for (const vec3& corner : {b, c, d}) vertex(corner, normal);
        fan(first, 4);
    }
    /// Round x from one radius to another; a radius of 0 is a tip.
    void shell_along_x(int sides, float from_x, float from_radius, float to_x, float to_radius) {
        const float slope = (from_radius - to_radius) / (to_x - from_x);
        const std::uint16_t first = vertex_count();
        for (int n = 0; n < sides; ++n) {
            const bool is_tip = to_radius == 0;
            const vec2 radial = on_circle(n, sides, 1), after = on_circle(n, sides, 1, is_tip ? kHalf : 0);
            vertex(vec3(from_x, radial * from_radius), vec3(slope, radial));
            vertex(vec3(to_x, after * to_radius), vec3(slope, after));
        }
        for (int n = 0; n < sides; ++n) {
            const auto a = static_cast<std::uint16_t>(first + 2 * n),
                       b = static_cast<std::uint16_t>(first + 2 * ((n + 1) % sides));
            triangle(a, b, static_cast<std::uint16_t>(a + 1));
            if (to_radius > 0) triangle(b, static_cast<std::uint16_t>(b + 1), static_cast<std::uint16_t>(a + 1));
        }
    }
    void disc_facing_back(int sides, float x, float radius) {
        const std::uint16_t first = vertex_count();
        for (int n = 0; n < sides; ++n) vertex(vec3(x, on_circle(-n, sides, radius)), {-1, 0, 0});
        fan(first, sides);
    }
    [[nodiscard]] static std::uint16_t at(std::uint16_t first, int n) { return static_cast<std::uint16_t>(first + n); }
    /// Corners of a polygon, counter-clockwise, and the rim round it. The first of the corners.
    std::uint16_t outlined(base::Span<const vec2> corners) {
        const auto count = static_cast<int>(corners.size());
        const auto corner = [&](int n) { return corners[static_cast<std::size_t>((n + count) % count)]; };
        const std::uint16_t rim = vertex_count();
        for (int n = 0; n < count; ++n) {
            vertex(vec3(corner(n), 0), vec3(0), 0);
            vertex(vec3(beyond(corner(n - 1), corner(n), corner(n + 1)), 0), vec3(0), 0);
        }
        for (int n = 0; n < count; ++n) {
            const int next = (n + 1) % count;
            triangle(at(rim, 2 * n), at(rim, 2 * n + 1), at(rim, 2 * next));
            triangle(at(rim, 2 * next), at(rim, 2 * n + 1), at(rim, 2 * next + 1));
        }
        const std::uint16_t first = vertex_count();
        for (int n = 0; n < count; ++n) vertex(vec3(corner(n), 0), vec3(0));
        return first;
    }
    void polygon_of(int sides, float radius) {
        vec2 corners[kRoundSides];
        for (int n = 0; n < sides; ++n) corners[n] = on_circle(n, sides, radius);
        fan(outlined({corners, static_cast<std::size_t>(sides)}), sides);
    }
    /// The corner moved outwards so that both its sides move by the rim.
    static vec2 beyond(const vec2& before, const vec2& corner, const vec2& after) {
        const vec2 in = glm::normalize(corner - before), out = glm::normalize(after - corner);
        const vec2 first(in.y, -in.x), second(out.y, -out.x);
        return corner + (first + second) * (kRim / (1 + glm::dot(first, second)));
    }
    void band(float inner, float outer, std::uint8_t tone) {
        const std::uint16_t first = vertex_count();
        for (int n = 0; n < kRoundSides; ++n) {
            vertex(vec3(on_circle(n, kRoundSides, inner), 0), vec3(0), tone);
            vertex(vec3(on_circle(n, kRoundSides, outer), 0), vec3(0), tone);
        }
        for (int n = 0; n < kRoundSides; ++n) {
            const int next = (n + 1) % kRoundSides;
            triangle(at(first, 2 * n), at(first, 2 * n + 1), at(first, 2 * next));
            triangle(at(first, 2 * next), at(first, 2 * n + 1), at(first, 2 * next + 1));
        }
    }

    GlyphShapes& shapes_;
    GlyphMesh mesh_;
};

GlyphShape plain_variant(GlyphShape shape) noexcept {
    switch (shape) {
        case GlyphShape::arrow: return GlyphShape::plain_arrow;
        case GlyphShape::sphere: return GlyphShape::plain_sphere;
        case GlyphShape::cone: return GlyphShape::plain_cone;
        default: return shape;
    }
}

void GlyphShapes::build() {
    vertices_.clear();
    indices_.clear();
    GlyphShapeMaker maker(*this);
    for (std::size_t n = 0; n < kGlyphShapes; ++n) {
        const auto shape = static_cast<GlyphShape>(n);
        maker.begin();
        switch (shape) {
            case GlyphShape::arrow: maker.arrow(7); break;
            case GlyphShape::plain_arrow: maker.arrow(4); break;
            case GlyphShape::flat_arrow: maker.flat_arrow(); break;
            case GlyphShape::ring: maker.ring(); break;
            case GlyphShape::crossed_ring:
                maker.ring();
                maker.bars(kPlusReach, 0);
                break;
            case GlyphShape::cross: maker.bars(kCrossReach, static_cast<float>(base::kPi / 4)); break;
            case GlyphShape::sphere: maker.sphere(6, 10); break;
            case GlyphShape::plain_sphere: maker.sphere(3, 5); break;
            case GlyphShape::box: maker.box(); break;
            case GlyphShape::tetrahedron: maker.tetrahedron(); break;
            case GlyphShape::cone: maker.cone(12); break;
            case GlyphShape::plain_cone: maker.cone(5); break;
            case GlyphShape::circle: maker.circle(); break;
            case GlyphShape::triangle: maker.flat_triangle(); break;
            case GlyphShape::puff: maker.puff(); break;
            case GlyphShape::stem: maker.stem(); break;
        }
        maker.end(shape);
    }
}

std::uint32_t GlyphShapes::most_vertices() const {
    std::uint32_t most = 0;
    for (const GlyphMesh& mesh : meshes_) most = std::max<std::uint32_t>(most, mesh.vertices);
    return most;
}

std::uint32_t GlyphShapes::most_indices() const {
    std::uint32_t most = 0;
    for (const GlyphMesh& mesh : meshes_) most = std::max<std::uint32_t>(most, mesh.indices);
    return most;
}

}  // namespace tedavis::draw
