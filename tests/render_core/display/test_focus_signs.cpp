// Signs of the data elements, and what foci make of them.
#include <gtest/gtest.h>

#include "tests/support/display/foci_of_test.hpp"
#include "tests/support/display/shown_elements.hpp"

namespace tedavis::display::test_focus_signs {
namespace {

using test_support::FociOfTest;

/// Four towns 10 km ahead, a kilometre apart.
host_sim::SceneDraft towns_draft() {
    host_sim::SceneDraft draft = test_support::scene_draft();
    host_sim::LayerDraft towns;
    towns.name = "towns";
    towns.role = scene::LayerRole::place;
    for (int n = 0; n < 4; ++n) towns.points.push_back(test_support::scene_point(46.79, 9.80 + 0.013 * n, 600));
    towns.names = {"A", "B", "C", "D"};
    draft.layers = {towns};
    return draft;
}

class FocusSigns : public test_support::ShownElements {
protected:
    FocusSigns() : test_support::ShownElements(towns_draft()) {
        ask_for("towns", design::DataTechnique::billboard);
        frame_.view.width = 640;
        frame_.view.height = 480;
        frame_.view.focal_px = 550;
    }
    draw::ElementCount count(const FociOfTest* foci) {
        elements_.set(&scene_.scene(), asked_);
        elements_.labels().restore({});
        ElementFrame frame{ground_, frame_.view, {255, 0, 255}, flight::time_of_source(test_support::kNow)};
        frame.foci = foci == nullptr ? nullptr : &foci->frame();
        elements_.plan(frame);
        elements_.plan_signs(frame, {});
        return elements_.reports()[0].count;
    }
};

TEST_F(FocusSigns, OfAContextThatIsNotShownThereAreNone) {
    EXPECT_EQ(count(nullptr).drawn, 4u);
    const FociOfTest at_the_first(
        {R"(at = "position", position_deg = [46.79, 9.80], radius_m = 300, context.width_m = 1000, data.context = "hidden")"});
    EXPECT_EQ(count(&at_the_first).drawn, 2u) << "itself, and its neighbour beside it";
    EXPECT_EQ(count(&at_the_first).all(), 4u);
    const FociOfTest changes_nothing({R"(at = "position", position_deg = [46.79, 9.80], radius_m = 300)"});
    EXPECT_EQ(count(&changes_nothing).drawn, 4u);
}

TEST_F(FocusSigns, CuesLeadToWhatIsNotInThePicture) {
    const FociOfTest beside({R"(at = "position", position_deg = [46.7, 10.2], radius_m = 300)"});
    static_cast<void>(count(&beside));
    EXPECT_EQ(elements_.focus_cues()[0].sight, draw::FocusSight::out_of_view);
    EXPECT_TRUE(elements_.focus_cues()[0].is_drawn);
    static_cast<void>(count(nullptr));
    EXPECT_EQ(elements_.focus_cues()[0].sight, draw::FocusSight::nowhere);
}

}  // namespace
}  // namespace tedavis::display::test_focus_signs
