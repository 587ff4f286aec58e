// Icons, names, diagrams and barbs of the data elements on their sheet.
#include <gtest/gtest.h>

#include "tests/support/display/shown_elements.hpp"

namespace tedavis::display::test_element_signs {
namespace {

using design::DataTechnique;

class ElementSigns : public test_support::ShownElements {
protected:
    void plan_signs(const SignFrame& signs) {
        const ElementFrame frame{ground_, frame_.view, {}, flight::time_of_source(test_support::kNow)};
        elements_.plan(frame);
        elements_.plan_signs(frame, signs);
    }
    static constexpr double kText_px = 4;
};

TEST_F(ElementSigns, AreCountedByTheirElements) {
    ask_for("masts", DataTechnique::billboard);
    elements_.set(&scene_.scene(), asked_);
    plan_signs({kText_px});
    const draw::ElementCount& count = elements_.reports()[0].count;
    EXPECT_GT(count.drawn, 0u);
    EXPECT_EQ(count.all(), 3u);
    EXPECT_EQ(elements_.label_counts().changed, count.drawn);
    EXPECT_GT(drawn_pixels(), 0u);
    plan_signs({kText_px});
    EXPECT_EQ(elements_.label_counts().changed, 0u);
    elements_.rest();
    EXPECT_EQ(elements_.label_counts().placed, 0u);
    plan_signs({kText_px});
    EXPECT_EQ(elements_.label_counts().changed, count.drawn) << "they come again";
}

TEST_F(ElementSigns, APictureForEachEyeIsNoFrameOfItsOwn) {
    ask_for("masts", DataTechnique::billboard);
    elements_.set(&scene_.scene(), asked_);
    plan_signs({kText_px});
    const LabelCounts counts = elements_.label_counts();
    SignFrame of_one_eye{kText_px};
    of_one_eye.is_planned_again = true;
    plan_signs(of_one_eye);
    EXPECT_EQ(elements_.label_counts().changed, counts.changed);
    EXPECT_GT(elements_.reports()[0].count.drawn, 0u);
    plan_signs({kText_px});
    EXPECT_EQ(elements_.label_counts().changed, 0u);
}

}  // namespace
}  // namespace tedavis::display::test_element_signs
