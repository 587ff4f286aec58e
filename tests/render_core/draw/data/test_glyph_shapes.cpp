#include "render_core/draw/data/glyph_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <random>
#include <vector>

namespace tedavis::draw::test_glyph_shapes {
namespace {

struct Corner {
    glm::dvec3 place, normal;
    int tone, opacity;
};
using Triangle = std::array<Corner, 3>;

std::vector<Triangle> triangles_of(const GlyphShapes& shapes, GlyphShape shape) {
    const GlyphMesh& mesh = shapes.mesh(shape);
    std::vector<Triangle> triangles;
    for (std::uint32_t n = 0; n + 2 < mesh.indices; n += 3) {
        Triangle triangle;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint16_t index = shapes.indices()[mesh.first_index + n + k];
            EXPECT_GE(index, mesh.first_vertex);
            EXPECT_LT(index, mesh.first_vertex + mesh.vertices);
            const GlyphVertex& vertex = shapes.vertices()[index];
            triangle[k] = {{vertex.place[0], vertex.place[1], vertex.place[2]},
                           glm::dvec3(vertex.normal[0], vertex.normal[1], vertex.normal[2]) / 127.0,
                           vertex.tone,
                           vertex.opacity};
        }
        triangles.push_back(triangle);
    }
    return triangles;
}

glm::dvec3 area_of(const Triangle& t) { return 0.5 * glm::cross(t[1].place - t[0].place, t[2].place - t[0].place); }

/// Edges that run one way and not back.
int open_edges(const std::vector<Triangle>& triangles) {
    using Place = std::array<long, 3>;
    const auto key = [](const glm::dvec3& p) {
        return Place{std::lround(p.x * 1e4), std::lround(p.y * 1e4), std::lround(p.z * 1e4)};
    };
    std::map<std::pair<Place, Place>, int> edges;
    for (const Triangle& t : triangles)
        for (int n = 0; n < 3; ++n) {
            const Place a = key(t[n].place), b = key(t[(n + 1) % 3].place);
            ++edges[{a, b}];
            --edges[{b, a}];
        }
    return static_cast<int>(std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge.second != 0; }));
}

double volume_of(const std::vector<Triangle>& triangles) {
    double volume = 0;
    for (const Triangle& t : triangles) volume += glm::dot(t[0].place, glm::cross(t[1].place, t[2].place)) / 6;
    return volume;
}

class GlyphShapesTest : public testing::Test {
protected:
    GlyphShapesTest() { shapes->build(); }
    std::unique_ptr<GlyphShapes> shapes = std::make_unique<GlyphShapes>();
    static constexpr GlyphShape kSolids[] = {GlyphShape::arrow,        GlyphShape::plain_arrow, GlyphShape::sphere,
                                             GlyphShape::plain_sphere, GlyphShape::box,         GlyphShape::tetrahedron,
                                             GlyphShape::cone,         GlyphShape::plain_cone};
};

TEST_F(GlyphShapesTest, EveryShapeLiesInItsUnits) {
    std::uint32_t vertices = 0;
    for (std::size_t n = 0; n < kGlyphShapes; ++n) {
        const auto shape = static_cast<GlyphShape>(n);
        EXPECT_GT(shapes->mesh(shape).indices, 0u) << n;
        vertices += shapes->mesh(shape).vertices;
        for (const Triangle& triangle : triangles_of(*shapes, shape))
            for (const Corner& corner : triangle) {
                EXPECT_LE(std::abs(corner.place.x), 0.6) << n;
                EXPECT_LE(std::abs(corner.place.y), 0.6) << n;
                EXPECT_LE(std::abs(corner.place.z), 1.0) << n;
            }
    }
    EXPECT_EQ(vertices, shapes->vertices().size());
    const std::vector<GlyphVertex> before(shapes->vertices().begin(), shapes->vertices().end());
    shapes->build();
    EXPECT_EQ(shapes->vertices().size(), before.size()) << "built again, not twice";
}

TEST_F(GlyphShapesTest, SolidsFaceOutwardsAndTheirNormalsWithThem) {
    for (const GlyphShape shape : kSolids) {
        ASSERT_FALSE(is_flat(shape));
        const std::vector<Triangle> triangles = triangles_of(*shapes, shape);
        EXPECT_GT(volume_of(triangles), 0.0) << static_cast<int>(shape);
        for (const Triangle& triangle : triangles) {
            const glm::dvec3 area = area_of(triangle);
            ASSERT_GT(glm::length(area), 1e-5);
            for (const Corner& corner : triangle) {
                EXPECT_NEAR(glm::length(corner.normal), 1, 0.02);
                EXPECT_GT(glm::dot(corner.normal, area), 0) << static_cast<int>(shape);
            }
        }
    }
}

TEST_F(GlyphShapesTest, SolidsAreClosed) {
    // Each open edge counts both ways: the bottom of a box, and where an arrow's shaft ends upon its tip.
    const std::map<GlyphShape, int> open = {{GlyphShape::box, 8}, {GlyphShape::arrow, 14}, {GlyphShape::plain_arrow, 8}};
    for (const GlyphShape shape : kSolids)
        EXPECT_EQ(open_edges(triangles_of(*shapes, shape)), open.count(shape) > 0 ? open.at(shape) : 0)
            << static_cast<int>(shape);
    std::vector<Triangle> broken = triangles_of(*shapes, GlyphShape::cone);
    broken.pop_back();
    EXPECT_GT(open_edges(broken), 0) << "the check can fail";
}

TEST_F(GlyphShapesTest, VolumesAreThoseOfTheSolids) {
    constexpr double kPi = 3.14159265358979;
    const auto volume = [&](GlyphShape shape) { return volume_of(triangles_of(*shapes, shape)); };
    EXPECT_NEAR(volume(GlyphShape::sphere), kPi / 6, 0.07) << "a polyhedron in a ball";
    EXPECT_NEAR(volume(GlyphShape::cone), kPi / 12, 0.02);
    EXPECT_NEAR(volume(GlyphShape::tetrahedron), std::sqrt(3.0) / 4 * 0.75 / 3, 1e-6);
    const auto less = [&](GlyphShape shape) {
        return shapes->mesh(plain_variant(shape)).vertices < shapes->mesh(shape).vertices;
    };
    EXPECT_TRUE(less(GlyphShape::arrow));
    EXPECT_TRUE(less(GlyphShape::sphere));
    EXPECT_TRUE(less(GlyphShape::cone));
    EXPECT_EQ(plain_variant(GlyphShape::box), GlyphShape::box);
}

TEST_F(GlyphShapesTest, FlatShapesAreSeenFromAboveAndHaveNoNormals) {
    for (std::size_t n = 0; n < kGlyphShapes; ++n) {
        const auto shape = static_cast<GlyphShape>(n);
        if (!is_flat(shape)) continue;
        bool has_rim = false;
        for (const Triangle& triangle : triangles_of(*shapes, shape)) {
            EXPECT_GT(area_of(triangle).z, 0) << n;
            for (const Corner& corner : triangle) {
                EXPECT_EQ(glm::length(corner.normal), 0);
                EXPECT_EQ(corner.place.z, 0);
                has_rim = has_rim || corner.tone == 0;
            }
        }
        EXPECT_EQ(has_rim, shape != GlyphShape::puff) << n;
    }
}

/// Points at random lie in one triangle or in none.
TEST_F(GlyphShapesTest, NoTwoTrianglesOfAFlatShapeCoverEachOther) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> across(-0.6, 0.6);
    for (std::size_t n = 0; n < kGlyphShapes; ++n) {
        if (!is_flat(static_cast<GlyphShape>(n))) continue;
        const std::vector<Triangle> triangles = triangles_of(*shapes, static_cast<GlyphShape>(n));
        int covered = 0;
        for (int k = 0; k < 3000; ++k) {
            const glm::dvec3 point(across(random), across(random), 0);
            int inside = 0;
            for (const Triangle& t : triangles) {
                bool is_left = true;
                for (int c = 0; c < 3; ++c)
                    is_left = is_left && glm::cross(t[(c + 1) % 3].place - t[c].place, point - t[c].place).z > 0;
                inside += is_left;
            }
            ASSERT_LE(inside, 1) << n;
            covered += inside;
        }
        EXPECT_GT(covered, 200) << n;
    }
}

TEST_F(GlyphShapesTest, RimsReachRoundTheirShapes) {
    for (const GlyphShape shape : {GlyphShape::flat_arrow, GlyphShape::triangle, GlyphShape::circle, GlyphShape::cross}) {
        double lowest[2] = {0, 0}, highest[2] = {0, 0};
        for (const Triangle& triangle : triangles_of(*shapes, shape))
            for (const Corner& corner : triangle) {
                const int part = corner.tone == 0 ? 0 : 1;
                lowest[part] = std::min(lowest[part], corner.place.x);
                highest[part] = std::max(highest[part], corner.place.x);
            }
        EXPECT_LT(lowest[0], lowest[1] - 0.02);
        EXPECT_GT(highest[0], highest[1] + 0.02);
    }
}

TEST_F(GlyphShapesTest, ArrowsPointAlongX) {
    for (const GlyphShape shape : {GlyphShape::arrow, GlyphShape::plain_arrow, GlyphShape::flat_arrow}) {
        double front_width = 0, back_width = 0;
        for (const Triangle& triangle : triangles_of(*shapes, shape))
            for (const Corner& corner : triangle) {
                if (corner.tone == 0) continue;
                if (corner.place.x > 0.49) front_width = std::max(front_width, std::abs(corner.place.y));
                if (corner.place.x < -0.49) back_width = std::max(back_width, std::abs(corner.place.y));
            }
        EXPECT_LT(front_width, 1e-6) << "a tip";
        EXPECT_GT(back_width, 0.05);
    }
}

TEST_F(GlyphShapesTest, APuffFadesToItsEdge) {
    for (const Triangle& triangle : triangles_of(*shapes, GlyphShape::puff))
        for (const Corner& corner : triangle) {
            const double radius = glm::length(corner.place);
            EXPECT_EQ(corner.opacity, radius < 0.01 ? 255 : radius > 0.49 ? 0 : 150);
        }
}

}  // namespace
}  // namespace tedavis::draw::test_glyph_shapes
