#include "render_core/draw/data/runway_marks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::draw::test_runway_marks {
namespace {

using base::radians;

int count(const RunwayMarks& marks, RunwayMarkKind kind) {
    return static_cast<int>(std::count_if(marks.begin(), marks.end(), [&](const RunwayMark& mark) { return mark.kind == kind; }));
}

TEST(RunwayMarks, P29TheNumberIsThatOfTheNameAtTheEndThatHasItsDirection) {
    const RunwayNumbers north = runway_numbers("LOWI 08L/26R", radians(78));
    EXPECT_EQ(north[0].tens_deg, 8);
    EXPECT_EQ(north[0].side, 'L');
    EXPECT_EQ(north[1].tens_deg, 26);
    EXPECT_EQ(north[1].side, 'R');
    const RunwayNumbers turned = runway_numbers("LOWI 08L/26R", radians(258));
    EXPECT_EQ(turned[0].tens_deg, 26) << "the points are in the other order";
    EXPECT_EQ(turned[1].tens_deg, 8);
}

TEST(RunwayMarks, P29WithoutAUsableNameTheTrueDirectionIsTheNumber) {
    for (const char* const name : {"", "STRIP", "N/S", "00/18", "37/19", "08X/26Y"}) {
        EXPECT_EQ(runway_numbers(name, radians(62))[0].tens_deg, 6) << name;
        EXPECT_EQ(runway_numbers(name, radians(62))[1].tens_deg, 24) << name;
    }
    EXPECT_EQ(runway_numbers("", radians(2))[0].tens_deg, 36) << "north is no 0";
    EXPECT_EQ(runway_numbers("", radians(-2))[0].tens_deg, 36);
    EXPECT_EQ(runway_numbers("", radians(2))[1].tens_deg, 18);
    EXPECT_EQ(runway_numbers("", radians(-95))[0].tens_deg, 27);
}

/// Table of Annex 14, 5.2.4.5.
TEST(RunwayMarks, P29ThresholdsHaveTheStripesOfTheirWidth) {
    const std::pair<double, int> kStripes[] = {{18, 4}, {23, 6}, {30, 8}, {45, 12}, {60, 16}};
    for (const auto& [width_m, stripes] : kStripes)
        EXPECT_EQ(count(runway_marks(2000, width_m, {}), RunwayMarkKind::threshold), 2 * stripes) << width_m;
}

TEST(RunwayMarks, P29AimingPointsAreWhereTheLengthPutsThem) {
    EXPECT_EQ(aiming_point_m(300), 0);
    EXPECT_EQ(aiming_point_m(700), 150);
    EXPECT_EQ(aiming_point_m(1199), 250);
    EXPECT_EQ(aiming_point_m(2000), 300);
    EXPECT_EQ(aiming_point_m(2400), 400);
    EXPECT_EQ(count(runway_marks(2000, 45, {}), RunwayMarkKind::aiming_point), 4);
    EXPECT_EQ(count(runway_marks(300, 30, {}), RunwayMarkKind::aiming_point), 0);
}

/// Whatever the size, marks lie on the runway, both ends alike; nothing lies twice at one place but strokes of a number.
TEST(RunwayMarks, LieOnTheRunwayAndNotOnEachOther) {
    for (const double length_m : {150.0, 300.0, 800.0, 1200.0, 4000.0, 8000.0})
        for (const double width_m : {15.0, 30.0, 45.0, 60.0}) {
            const RunwayMarks marks = runway_marks(length_m, width_m, {RunwayNumber{6, 0}, RunwayNumber{24, 'L'}});
            EXPECT_EQ(marks.refused(), 0u);
            double balance_m = 0;
            for (const RunwayMark& mark : marks) {
                EXPECT_GE(mark.from_m, 0);
                EXPECT_LE(mark.to_m, length_m);
                EXPECT_LT(mark.from_m, mark.to_m);
                EXPECT_LT(mark.left_m, mark.right_m);
                EXPECT_LE(std::max(-mark.left_m, mark.right_m), 0.5 * width_m);
                if (mark.kind != RunwayMarkKind::number) balance_m += mark.from_m + mark.to_m - length_m;
                for (const RunwayMark& other : marks) {
                    const bool overlap = mark.from_m < other.to_m && other.from_m < mark.to_m && mark.left_m < other.right_m &&
                                         other.left_m < mark.right_m;
                    EXPECT_FALSE(overlap && mark.kind != other.kind && length_m >= 800) << length_m << " x " << width_m;
                }
            }
            EXPECT_NEAR(balance_m, 0, 1e-6 * length_m);
        }
}

TEST(RunwayMarks, TheCentreLineHasStripesAndGapsOfItsPeriod) {
    RunwayMark before;
    int pairs = 0;
    for (const RunwayMark& mark : runway_marks(3000, 45, {})) {
        if (mark.kind != RunwayMarkKind::center_line) continue;
        EXPECT_NEAR(mark.to_m - mark.from_m, 30, 1e-9);
        if (before.to_m > 0) {
            const double period_m = mark.from_m - before.from_m;
            EXPECT_GE(period_m, 50 - 1e-9);
            EXPECT_LE(period_m, 75);
            ++pairs;
        }
        before = mark;
    }
    EXPECT_GT(pairs, 40);
}

}  // namespace
}  // namespace tedavis::draw::test_runway_marks
