#include "render_core/display/calibration_subject.hpp"

#include <gtest/gtest.h>

#include "tests/support/display/hills_display.hpp"

namespace tedavis::display::test_calibration_subject {
namespace {

TEST(CalibrationSubject, CostsAreThoseOfThisDisplayAlone) {
    test_support::MemoryBytes bytes(test_support::hills().image);
    test_support::HeadlessDisplay headless("egl", "es3-mid", 320, 240, &bytes);
    const effects::CalibrationSubject subject = calibration_subject(headless.display());
    EXPECT_EQ(subject.device.view(), "es3-mid");
    EXPECT_EQ(subject.width_px, 320u);
    EXPECT_EQ(subject.height_px, 240u);
    EXPECT_EQ(subject.renderer, headless.display().gl().driver().renderer);
}

}  // namespace
}  // namespace tedavis::display::test_calibration_subject
