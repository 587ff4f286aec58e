#include "render_core/display/planner/declutter_control.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "render_core/design/design_settings.hpp"
#include "render_core/draw/drawers/picture_edges.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::display::test_declutter_control {
namespace {

using Step = DeclutterControl::Step;
using test_support::GlSession;

constexpr std::uint32_t kWidth = 320, kHeight = 240;
constexpr double kBudget = 0.1;
constexpr std::size_t kStriped = 8 * 2 + 1, kCalm = 8 * 2 + 6;  // regions

design::DesignSettings design_with(double budget, design::ClutterView view = design::ClutterView::none) {
    design::DesignSettings design;
    design.priority.is_stated = true;
    design.priority.clutter_budget = budget;
    design.effects.clutter = view;
    return design;
}

base::Time at(double seconds) { return base::Time{} + base::Duration::from_seconds(seconds); }

/// A control of pictures with vertical stripes on their left half.
class Striped {
public:
    explicit Striped(const std::string& device, const design::DesignSettings& design = design_with(kBudget))
        : session_("egl", device, kWidth, kHeight), triangle_(session_.gl) {
        line_.bytes = std::uint64_t{4} * kWidth * kHeight;
        auto texture =
            gl::make_texture(session_.gl, line_, {gl::TextureFormat::rgba8, gl::TextureFilter::nearest, kWidth, kHeight});
        texture_ = std::move(texture.value());
        const draw::DrawnDesign drawn{&design};
        control.start(session_.device.capability.lane, {&drawn, 1});
        if (control.measures()) {
            memory_.resize(draw::PictureEdges::bytes(kWidth, kHeight));
            base::Arena arena(memory_.data(), memory_.size());
            const base::Error error = edges_.start(session_.gl, session_.device.budget, arena, kWidth, kHeight, control.shows());
            EXPECT_EQ(error.message.view(), "");
        }
        session_.gl.seal();
    }
    ~Striped() {
        EXPECT_EQ(session_.gl.denied().total, 0u);
        session_.gl.retire();
        edges_.destroy(session_.gl);
        EXPECT_EQ(target_bytes(), 0u);
        texture_.destroy(session_.gl);
        triangle_.destroy(session_.gl);
    }
    Striped(const Striped&) = delete;
    Striped& operator=(const Striped&) = delete;

    /// So many pixels from one stripe to the next with all detail, and with the least.
    void frame(double seconds, int whole_px, int least_px, std::size_t design = 0, bool runs = true) {
        control.plan(runs, at(seconds), design, kBudget);
        measured = 0;
        while (control.step() != Step::none && measured < 9) {
            put(control.step() == Step::whole ? whole_px : control.step() == Step::least ? least_px : tried_px);
            control.take(edges_.measure(session_.gl, *session_.surface));
            ++measured;
        }
    }
    [[nodiscard]] double left(double seconds, std::size_t region = kStriped, std::size_t design = 0) const {
        return static_cast<double>(control.regions(at(seconds), design).factor[region]);
    }
    [[nodiscard]] std::uint64_t target_bytes() { return session_.device.budget.find(effects::kRenderTargets)->use.in_use; }

    [[nodiscard]] bool has_edges() const { return edges_.is_started(); }

    DeclutterControl control;
    int measured = 0;   ///< pictures, by the last frame
    int tried_px = 32;  ///< of the picture that may suffice

private:
    std::vector<unsigned char> memory_;
    draw::PictureEdges edges_;
    void put(int stripe_px) {
        std::vector<std::uint8_t> rgba(std::size_t{4} * kWidth * kHeight, 90);
        for (std::size_t n = 0; n < rgba.size(); n += 4) {
            const int x = static_cast<int>(n / 4 % kWidth);
            if (x < static_cast<int>(kWidth) / 2 && x % stripe_px < stripe_px / 2) rgba[n] = rgba[n + 1] = 255;
        }
        EXPECT_TRUE(texture_.upload(session_.gl, {0, 0, kWidth, kHeight}, rgba.data()));
        gl::bind_surface(session_.gl, *session_.surface);
        triangle_.copy(session_.gl, texture_);
    }

    GlSession session_;
    test_support::ScreenTriangle triangle_;
    base::BudgetLine line_;
    gl::Texture texture_;
};

TEST(DeclutterControl, OnlyWhatIsBeyondTheBudgetGivesWayAndOnlyFromTheNextIntervalOn) {
    Striped striped("es3-mid");
    striped.frame(9.5, 160, 160);
    EXPECT_EQ(striped.measured, 1) << "within the budget: nobody asks for the least";
    EXPECT_EQ(striped.left(10), 1);
    striped.frame(10, 10, 40);
    EXPECT_EQ(striped.measured, 3);
    EXPECT_EQ(striped.left(10.4), 1) << "the frames of this interval go by those before";
    striped.frame(10.4, 10, 40);
    EXPECT_EQ(striped.measured, 0) << "once an interval";
    EXPECT_LT(striped.left(10.5), 0.9);
    EXPECT_GT(striped.left(10.5), effects::kMinDetailLeft);
    EXPECT_EQ(striped.left(10.5, kCalm), 1);
    const effects::ClutterMeasures measures = striped.control.measured(at(10.5), 0).clutter;
    EXPECT_NEAR(static_cast<double>(measures.whole.measure[kStriped]), 0.2, 0.03) << "two edges in ten pixels";
    EXPECT_NEAR(static_cast<double>(measures.least.measure[kStriped]), 0.05, 0.03);
}

TEST(DeclutterControl, WhatSufficesIsNotTriedFurther) {
    Striped striped("es3-mid");
    striped.frame(10, 10, 40);
    EXPECT_EQ(striped.measured, 3);
    EXPECT_GT(striped.left(10.5), effects::kMinDetailLeft);
    EXPECT_EQ(striped.left(10.5, kCalm), 1);
}

TEST(DeclutterControl, WhereNothingThatIsTriedSufficesAllKeepTheLeast) {
    Striped striped("es3-mid");
    striped.tried_px = 12;
    striped.frame(10, 10, 40);
    EXPECT_EQ(striped.measured, 2 + DeclutterControl::kMaxTries);
    EXPECT_EQ(striped.left(10.5), effects::kMinDetailLeft);
    EXPECT_EQ(striped.left(10.5, kCalm), effects::kMinDetailLeft);
    EXPECT_NEAR(static_cast<double>(striped.control.measured(at(10.5), 0).reached.measure[kStriped]), 2.0 / 40, 0.03);
}

TEST(DeclutterControl, WhatGaveWayComesBackTwoSecondsAfter) {
    Striped striped("es3-mid");
    striped.frame(9.5, 160, 160);
    striped.frame(10, 10, 40);
    const double least = striped.left(10.5);
    ASSERT_LT(least, 0.9);
    for (double seconds = 10.5; seconds < 14; seconds += 0.5) {
        striped.frame(seconds, 160, 160);
        EXPECT_EQ(striped.left(seconds), seconds <= 12 ? least : 1) << seconds;
    }
    EXPECT_TRUE(striped.control.regions(at(30), 0).is_whole()) << "what was so long ago says nothing";
}

TEST(DeclutterControl, AtAFlightsBeginningAFrameGoesByItsOwnInterval) {
    Striped striped("es3-mid");
    EXPECT_EQ(striped.left(10), 1);
    striped.frame(10, 10, 40);
    const double own = striped.left(10.1);
    EXPECT_LT(own, 0.9);
    striped.control.forget();
    EXPECT_EQ(striped.left(10.1), 1);
    striped.frame(10.1, 10, 40);
    EXPECT_EQ(striped.measured, 3) << "anew";
    EXPECT_EQ(striped.left(10.1), own);
}

TEST(DeclutterControl, WhatAnotherDesignMeasuredDoesNotCount) {
    Striped striped("es3-mid");
    striped.frame(10, 10, 40);
    EXPECT_LT(striped.left(10.5), 0.9) << "control";
    EXPECT_EQ(striped.left(10.5, kStriped, 1), 1);
    striped.frame(10.2, 160, 160, 1);
    EXPECT_EQ(striped.measured, 1) << "within the interval, for the design that is shown now";
    EXPECT_EQ(striped.left(10.5, kStriped, 1), 1);
}

TEST(DeclutterControl, TheSameInstantSeenFromElsewhereFollowsFromNothing) {
    Striped striped("es3-mid");
    terrain::View view;
    view.eye = {1, 2, 3};
    view.forward = {1, 0, 0};
    striped.control.follow(at(10), view);
    striped.frame(10, 10, 40);
    view.eye.x = 2;
    striped.control.follow(at(10.5), view);
    EXPECT_LT(striped.left(10.5), 0.9) << "control: it flies there";
    view.eye.x = 500;
    striped.control.follow(at(10.5), view);
    EXPECT_EQ(striped.left(10.5), 1);
}

TEST(DeclutterControl, NothingIsMeasuredWhereItDoesNotRun) {
    Striped striped("es3-mid");
    striped.frame(10, 10, 40, 0, false);
    EXPECT_EQ(striped.measured, 0);
    EXPECT_FALSE(striped.control.must_be_drawn());
    striped.control.plan(true, at(10), 0, kBudget);
    EXPECT_TRUE(striped.control.must_be_drawn()) << "control";
    striped.control.plan(true, at(10), 0, 1);
    EXPECT_FALSE(striped.control.must_be_drawn()) << "no budget";
}

TEST(DeclutterControl, TheSmallLaneMeasuresEverySecond) {
    for (const bool is_small : {true, false}) {
        Striped striped(is_small ? "es2-small" : "es3-mid");
        striped.frame(10, 10, 40);
        striped.frame(10.5, 10, 40);
        EXPECT_EQ(striped.measured, is_small ? 0 : 3);
        for (const double seconds : {11.0, -0.2, 0.2}) {
            striped.frame(seconds, 10, 40);
            EXPECT_EQ(striped.measured, 3) << "before the source's zero is another interval than after it";
        }
        EXPECT_EQ(striped.control.needed_since(at(20.7)).ns, at(is_small ? 18 : 18.5).ns);
    }
}

TEST(DeclutterControl, WhoHasNoBudgetAndShowsNoEdgesPaysNothing) {
    {
        Striped without("es3-mid", design_with(1));
        EXPECT_FALSE(without.has_edges());
        EXPECT_EQ(without.control.needed_since(at(20.7)).ns, at(20.7).ns);
        EXPECT_TRUE(without.control.can_show(design_with(1)));
        EXPECT_FALSE(without.control.can_show(design_with(0.5)));
    }
    {
        Striped with("es3-mid");
        EXPECT_TRUE(with.has_edges()) << "control";
        EXPECT_EQ(with.target_bytes(), 0u) << "nothing of the GPU's, as nothing is shown";
        EXPECT_TRUE(with.control.can_show(design_with(0.5)));
        EXPECT_FALSE(with.control.can_show(design_with(0.5, design::ClutterView::edges)));
    }
    Striped viewed("es3-mid", design_with(1, design::ClutterView::edges));
    EXPECT_GT(viewed.target_bytes(), 0u);
    EXPECT_TRUE(viewed.control.can_show(design_with(1, design::ClutterView::regions)));
    EXPECT_FALSE(viewed.control.can_show(design_with(0.5)));
}

}  // namespace
}  // namespace tedavis::display::test_declutter_control
