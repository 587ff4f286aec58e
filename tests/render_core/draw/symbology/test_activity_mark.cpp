#include "render_core/draw/symbology/activity_mark.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "render_core/draw/symbology/annunciations.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "tests/support/draw/batch_shapes.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_activity_mark {
namespace {

using flight::Signal;
using test_support::BatchShape;
using test_support::BatchStore;

struct Screen {
    std::uint32_t width, height;
};
constexpr Screen kScreens[] = {{320, 240}, {480, 800}, {640, 480}, {800, 480}, {1280, 720}, {3840, 2160}};

constexpr Rect kStrip{0, 0, 640, 30};

base::Time at_ms(std::int64_t ms) { return {ms * 1'000'000}; }

/// Bytes that would be drawn.
std::vector<QuadVertex> mark_at(base::Time position_time, const Layout& layout) {
    SymbologyInput input = test_support::scene_input(test_support::scene_state(3, 0, 0), 640, 480);
    input.position_time = position_time;
    BatchStore store;
    build_activity_mark(Painter(store.batch, layout), input);
    return {store.batch.vertices().begin(), store.batch.vertices().end()};
}

bool are_equal(const std::vector<QuadVertex>& a, const std::vector<QuadVertex>& b) {
    bool equal = a.size() == b.size();
    for (std::size_t n = 0; equal && n < a.size(); ++n) equal = a[n].x == b[n].x && a[n].y == b[n].y;
    return equal;
}

/// Of the hand alone: the ring comes first.
double moved_px(base::Time before, base::Time now, const Layout& layout) {
    const std::vector<QuadVertex> a = mark_at(before, layout), b = mark_at(now, layout);
    double most = 0;
    for (std::size_t n = 0; n < a.size() && n < b.size(); ++n)
        most = std::max<double>(most, std::hypot(a[n].x - b[n].x, a[n].y - b[n].y));
    return most;
}

TEST(ActivityMark, WithinASecondTheHandMovesByPixelsAlsoOnSmallScreens) {
    for (const Screen& screen : kScreens)
        for (const std::int64_t begin_ms : {0, 1234, 3500, 6900}) {
            const Layout layout = make_layout(screen.width, screen.height, 96);
            EXPECT_GT(moved_px(at_ms(begin_ms), at_ms(begin_ms + 1000), layout), 2) << screen.width << " x " << screen.height;
        }
}

TEST(ActivityMark, StandsStillWhereTimePassesWithoutAPosition) {
    flight::AircraftState state = test_support::scene_state(3, 0, 0);
    const auto drawn = [&] {
        BatchStore store;
        const Layout layout = make_layout(640, 480, 96);
        build_activity_mark(Painter(store.batch, layout), test_support::scene_input(state, 640, 480));
        return std::vector<QuadVertex>(store.batch.vertices().begin(), store.batch.vertices().end());
    };
    const std::vector<QuadVertex> before = drawn();
    for (const Signal other : {Signal::pitch, Signal::roll, Signal::true_track, Signal::ellipsoid_height})
        state[other] =
            base::Stamped<double>(state[other].value_or(0), test_support::kSceneNow + base::Duration::milliseconds(400));
    EXPECT_TRUE(are_equal(before, drawn())) << "other signals are no position";
    for (const Signal half : {Signal::latitude, Signal::longitude})
        state[half] = base::Stamped<double>(state[half].value_or(0), test_support::kSceneNow + base::Duration::milliseconds(400));
    EXPECT_FALSE(are_equal(before, drawn()));
}

TEST(ActivityMark, TheHandMovesWithEachPosition) {
    const Layout layout = make_layout(320, 240, 96);
    for (const std::int64_t period_ms : {10, 12, 50, 100, 200, 250, 333, 500, 1000, 2000, 3000, 5000}) {
        for (std::int64_t n = 0; n < 100; ++n) {
            const base::Time before = at_ms(1'700'000'000'000 + n * period_ms),
                             now = before + base::Duration{period_ms * 1'000'000};
            ASSERT_FALSE(are_equal(mark_at(before, layout), mark_at(now, layout))) << period_ms << " ms, position " << n;
        }
    }
}

/// The middle of what is drawn last, the hand, seen from the middle of the ring.
TEST(ActivityMark, TheHandGoesRoundOnceInSevenSecondsClockwise) {
    const Layout layout = make_layout(1280, 720, 96);
    const Point center = activity_mark_box(layout.annunciations, layout.text_px).center();
    for (const std::int64_t eighth : {0, 1, 2, 3, 4, 5, 6, 7}) {
        const double turn_rad = 2 * 3.14159265358979323846 * static_cast<double>(eighth) / 8;
        for (const std::int64_t rounds : {-3, 0, 242'857'142}) {
            const base::Time time = at_ms(7000 * rounds + 875 * eighth);
            EXPECT_NEAR(activity_angle_rad(time), turn_rad, 1e-9) << eighth << " " << rounds;
            const std::vector<QuadVertex> drawn = mark_at(time, layout);
            ASSERT_GT(drawn.size(), 4u);
            double x = 0, y = 0;
            for (std::size_t n = drawn.size() - 4; n < drawn.size(); ++n) x += drawn[n].x - center.x, y += drawn[n].y - center.y;
            EXPECT_GT(x * std::sin(turn_rad) - y * std::cos(turn_rad), 0.95 * std::hypot(x, y));
        }
    }
}

TEST(ActivityMark, IsAtTheStripsRightEndWhereNoTextIs) {
    const policy::Notice notice{policy::NoticeLevel::caution, "PHASE SWITCH FAULT"};
    const std::vector<policy::Notice> many(12, notice);
    for (const Screen& screen : kScreens) {
        const Layout layout = make_layout(screen.width, screen.height, 96);
        const Rect &strip = layout.annunciations, mark = activity_mark_box(strip, layout.text_px),
                   texts = beside_activity_mark(strip, layout.text_px);
        EXPECT_GE(mark.y, strip.y);
        EXPECT_LE(mark.bottom(), strip.bottom());
        EXPECT_LT(mark.right(), strip.right());
        EXPECT_GE(mark.width, 10) << screen.width << " x " << screen.height;
        EXPECT_LE(texts.right(), mark.x);
        EXPECT_GE(texts.width, 15 * layout.text_px) << "what plan_annunciations() needs";
        const flight::PhaseStatus phase = flight::stated_phase(flight::kTakeoffSecondClimb, flight::PhaseSource::motion);
        for (const Annunciation& field : plan_annunciations(texts, layout.text_px, &phase, {many.data(), many.size()}).fields)
            EXPECT_FALSE(field.box.overlaps(mark)) << field.text.view();
    }
}

TEST(ActivityMark, StaysWithinItsBox) {
    for (const Screen& screen : kScreens) {
        const Layout layout = make_layout(screen.width, screen.height, 96);
        const Rect box = activity_mark_box(layout.annunciations, layout.text_px).shrunk(-2.5f);  // smoothed edges
        for (const QuadVertex& vertex : mark_at(at_ms(1234), layout)) {
            EXPECT_GE(vertex.x, box.x);
            EXPECT_LE(vertex.x, box.right());
            EXPECT_GE(vertex.y, box.y);
            EXPECT_LE(vertex.y, box.bottom());
        }
    }
}

/// A posed picture is of no flight.
TEST(ActivityMark, IsThereFromTheFirstPositionOfAFlightOn) {
    flight::AircraftState state = test_support::scene_state(3, 0, 0);
    EXPECT_TRUE(shows_activity(test_support::scene_input(state, 640, 480), kStrip));
    state.is_posed = true;
    EXPECT_FALSE(shows_activity(test_support::scene_input(state, 640, 480), kStrip));
    state.is_posed = false;
    state[Signal::latitude] = {};
    EXPECT_FALSE(shows_activity(test_support::scene_input(state, 640, 480), kStrip));
}

TEST(ActivityMark, LeavesANarrowStripToItsWords) {
    const SymbologyInput input = test_support::scene_input(test_support::scene_state(3, 0, 0), 240, 320);
    const Layout layout = make_layout(240, 320, 96);
    EXPECT_FALSE(shows_activity(input, layout.annunciations));
    EXPECT_TRUE(mark_at(at_ms(5), layout).empty());
    EXPECT_FALSE(mark_at(at_ms(5), make_layout(320, 240, 96)).empty());
}

TEST(ActivityMark, IsOnlyThereWithThePhase) {
    SymbologyInput input = test_support::scene_input(test_support::scene_state(3, 0, 0), 640, 480);
    EXPECT_TRUE(shows_activity(input, kStrip));
    input.shown.phase = false;
    EXPECT_FALSE(shows_activity(input, kStrip));
    BatchStore store;
    build_activity_mark(Painter(store.batch, make_layout(640, 480, 96)), input);
    EXPECT_EQ(store.batch.vertices().size(), 0u);
}

/// A position is new where both halves are: a receiver that sends the longitude alone sends no position.
TEST(ActivityMark, FollowsTheOlderOfLatitudeAndLongitude) {
    flight::AircraftState state = test_support::scene_state(3, 0, 0);
    const base::Time early = test_support::kSceneNow - base::Duration::milliseconds(300);
    state[Signal::latitude] = base::Stamped<double>(0.6, early);
    EXPECT_EQ(test_support::scene_input(state, 640, 480).position_time, early);
    const base::Time earlier = early - base::Duration::milliseconds(20);
    state[Signal::longitude] = base::Stamped<double>(-1.4, earlier);
    EXPECT_EQ(test_support::scene_input(state, 640, 480).position_time, earlier);
}

}  // namespace
}  // namespace tedavis::draw::test_activity_mark
