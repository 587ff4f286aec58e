#include "render_core/effects/renderer_choice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "tests/support/files/hard_case.hpp"

namespace tedavis::effects::test_renderer_choice {
namespace {

base::Time at(double seconds) { return base::Time{} + base::Duration::from_seconds(seconds); }

RendererCosts costs(double triangles_ms, double rays_ms, double deadline_ms = 0) {
    return {true, triangles_ms, rays_ms, 2, deadline_ms};
}

class Choice : public ::testing::Test {
protected:
    RendererDecision frame(double seconds, const RendererCosts& of, TriangleFit fit = TriangleFit::exact_enough,
                           std::size_t design = 0) {
        return choice_.decide(at(seconds), design, of, fit);
    }
    /// Whether rays are drawn in all frames of a span, or triangles in all; fails where neither is.
    bool frames(double from_s, double to_s, const RendererCosts& of, TriangleFit fit = TriangleFit::exact_enough) {
        const bool first = frame(from_s, of, fit).by_rays;
        for (double t = from_s + 0.1; t < to_s; t += 0.1) EXPECT_EQ(frame(t, of, fit).by_rays, first) << t;
        return first;
    }
    RendererChoice choice_;
};

TEST_F(Choice, TheFirstFrameOfADesignIsDrawnByTheCheaperOne) {
    EXPECT_FALSE(frame(0, costs(5, 9)).by_rays);
    const RendererDecision next = frame(0.1, costs(9, 8.9), TriangleFit::exact_enough, 1);
    EXPECT_TRUE(next.by_rays) << "another design is decided at once, without a margin";
    EXPECT_EQ(next.why, RendererWhy::costs_no_more);
    EXPECT_TRUE(frame(0.2, costs(7, 7), TriangleFit::exact_enough, 2).by_rays) << "the exact one at equal costs";
    EXPECT_EQ(next.costs.rays_ms, 8.9);
}

TEST_F(Choice, AChangeMustSaveATenthForTwoSeconds) {
    ASSERT_FALSE(frame(0, costs(10, 12)).by_rays);
    EXPECT_FALSE(frames(0.1, 10, costs(10, 9.1)));
    EXPECT_EQ(frame(10, costs(10, 9.1)).why, RendererWhy::waits);
    EXPECT_FALSE(frames(10.1, 12.05, costs(10, 8)));
    EXPECT_TRUE(frame(12.11, costs(10, 8)).by_rays);
    EXPECT_TRUE(frames(13, 14.95, costs(8, 10)));
    EXPECT_FALSE(frame(15.01, costs(8, 10)).by_rays);
}

TEST_F(Choice, AnInterruptionBeginsTheDwellAnew) {
    ASSERT_FALSE(frame(0, costs(10, 12)).by_rays);
    static_cast<void>(frame(1, costs(10, 8)));
    static_cast<void>(frame(2.9, costs(10, 11)));
    static_cast<void>(frame(3, costs(10, 8)));
    EXPECT_FALSE(frame(4.9, costs(10, 8)).by_rays);
    EXPECT_TRUE(frame(5, costs(10, 8)).by_rays);
}

/// Changes over two minutes of costs that swing round the limit; in `without` those of a choice without hysteresis.
int changes_of_swings(double period_s, double share, int& without) {
    RendererChoice choice;
    int changes = 0;
    bool last = false, last_cheaper = false;
    without = 0;
    for (int n = 0; n < 30 * 120; ++n) {
        const double t = n / 30.0, rays_ms = 10 * (1 + share * std::sin(2 * M_PI * (t + 0.1) / period_s));
        const bool by_rays = choice.decide(at(t), 0, costs(10, rays_ms), TriangleFit::exact_enough).by_rays,
                   cheaper = rays_ms <= 10;
        changes += n > 0 && by_rays != last ? 1 : 0;
        without += n > 0 && cheaper != last_cheaper ? 1 : 0;
        last = by_rays;
        last_cheaper = cheaper;
    }
    return changes;
}

TEST(SwingingCosts, ChangeTheRendererOnlyWhereTheyAreLargeAndSlow) {
    int without = 0;
    const int quick = changes_of_swings(1.5, 0.3, without);
    EXPECT_EQ(quick, 0) << "the dwell";
    EXPECT_GT(without, 100);
    test_support::record_worst("A59", quick);
    test_support::record_control("A59", without);
    EXPECT_EQ(changes_of_swings(20, 0.05, without), 0) << "small: the tenth";
    EXPECT_EQ(without, 12);
    EXPECT_EQ(changes_of_swings(20, 0.5, without), 11) << "control: large and slow; the last one comes two seconds later";
}

TEST_F(Choice, RaysStandInWhereTrianglesAreNotExactEnough) {
    const RendererDecision first = frame(0, costs(5, 9), TriangleFit::is_short);
    EXPECT_TRUE(first.by_rays);
    EXPECT_EQ(first.why, RendererWhy::triangles_short);
    EXPECT_TRUE(frames(0.1, 2, costs(5, 9)));
    EXPECT_FALSE(frame(2.2, costs(5, 9)).by_rays) << "triangles are exact enough again, and cost less";
    EXPECT_FALSE(frames(2.3, 4.2, costs(5, 9), TriangleFit::is_short));
    EXPECT_TRUE(frame(4.4, costs(5, 9), TriangleFit::is_short).by_rays);
}

TEST_F(Choice, RaysThatExceedTheDeadlineAreNotDrawn) {
    const RendererDecision late = frame(0, costs(5, 15, 16), TriangleFit::is_short);
    EXPECT_FALSE(late.by_rays) << "with 2 ms for the rest of the frame";
    EXPECT_EQ(late.why, RendererWhy::rays_too_late);
    EXPECT_EQ(frame(0.05, costs(25, 15, 16), TriangleFit::exact_enough, 3).why, RendererWhy::rays_too_late)
        << "they would cost less";
    EXPECT_EQ(frame(0.06, costs(5, 15, 16), TriangleFit::exact_enough, 4).why, RendererWhy::costs_no_more);
    EXPECT_FALSE(frame(0.1, costs(25, 15, 16), TriangleFit::exact_enough, 1).by_rays) << "even if they cost less";
    EXPECT_TRUE(frame(0.2, costs(25, 15, 18)).by_rays) << "control: a later deadline";
    EXPECT_TRUE(frames(0.3, 2.2, costs(25, 17, 18)));
    EXPECT_FALSE(frame(2.4, costs(25, 17, 18)).by_rays) << "left after the dwell";
    EXPECT_TRUE(frame(2.5, costs(5, 20, 16), TriangleFit::none).by_rays) << "no triangles: at once, whatever it costs";
}

TEST_F(Choice, WithoutCostsTrianglesAreDrawnUnlessTheyShowNothing) {
    const RendererDecision unknown = frame(0, {});
    EXPECT_FALSE(unknown.by_rays);
    EXPECT_EQ(unknown.why, RendererWhy::costs_unknown);
    EXPECT_FALSE(frame(0.1, {}, TriangleFit::is_short, 1).by_rays) << "rays of unknown cost";
    EXPECT_TRUE(frame(0.2, {}, TriangleFit::none, 1).by_rays);
    EXPECT_FALSE(frame(0.3, {}, TriangleFit::exact_enough, 1).by_rays) << "no earlier frame matters";
}

/// What arrives meanwhile counts: a frame that is planned several times until its terrain is there.
TEST_F(Choice, TheSameInstantIsTheSameFrameDecidedAgain) {
    EXPECT_FALSE(frame(1, costs(5, 9)).by_rays);
    EXPECT_TRUE(frame(1, costs(20, 9)).by_rays);
    EXPECT_FALSE(frame(1, costs(5, 9)).by_rays);
    static_cast<void>(frame(2, costs(20, 9)));
    static_cast<void>(frame(4, costs(20, 9)));
    EXPECT_TRUE(frame(4, costs(20, 9)).by_rays);
    EXPECT_FALSE(frame(4, costs(9, 9.1)).by_rays) << "as if it had not been decided before";
}

TEST_F(Choice, AnEarlierTimeBeginsWithoutHistory) {
    ASSERT_TRUE(frame(3, costs(10, 5)).by_rays);
    EXPECT_FALSE(frame(2.5, costs(10, 12)).by_rays);
}

TEST_F(Choice, AfterAFrameWithoutAChoiceTheNextOneIsAFirstFrame) {
    ASSERT_TRUE(frame(0, costs(10, 5)).by_rays);
    ASSERT_TRUE(frame(0.1, costs(5, 10)).by_rays) << "control: it waits";
    choice_.rest(at(0.2));
    EXPECT_FALSE(frame(0.3, costs(5, 10)).by_rays);
}

TEST(RendererWhys, EachHasItsOwnText) {
    std::set<std::string> texts;
    for (std::size_t n = 0; n < static_cast<std::size_t>(RendererWhy::count_); ++n)
        texts.insert(std::string(to_string(static_cast<RendererWhy>(n))));
    EXPECT_EQ(texts.size(), static_cast<std::size_t>(RendererWhy::count_));
    EXPECT_EQ(texts.count(""), 0u);
}

}  // namespace
}  // namespace tedavis::effects::test_renderer_choice
