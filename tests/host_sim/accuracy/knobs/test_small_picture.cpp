#include "host_sim/accuracy/knobs/small_picture.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_small_picture {
namespace {

constexpr SmallView kView = {16, 12};

double mean_difference(const base::Span<const glm::vec3>& light, const std::vector<glm::vec3>& other) {
    double sum = 0;
    for (std::size_t n = 0; n < light.size(); ++n) sum += light_difference(light[n], other[n]);
    return sum / static_cast<double>(light.size());
}

TEST(SmallPicture, DrawsWithTheChosenSettingOnly) {
    const test_support::MadeKnobGround made;
    raytrace::TraceSettings plain, lit;
    plain.surface.kind = lit.surface.kind = raytrace::SurfaceKind::two_triangles;
    plain.shading = raytrace::Shading::none;
    SmallPicture picture(made.ground, {plain, lit}, kView);
    picture.draw(1);
    const std::vector<glm::vec3> first(picture.light().begin(), picture.light().end());
    picture.draw(0);
    EXPECT_GT(mean_difference(picture.light(), first), 1e-3) << "control: light changes the picture";
    picture.draw(1);
    EXPECT_EQ(mean_difference(picture.light(), first), 0);
}

TEST(SmallPicture, AFinerPictureOfOnePartIsThePicture) {
    const test_support::MadeKnobGround made;
    raytrace::TraceSettings settings;
    settings.surface.kind = raytrace::SurfaceKind::two_triangles;
    SmallPicture picture(made.ground, {settings}, kView);
    picture.draw(0);
    EXPECT_EQ(mean_difference(picture.light(), light_of_finer(made.ground, settings, kView, 1)), 0);
    const double off = mean_difference(picture.light(), light_of_finer(made.ground, settings, kView, 4));
    EXPECT_GT(off, 0) << "control: means of 16 parts are smoother";
    EXPECT_LT(off, 0.2) << "and the same view";
}

TEST(SmallPicture, ADifferenceIsARootMeanSquare) {
    EXPECT_DOUBLE_EQ(light_difference({0.5f, 0.25f, 1}, {0.25f, 0.25f, 5}), 0.25 / std::sqrt(3.0));
}

}  // namespace
}  // namespace tedavis::host_sim::test_small_picture
