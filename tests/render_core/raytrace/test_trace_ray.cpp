#include "render_core/raytrace/trace_ray.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "render_core/base/check.hpp"

namespace tedavis::raytrace::test_trace_ray {
namespace {

/// A slope that rises by 10 a column and 3 a row.
template <class Height>
class Slope {
public:
    Slope() : posts_(kSide * kSide) {
        for (std::uint32_t n = 0; n < kSide * kSide; ++n) posts_[n] = static_cast<Height>(10 * (n % kSide) + 3 * (n / kSide));
        build();
    }
    void build() {
        base::SerialWorkers workers;
        for (int n = 0; n < 2; ++n) {
            memory_[n].resize(HeightMipmap<Height>::bytes_needed(kSide, kSide) / 8 + 1);
            base::Arena arena(memory_[n].data(), memory_[n].size() * 8);
            TEDAVIS_CHECK(bounds_[n].start({posts_.data(), kSide, kSide, kSide}, arena));
            bounds_[n].build(workers);
        }
    }
    [[nodiscard]] TracedField<Height> field(bool has_minima = true) const {
        return {&bounds_[0], has_minima ? &bounds_[1] : nullptr, CellSurface::two_triangles};
    }
    Height& post(std::uint32_t column, std::uint32_t row) { return posts_[row * kSide + column]; }

    static constexpr std::uint32_t kSide = 40;

private:
    std::vector<Height> posts_;
    std::vector<std::uint64_t> memory_[2];
    HeightMipmap<Height> bounds_[2]{HeightMipmap<Height>(HeightBound::maximum), HeightMipmap<Height>(HeightBound::minimum)};
};

template <class Height>
class TraceRay : public ::testing::Test {
protected:
    Slope<Height> slope_;
};
using Heights = ::testing::Types<std::int16_t, float>;
TYPED_TEST_SUITE(TraceRay, Heights);

TYPED_TEST(TraceRay, MeetsAPlaneWhereItIs) {
    const Ray ray{{5.25, 30.5, 400}, {0.5f, -0.25f, -20}};
    const Hit hit = trace_ray(this->slope_.field(), ray);
    // 10 x + 3 y = z on the ray
    const double t = (400 - 10 * 5.25 - 3 * 30.5) / (20 + 10 * 0.5 - 3 * 0.25);
    ASSERT_EQ(hit.side, HitSide::above);
    EXPECT_NEAR(hit.t, t, 1e-5);
    EXPECT_EQ(hit.column, static_cast<std::uint32_t>(std::floor(5.25 + 0.5 * t)));
    EXPECT_EQ(hit.row, static_cast<std::uint32_t>(std::floor(30.5 - 0.25 * t)));
}

TYPED_TEST(TraceRay, KeepsToItsLimits) {
    Ray ray{{5.25, 30.5, 400}, {0.5f, -0.25f, -20}};
    const float t = trace_ray(this->slope_.field(), ray).t;
    ray.to = t * 0.999f;
    EXPECT_EQ(trace_ray(this->slope_.field(), ray).side, HitSide::none);
    ray.to = t * 1.001f;
    EXPECT_NEAR(trace_ray(this->slope_.field(), ray).t, t, 1e-5f);
    ray.from = t * 0.9f;
    EXPECT_NEAR(trace_ray(this->slope_.field(), ray).t, t, 1e-5f);
    ray.from = t * 1.0001f;  // below it, on the way down
    EXPECT_EQ(trace_ray(this->slope_.field(), ray).side, HitSide::none);
}

TYPED_TEST(TraceRay, ComesUpFromBelowOnlyWithTheLowestHeights) {
    const Ray ray{{20.5, 20.5, -50}, {0.125f, 0.25f, 10}};
    const Hit hit = trace_ray(this->slope_.field(), ray);
    ASSERT_EQ(hit.side, HitSide::below);
    EXPECT_NEAR(hit.t, (13 * 20.5 + 50) / (10 - 10 * 0.125 - 3 * 0.25), 1e-4);
    EXPECT_EQ(trace_ray(this->slope_.field(false), ray).side, HitSide::none);
}

TYPED_TEST(TraceRay, PassesCellsWithoutHeightsAndSeesTheGroundBehindThemFromBelow) {
    const Ray down{{20.5, 20.5, 1000}, {0.0625f, 0, -100}};
    ASSERT_EQ(trace_ray(this->slope_.field(), down).side, HitSide::above);
    for (std::uint32_t column = 18; column < 25; ++column) this->slope_.post(column, 20) = HeightGrid<TypeParam>::kVoid;
    this->slope_.build();
    EXPECT_EQ(trace_ray(this->slope_.field(), down).side, HitSide::none);
    // Through the hole, and up again under the slope behind it.
    const Ray up{{21, 20.5, 150}, {1, 0, 25}};
    const Hit hit = trace_ray(this->slope_.field(), up);
    ASSERT_EQ(hit.side, HitSide::below);
    EXPECT_NEAR(hit.t, (10 * 21 + 3 * 20.5 - 150) / (25 - 10), 1e-4);
}

TYPED_TEST(TraceRay, AnswersWhatIsOutOfReachWithNothing) {
    const TracedField<TypeParam> field = this->slope_.field();
    for (const double far : {2e9, -2e9, 1e300})
        for (const glm::dvec3& origin : {glm::dvec3(far, 1, 1), glm::dvec3(1, far, 1), glm::dvec3(1, 1, far)})
            EXPECT_EQ(trace_ray(field, {origin, {1, 1, -1}}).side, HitSide::none);
    EXPECT_EQ(trace_ray(field, {{std::nan(""), 1, 1}, {1, 1, -1}}).side, HitSide::none);
    EXPECT_EQ(trace_ray(field, {{-5, -5, 1000}, {-1, 1, -1}}).side, HitSide::none);
}

}  // namespace
}  // namespace tedavis::raytrace::test_trace_ray
