// The surface against the one that another program takes from the same volume; tests/golden/isosurface says how it was made.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "tests/support/files/paths.hpp"
#include "tests/support/scene/surface_topology.hpp"
#include "tests/support/scene/volume_surface.hpp"

namespace tedavis::scene::test_isosurface_reference {
namespace {

using test_support::MadeSurface;

constexpr float kLevel = 0.45f;

test_support::Volume ring_and_balls() {
    return test_support::sampled_volume(22, 20, 14, [](const glm::dvec3& p) {
        const auto ball = [&](const glm::dvec3& middle, double width) {
            const glm::dvec3 d = p - middle;
            return std::exp(-glm::dot(d, d) / width);
        };
        const double ring = std::hypot(p.x - 9.3, p.y - 9.6) - 6.1;
        return std::exp(-(ring * ring + (p.z - 6.4) * (p.z - 6.4)) / 5.0) + 0.9 * ball({9.1, 9.4, 6.7}, 4) +
               0.9 * ball({17.2, 9.9, 7.1}, 5);
    });
}

struct Reference {
    long euler_number = 0;
    double area = 0, enclosed = 0;
    double fine_area = 0, fine_enclosed = 0;  ///< on a finer grid
    std::vector<glm::dvec3> vertices;
};

Reference read_reference() {
    std::ifstream file(test_support::source_dir() + "/tests/golden/isosurface/reference.txt");
    std::string comment;
    while (file.peek() == '#') std::getline(file, comment);
    Reference read;
    std::size_t count = 0;
    file >> read.euler_number >> read.area >> read.enclosed >> read.fine_area >> read.fine_enclosed >> count;
    read.vertices.resize(count);
    for (glm::dvec3& v : read.vertices) file >> v.x >> v.y >> v.z;
    EXPECT_TRUE(file.good()) << "reference.txt is shorter than it says";
    return read;
}

double distance_to_nearest(const MadeSurface& surface, const glm::dvec3& place) {
    double nearest = 1e9;
    for (const IsosurfaceVertex& vertex : surface.vertices)
        nearest = std::min(nearest, glm::length(glm::dvec3(vertex.position) - place));
    return nearest;
}

TEST(IsosurfaceReference, ShapeIsThatOfAnotherProgram) {
    const Reference reference = read_reference();
    const MadeSurface surface = test_support::surface_of(ring_and_balls(), kLevel);
    const auto found = test_support::topology_of(surface.indices, surface.vertices.size());
    EXPECT_TRUE(found.is_closed());
    EXPECT_EQ(found.euler_number(), reference.euler_number);
    EXPECT_EQ(found.pieces, 2u);
    EXPECT_NEAR(surface.enclosed(), reference.fine_enclosed, std::abs(reference.enclosed - reference.fine_enclosed));
    EXPECT_NEAR(surface.area(), reference.fine_area, std::abs(reference.area - reference.fine_area));
}

TEST(IsosurfaceReference, ItsVerticesAreAmongOurs) {
    const Reference reference = read_reference();
    const MadeSurface surface = test_support::surface_of(ring_and_balls(), kLevel);
    // It has those on edges along the axes, interpolated alike; digits of the file.
    ASSERT_GT(reference.vertices.size(), 500u);
    double worst = 0;
    for (const glm::dvec3& vertex : reference.vertices) worst = std::max(worst, distance_to_nearest(surface, vertex));
    EXPECT_LT(worst, kIsosurfaceMargin + 2e-5);
    // Control: another level has none of them.
    const MadeSurface other = test_support::surface_of(ring_and_balls(), kLevel + 0.02f);
    EXPECT_GT(distance_to_nearest(other, reference.vertices.front()), 0.01);
}

}  // namespace
}  // namespace tedavis::scene::test_isosurface_reference
