#include "render_core/raytrace/hit_place.hpp"

#include <gtest/gtest.h>

#include "tests/support/raytrace/traced_view.hpp"

namespace tedavis::raytrace::test_hit_place {
namespace {

constexpr std::uint32_t kWidth = 96, kHeight = 64;

/// A picture by a kernel, with the positions of its hits in their cells.
struct PlacedPicture : test_support::TracedPicture {
    explicit PlacedPicture(const TracedField<float>& field, const GridCamera& camera) : TracedPicture(kWidth, kHeight) {
        base::SerialWorkers alone;
        test_support::trace_view(field, camera, view_kernels<float>()[0], alone, kWidth, kHeight, {t, cell, side, u, v});
    }
    std::vector<float> u = std::vector<float>(kWidth * kHeight), v = u;
};

class HitPlaceTest : public ::testing::Test {
protected:
    /// How many hits of pictures have other bits by hit_place() of a ray whose direction is off by a part; and hits in all.
    std::size_t count_other_bits(float off, std::size_t& hit_count) {
        std::mt19937 random(3);
        const auto field = hills_.field(CellSurface::two_triangles);
        std::size_t other = 0;
        for (int n = 0; n < 8; ++n) {
            const GridCamera camera = test_support::any_camera(random, 90, 70, kWidth);
            const PlacedPicture picture(field, camera);
            for (std::uint32_t at = 0; at < kWidth * kHeight; ++at) {
                Ray ray = camera.ray(at % kWidth, at / kWidth);
                const Hit hit = trace_ray(field, ray);
                if (hit.side == HitSide::none) continue;
                ray.direction *= 1 + off;
                const HitPlace place = hit_place(ray, hit);
                ++hit_count;
                other += std::memcmp(&place.u, &picture.u[at], sizeof(float)) != 0 ||
                         std::memcmp(&place.v, &picture.v[at], sizeof(float)) != 0;
                const glm::dvec3 exact = ray.origin + double{hit.t} * glm::dvec3(ray.direction);
                if (off != 0) continue;
                EXPECT_NEAR(place.u, std::clamp(exact.x - hit.column, 0.0, 1.0), 1e-4);
                EXPECT_NEAR(place.v, std::clamp(exact.y - hit.row, 0.0, 1.0), 1e-4);
            }
        }
        return other;
    }
    test_support::ViewedHills<float> hills_{90, 70, true};
};

TEST_F(HitPlaceTest, IsThatOfTheVectorKernels) {
    std::size_t hit_count = 0;
    EXPECT_EQ(count_other_bits(0, hit_count), 0u);
    EXPECT_GT(hit_count, 5000u);
}

TEST_F(HitPlaceTest, TheComparisonSeesARayThatIsOff) {
    std::size_t hit_count = 0;
    EXPECT_GT(count_other_bits(1e-6f, hit_count), 1000u);
}

}  // namespace
}  // namespace tedavis::raytrace::test_hit_place
