#include "render_core/draw/symbology/tape_marks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "tests/support/draw/batch_shapes.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_tape_marks {
namespace {

using policy::ElementShow;
using test_support::BatchStore;
using test_support::bounds_of;
using test_support::shapes_in;
using test_support::text_in;

constexpr design::Color kGreen{0, 200, 0};
constexpr design::Color kYellow{255, 255, 0};

const Layout& layout() {
    static const Layout made = make_layout(640, 480, 96);
    return made;
}

/// 100 units over 400 pixels, ticks at the right; room for flags beyond the edge.
TapeScale scale(float inwards = -1) {
    TapeScale made;
    made.box = {50, 40, 100, 400};
    made.edge = inwards < 0 ? 150 - kFlagWidth * layout().text_px : 50 + kFlagWidth * layout().text_px;
    made.inwards = inwards;
    made.middle = 120;
    made.px_per_unit = 4;
    return made;
}

template <class Build>
BatchStore drawn(const Build& build) {
    BatchStore store;
    store.batch.set_clip(scale().box);
    build(Painter(store.batch, layout()));
    EXPECT_EQ(store.batch.use().refused, 0u);
    for (const QuadVertex& vertex : store.batch.vertices()) {
        EXPECT_TRUE(std::isfinite(vertex.x) && std::isfinite(vertex.y));
        EXPECT_TRUE(scale().box.shrunk(-2.5f).contains(Point{vertex.x, vertex.y})) << vertex.x << ", " << vertex.y;
    }
    return store;
}

TEST(TapeMarks, UnitsGrowUpwards) {
    EXPECT_FLOAT_EQ(scale().y_of(120), 240);
    EXPECT_FLOAT_EQ(scale().y_of(130), 200);
    EXPECT_TRUE(std::isfinite(scale().y_of(1e300)));
    EXPECT_TRUE(std::isfinite(scale().y_of(std::nan(""))));
}

TEST(TapeMarks, BandsLieBetweenTheirValuesAlongTheEdge) {
    for (const float inwards : {-1.0f, 1.0f}) {
        const TapeBand bands[] = {{100, 130, kGreen, TapeBandLook::whole}, {100, 110, kYellow, TapeBandLook::half}};
        const BatchStore store = drawn([&](const Painter& painter) { build_tape_bands(painter, scale(inwards), bands); });
        const Rect green = bounds_of(shapes_in(store.batch, scale().box, kGreen));
        const Rect yellow = bounds_of(shapes_in(store.batch, scale().box, kYellow));
        EXPECT_NEAR(green.y, scale().y_of(130), 0.01);
        EXPECT_NEAR(green.bottom(), scale().y_of(100), 0.01);
        // A rim of two strokes parts it from the line along the edge.
        const float rim = 2 * layout().stroke_px;
        EXPECT_NEAR(inwards < 0 ? green.right() + rim : green.x - rim, scale(inwards).edge, 0.01);
        EXPECT_NEAR(yellow.width, green.width / 2, 0.01);
    }
}

TEST(TapeMarks, BandsAreCutAtTheScaleAndOrderedOnesAlone) {
    const double infinite = std::numeric_limits<double>::infinity();
    const TapeBand bands[] = {{-1e9, 1e9, kGreen, TapeBandLook::whole},
                              {130, 110, kYellow, TapeBandLook::whole},
                              {std::nan(""), 130, kYellow, TapeBandLook::whole}};
    const BatchStore store = drawn([&](const Painter& painter) { build_tape_bands(painter, scale(), bands); });
    const Rect green = bounds_of(shapes_in(store.batch, scale().box, kGreen));
    const float rim = 2 * layout().stroke_px;  // it is seen at the ends, too
    EXPECT_NEAR(green.y, scale().box.y + rim, 0.01);
    EXPECT_NEAR(green.bottom(), scale().box.bottom() - rim, 0.01);
    EXPECT_TRUE(shapes_in(store.batch, scale().box, kYellow).empty());
    const TapeBand open[] = {{140, infinite, kYellow, TapeBandLook::whole}};
    const BatchStore above = drawn([&](const Painter& painter) { build_tape_bands(painter, scale(), open); });
    EXPECT_NEAR(bounds_of(shapes_in(above.batch, scale().box, kYellow)).bottom(), scale().y_of(140), 0.01);
}

TEST(TapeMarks, APoleHasWhiteStripesThatMoveWithTheScale) {
    const auto stripes = [](double middle) {
        TapeScale moved = scale();
        moved.middle = middle;
        const TapeBand bands[] = {{110, 1e9, test_support::day_color(SymbolRole::warning), TapeBandLook::pole}};
        const BatchStore store = drawn([&](const Painter& painter) { build_tape_bands(painter, moved, bands); });
        EXPECT_FALSE(shapes_in(store.batch, scale().box, test_support::day_color(SymbolRole::warning)).empty());
        return shapes_in(store.batch, scale().box, test_support::day_color(SymbolRole::scale));
    };
    const auto at_120 = stripes(120), at_121 = stripes(121);
    ASSERT_GT(at_120.size(), 10u);
    EXPECT_LT(bounds_of(at_120).bottom(), scale().y_of(110));
    EXPECT_NEAR(at_121[0].bounds.y - at_120[0].bounds.y, 4, 0.01) << "a knot is four pixels";
    EXPECT_GT(stripes(5000).size(), 10u) << "far above its lower end";
}

TEST(TapeMarks, FlagsStandAtTheirValuesAndNeverOnEachOther) {
    const TapeFlag flags[] = {{110, "R", test_support::day_color(SymbolRole::scale)},
                              {111, "X", test_support::day_color(SymbolRole::scale)},
                              {140, "FE", kGreen},
                              {500, "NE", test_support::day_color(SymbolRole::warning)}};
    const BatchStore store = drawn([&](const Painter& painter) { build_tape_flags(painter, scale(), flags); });
    const Rect beyond{scale().edge, 40, 26, 400};
    EXPECT_EQ(text_in(store.batch, beyond, test_support::day_color(SymbolRole::scale)), "R") << "X would cover it";
    EXPECT_EQ(text_in(store.batch, beyond, kGreen), "FE");
    EXPECT_EQ(text_in(store.batch, scale().box, test_support::day_color(SymbolRole::warning)), "") << "off the scale";
    const Rect green = bounds_of(shapes_in(store.batch, scale().box, kGreen));
    EXPECT_NEAR(green.center().y, scale().y_of(140), 0.01);
    const TapeFlag wide[] = {{120, "WW", test_support::day_color(SymbolRole::scale)}};
    const BatchStore wide_store = drawn([&](const Painter& painter) { build_tape_flags(painter, scale(), wide); });
    EXPECT_EQ(text_in(wide_store.batch, scale().box, test_support::day_color(SymbolRole::scale)), "WW")
        << "the widest letters have room";
}

Rect bug_bounds(double at, ElementShow show, design::Color color) {
    const BatchStore store = drawn([&](const Painter& painter) { build_tape_bug(painter, scale(), {show, at}); });
    return bounds_of(shapes_in(store.batch, scale().box, color));
}

TEST(TapeMarks, ABugStandsAtItsValueAndStaysAtTheEndWithOneHalf) {
    const float whole = 2 * kBugReach * layout().text_px;
    const Rect on_scale = bug_bounds(130, ElementShow::normal, test_support::day_color(SymbolRole::selected));
    EXPECT_NEAR(on_scale.center().y, scale().y_of(130), 0.01);
    EXPECT_NEAR(on_scale.height, whole, 0.01);
    EXPECT_NEAR(on_scale.right(), scale().edge, 0.01);
    for (const double far : {200.0, 1e300}) {
        const Rect above = bug_bounds(far, ElementShow::normal, test_support::day_color(SymbolRole::selected));
        EXPECT_NEAR(above.y, scale().box.y, 0.01);
        EXPECT_NEAR(above.height, whole / 2, 0.01);
    }
    EXPECT_NEAR(bug_bounds(-50, ElementShow::normal, test_support::day_color(SymbolRole::selected)).bottom(),
                scale().box.bottom(), 0.01);
    EXPECT_TRUE(bug_bounds(std::nan(""), ElementShow::normal, test_support::day_color(SymbolRole::selected)).empty());
    // Partly beyond the end: what is on the scale is seen.
    const Rect near_end = bug_bounds(168.5, ElementShow::normal, test_support::day_color(SymbolRole::selected));
    EXPECT_NEAR(near_end.y, scale().box.y, 0.01);
    EXPECT_NEAR(near_end.bottom(), scale().y_of(168.5) + whole / 2, 0.01);
}

TEST(TapeMarks, AFlaggedBugIsHollowAndAmberAndAFailedOneIsNotThere) {
    EXPECT_TRUE(bug_bounds(130, ElementShow::flagged, test_support::day_color(SymbolRole::selected)).empty());
    EXPECT_FALSE(bug_bounds(130, ElementShow::flagged, test_support::day_color(SymbolRole::caution)).empty());
    for (const ElementShow show : {ElementShow::failed, ElementShow::absent}) {
        const BatchStore store = drawn([&](const Painter& painter) { build_tape_bug(painter, scale(), {show, 130}); });
        EXPECT_EQ(store.batch.vertices().size(), 0u);
    }
}

TEST(TapeMarks, ATrendLeadsFromTheValueToWhereItWillBe) {
    const auto bounds = [](const TapeTrend& trend) {
        const BatchStore store = drawn([&](const Painter& painter) { build_tape_trend(painter, scale(), trend); });
        return bounds_of(shapes_in(store.batch, scale().box, test_support::day_color(SymbolRole::scale)));
    };
    const float half_line = 0.75f * layout().stroke_px;
    const Rect up = bounds({true, 135, 1});
    EXPECT_NEAR(up.y, scale().y_of(135) - half_line, 0.6);
    EXPECT_NEAR(up.bottom(), scale().y_of(120), 0.6);
    EXPECT_NEAR(up.center().x, scale().edge - kTrendInset * layout().text_px, 0.01);
    EXPECT_NEAR(bounds({true, 100, 1}).bottom(), scale().y_of(100) + half_line, 0.6);
    EXPECT_TRUE(bounds({true, 120.9, 1}).empty());
    EXPECT_FALSE(bounds({true, 121.1, 1}).empty()) << "control";
    EXPECT_TRUE(bounds({false, 135, 1}).empty());
    EXPECT_TRUE(bounds({true, std::nan(""), 1}).empty());
    EXPECT_LE(bounds({true, 1e300, 1}).height, 201) << "cut at the scale's end";
}

TEST(TapeMarks, AMinimumPointsAtItsValueInTheColorOfItsState) {
    for (const design::Color color : {test_support::day_color(SymbolRole::selected), test_support::day_color(SymbolRole::scale),
                                      test_support::day_color(SymbolRole::caution)}) {
        const auto bounds = [&](double at) {
            const BatchStore store = drawn([&](const Painter& painter) {
                build_tape_minimum(painter, scale(), {ElementShow::normal, at, color});
            });
            return bounds_of(shapes_in(store.batch, scale().box, color));
        };
        EXPECT_NEAR(bounds(110).center().y, scale().y_of(110), 0.01);
        EXPECT_TRUE(bounds(300).empty()) << "off the scale";
    }
    const BatchStore stale = drawn([&](const Painter& painter) {
        build_tape_minimum(painter, scale(), {ElementShow::flagged, 110, test_support::day_color(SymbolRole::selected)});
    });
    EXPECT_TRUE(shapes_in(stale.batch, scale().box, test_support::day_color(SymbolRole::selected)).empty());
    EXPECT_FALSE(shapes_in(stale.batch, scale().box, test_support::day_color(SymbolRole::caution)).empty());
}

TEST(TapeMarks, ARowSaysItsTextByItsState) {
    const Rect box{60, 60, 90, 22};
    const auto row = [&](ElementShow show) {
        return drawn([&](const Painter& painter) {
            build_tape_row(painter, box, {show, "12500", "ALT SEL", test_support::day_color(SymbolRole::selected)});
        });
    };
    EXPECT_EQ(text_in(row(ElementShow::normal).batch, box, test_support::day_color(SymbolRole::selected)), "12500");
    EXPECT_EQ(text_in(row(ElementShow::flagged).batch, box, test_support::day_color(SymbolRole::caution)), "12500");
    EXPECT_EQ(text_in(row(ElementShow::flagged).batch, box, test_support::day_color(SymbolRole::selected)), "");
    const BatchStore failed = row(ElementShow::failed);
    EXPECT_EQ(text_in(failed.batch, box, test_support::day_color(SymbolRole::caution)), "ALTSEL") << "lost, and no danger";
    EXPECT_EQ(shapes_in(failed.batch, box, test_support::day_color(SymbolRole::warning)).size(), 2u) << "a cross";
    EXPECT_EQ(row(ElementShow::absent).batch.vertices().size(), 0u);
}

}  // namespace
}  // namespace tedavis::draw::test_tape_marks
