// Pictures whose rays are the hard ones: upright, level, on lines of posts, through posts, over thin grids, spikes and plateaus
// that the eye is on a level with. Beams and lanes must find what single rays find, bit for bit (NUMERICS A25, finding 7).
#include <gtest/gtest.h>

#include "tests/support/raytrace/kernel_check.hpp"
#include "tests/support/raytrace/traced_ground.hpp"

namespace tedavis::raytrace::test_ray_pictures {
namespace {

using test_support::HeightField;
using test_support::TracedGround;
using test_support::TracedPicture;
using Ground = TracedGround<std::int16_t>;

constexpr std::uint32_t kWidth = 62, kHeight = 43;

/// Looks along one axis of the grid, with pixels on its lines; 'wide' over many cells, or within one.
std::vector<GridCamera> hard_cameras(double columns, double rows, double height) {
    std::vector<GridCamera> cameras;
    const double middle = std::floor(columns / 2), line = std::floor(rows / 2);
    const auto add = [&](const glm::dvec3& origin, const glm::vec3& forward, const glm::vec3& right, const glm::vec3& down) {
        // An eighth of a cell or so a pixel, exact in floats; half a pixel off, so that some rays have components of zero.
        const glm::vec3 corner = forward - right * (kWidth / 2 + 0.5F) - down * (kHeight / 2 + 0.5F);
        cameras.push_back({origin, corner, right, down});
    };
    for (const double z : {height, height + 0.5, height / 2, height * 3 + 10}) {
        for (const float pixel : {0.015625F, 0.125F}) {
            const float climb = pixel * 32;
            add({middle, -4, z}, {0, 1, 0}, {pixel, 0, 0}, {0, 0, -climb});
            add({middle + 0.5, rows + 3, z}, {0, -1, 0}, {-pixel, 0, 0}, {0, 0, -climb});
            add({-4, line, z}, {1, 0, 0}, {0, -pixel, 0}, {0, 0, -climb});
            add({middle, line, z}, {1, 1, 0}, {-pixel, pixel, 0}, {0, 0, -climb});
            add({middle, line, z}, {-1, 0, -8}, {0, pixel, 0}, {-pixel, 0, -climb});
            add({middle, line, z + 500}, {0, 0, -100}, {pixel, 0, 0}, {0, pixel, 0});
            add({middle + 0.5, line + 0.25, z + 500}, {0, 0, -4000}, {pixel, 0, 0}, {0, pixel, 0});
            add({middle, line, z}, {0, 0, 100}, {pixel, 0, 0}, {0, pixel, 0});
            // A picture of one row of rays, and of one column.
            add({-4, line, z}, {1, 0, -1}, {0, 0, 0}, {0, 0, -climb});
            add({-4, line, z}, {1, 0, -1}, {0, pixel, 0}, {0, 0, 0});
        }
    }
    return cameras;
}

struct Fault {
    std::size_t pixels = 0, hits = 0;
};

/// By every kernel that this machine runs.
Fault differing(const Ground& drawn, const Ground& singly_traced, double height) {
    Fault fault;
    base::SerialWorkers workers;
    for (const CellSurface surface : {CellSurface::two_triangles, CellSurface::bilinear}) {
        for (const GridCamera& camera : hard_cameras(drawn.field.columns, drawn.field.rows, height)) {
            const TracedPicture singly = test_support::traced_singly(singly_traced.traced(surface), camera, kWidth, kHeight);
            for (const HitSide side : singly.side) fault.hits += side != HitSide::none;
            for (const ViewKernel<std::int16_t>& kernel : view_kernels<std::int16_t>()) {
                const std::size_t different =
                    test_support::traced_by(kernel, drawn.traced(surface), camera, kWidth, kHeight, workers).differences(singly);
                fault.pixels += different;
            }
        }
    }
    return fault;
}

TEST(RayPictures, HardRaysAreTheSameInBeamsAndLanes) {
    HeightField<std::int16_t> spikes(131, 90), terraces = test_support::rough_heights(64, 65, 3, 1);
    for (std::uint32_t n = 0; n < spikes.posts.size(); n += 331) spikes.posts[n] = 400;
    for (std::int16_t& post : terraces.posts) post = static_cast<std::int16_t>(post * 100);
    struct Case {
        const char* name;
        HeightField<std::int16_t> field;
        double height;
    };
    HeightField<std::int16_t> holes = test_support::rough_heights(70, 66, 300, 4);
    test_support::add_voids(holes, 15);
    for (const Case& one : {Case{"spikes", spikes, 400}, Case{"terraces", terraces, 300},
                            Case{"rough", test_support::rough_heights(67, 50, 200, 2), 200},
                            Case{"thin", test_support::rough_heights(2, 300, 200, 3), 200},
                            Case{"low", test_support::rough_heights(300, 2, 200, 3), 200},
                            Case{"one cell", test_support::rough_heights(2, 2, 90, 5), 90},
                            Case{"plain", HeightField<std::int16_t>(65, 33, 100), 100}, Case{"holes", holes, 300}}) {
        for (const Ground::Starts starts : {Ground::Starts::above, Ground::Starts::anywhere}) {
            const Ground ground(one.field, starts);
            const Fault fault = differing(ground, ground, one.height);
            EXPECT_EQ(fault.pixels, 0U) << one.name;
            EXPECT_GT(fault.hits, one.field.posts.size() > 4 ? 5000U : 100U) << one.name;
        }
    }
}

TEST(RayPictures, TheCheckSeesOneLostSpike) {
    HeightField<std::int16_t> field(131, 90);
    for (std::uint32_t n = 0; n < field.posts.size(); n += 331) field.posts[n] = 400;
    const Ground whole(field);
    field.posts[331 * 18] = 0;
    const Ground lacking(field);
    EXPECT_GT(differing(lacking, whole, 400).pixels, 10U);
}

}  // namespace
}  // namespace tedavis::raytrace::test_ray_pictures
