#include "host_sim/evaluation/lab_levels.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/evaluation/rgba_of.hpp"
#include "tests/support/perception/itti_reference.hpp"

namespace tedavis::host_sim::test_lab_levels {
namespace {

void expect_near(const perception::Plane& plane, const test_support::Field& field) {
    ASSERT_EQ(plane.width, field.width);
    ASSERT_EQ(plane.height, field.height);
    for (int y = 0; y < field.height; ++y)
        for (int x = 0; x < field.width; ++x) ASSERT_NEAR(static_cast<double>(plane.row(y)[x]), field(x, y), 2e-4);
}

TEST(LabLevels, AgreeWithTheFormulasAtEverySize) {
    for (const auto& [width, height] : {std::pair{41, 30}, std::pair{1, 3}}) {
        const auto picture = test_support::noise_picture(width, height, 8);
        const LabLevels levels(test_support::rgba_of(picture));
        auto reference = test_support::reference_lab(picture.view());
        for (int n = 0; n < LabLevels::kLevels; ++n) {
            expect_near(levels.level(n).lightness, reference[0]);
            expect_near(levels.level(n).a, reference[1]);
            expect_near(levels.level(n).b, reference[2]);
            for (test_support::Field& plane : reference) plane = test_support::reference_halved(plane);
        }
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_lab_levels
