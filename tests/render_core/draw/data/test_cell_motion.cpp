#include "render_core/draw/data/cell_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/placement.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_cell_motion {
namespace {

using test_support::ElementOfTest;
using test_support::scene_point;
using test_support::SolidRoomOfTest;

constexpr double kBase_m = 3000, kWidth_m = 5000;
const double kLatitude = base::radians(46.8), kLongitude = base::radians(9.8);

host_sim::LayerDraft cell(float speed_mps, float toward_deg) {
    host_sim::LayerDraft layer;
    layer.name = "storm";
    layer.shape = scene::LayerShape::areas;
    layer.role = scene::LayerRole::storm_cell;
    layer.points = {scene_point(46.8, 9.8, 0), scene_point(46.8, 9.81, 0), scene_point(46.81, 9.8, 0)};
    layer.starts = {0, 3};
    const auto bind = [&](const char* name, float value) {
        host_sim::AttributeDraft attribute;
        attribute.name = name;
        attribute.of = scene::AttributeOf::feature;
        attribute.values = {value};
        layer.attributes.push_back(attribute);
    };
    bind("speed", speed_mps);
    bind("toward", static_cast<float>(base::radians(static_cast<double>(toward_deg))));
    return layer;
}

CellFront front(double toward_deg, double seen_rad = base::kPi) {
    return {kLatitude, kLongitude, kBase_m, base::radians(toward_deg), kWidth_m, seen_rad, true};
}

/// The line of a cell, with the vertices of one of its pieces.
struct Line {
    Line(float speed_mps, float toward_deg, const CellFront& from, double ground_m = 600, const glm::dvec3& from_eye = {})
        : test(cell(speed_mps, toward_deg)) {
        test.ground.height = ground_m;
        ElementInput input = test.input();
        input.eye = begin + from_eye;
        length_m = motion_line_m(input, from, static_cast<double>(speed_mps));
        add_motion_line(room.batch, room.mesh, input, 0, from);
    }
    /// Relative to the front.
    [[nodiscard]] std::vector<glm::dvec3> vertices(std::size_t piece = 0) const {
        const SolidPiece& at = room.batch.pieces()[piece];
        std::vector<glm::dvec3> places;
        for (std::uint32_t n = 0; n < at.vertices; ++n)
            places.push_back(at.anchor + glm::dvec3(room.batch.vertices()[at.first_vertex + n].place_m) - begin);
        return places;
    }
    /// The farthest vertex in a direction, m.
    [[nodiscard]] double reach_m(const glm::dvec3& way) const {
        double farthest_m = 0;
        for (const glm::dvec3& at : vertices()) farthest_m = std::max(farthest_m, glm::dot(at, way));
        return farthest_m;
    }

    ElementOfTest test;
    SolidRoomOfTest room;
    glm::dvec3 begin = earth::to_ecef({kLatitude, kLongitude, {kBase_m}});
    double length_m = 0;
};

const LocalAxes kAxes = local_axes(kLatitude, kLongitude);

TEST(CellMotion, IsAThinLineToWhereTheFrontWillBeInHalfAnHour) {
    for (const double toward_deg : {0.0, 60.0, 200.0})
        for (const float speed : {3.0f, 8.0f}) {
            const Line line(speed, static_cast<float>(toward_deg), front(toward_deg));
            ASSERT_EQ(line.room.batch.pieces().size(), 2u) << "itself and its rim";
            // By where the tip is north and east of the front, not by the sine and cosine that the line is made with.
            glm::dvec3 tip(0);
            for (const glm::dvec3& at : line.vertices())
                if (glm::length(at) > glm::length(tip)) tip = at;
            EXPECT_NEAR(glm::length(tip), static_cast<double>(speed) * kMotionAhead_s, 0.002 * glm::length(tip));
            const double bearing = std::atan2(glm::dot(tip, kAxes.east), glm::dot(tip, kAxes.north));
            EXPECT_NEAR(std::remainder(bearing - base::radians(toward_deg), 2 * base::kPi), 0, 2e-3);
        }
}

/// A thread, and rims of which the screen's pixels give the width. Control: the arrow that was here before was 0.12 of its
/// length.
TEST(CellMotion, HasItsWidthOnTheScreenAndNoneInSpace) {
    const Line line(8, 0, front(0));
    const base::Span<const SolidPiece> pieces = line.room.batch.pieces();
    EXPECT_FLOAT_EQ(pieces[0].look.halo_px, 0.5f * kMotionLine_px);
    EXPECT_GT(pieces[1].look.halo_px, pieces[0].look.halo_px);
    for (const SolidPiece& piece : pieces) EXPECT_FALSE(piece.look.is_mixed || piece.look.is_thing);
    const double across_m = line.reach_m(kAxes.east);
    EXPECT_NEAR(across_m, kBarbShare * kWidth_m, 5) << "the barbs";
    double thread_m = 0;
    for (const glm::dvec3& at : line.vertices())
        if (glm::dot(at, kAxes.north) < 300 * 8 - kBarbShare * kWidth_m - 5)
            thread_m = std::max(thread_m, std::fabs(glm::dot(at, kAxes.east)));
    EXPECT_LT(thread_m, 1) << "before the first barb";
}

/// Their number by the surface's ends at both sides; a slower cell has as many, nearer to each other.
TEST(CellMotion, HasABarbForEveryFiveMinutesOfTheWay) {
    for (const float speed : {4.0f, 8.0f}) {
        const Line line(speed, 0, front(0));
        std::vector<double> ends;
        for (const glm::dvec3& at : line.vertices()) {
            const double ahead_m = glm::dot(at, kAxes.north);
            if (glm::dot(at, kAxes.east) < kBarbShare * kWidth_m - 2) continue;
            if (ends.empty() || std::fabs(ahead_m - ends.back()) > 50) ends.push_back(ahead_m);
        }
        ASSERT_EQ(ends.size(), 6u) << speed;
        for (std::size_t n = 0; n < ends.size(); ++n)
            EXPECT_NEAR(ends[n], 300.0 * (n + 1) * static_cast<double>(speed) - kBarbShare * kWidth_m, 25) << "open to the back";
    }
}

/// Angles by the places of the vertices. Control: without the limit it is seen at a larger angle than the cell.
TEST(CellMotion, IsSeenNoLongerThanTheCellIsWide) {
    const double seen = 0.12;
    for (const double away_deg : {10.0, 60.0, 120.0}) {
        const glm::dvec3 from_eye =
            40'000.0 * (kAxes.north * std::cos(base::radians(away_deg)) + kAxes.east * std::sin(base::radians(away_deg)));
        const auto angle = [&](double limit) {
            const Line line(60, 0, front(0, limit), 600, from_eye);
            double largest = 0;
            for (const glm::dvec3& at : line.vertices())
                if (std::fabs(glm::dot(at, kAxes.east)) < 2)
                    largest = std::max(largest, std::acos(glm::dot(glm::normalize(at - from_eye), glm::normalize(-from_eye))));
            return largest;
        };
        EXPECT_LT(angle(seen), seen * 1.01) << away_deg;
        EXPECT_GT(angle(seen), seen * 0.9) << "it uses what it may";
        EXPECT_GT(angle(base::kPi), seen * 1.5) << "control";
    }
}

/// Control: where the line is shorter by its limit, the farthest barb is another.
TEST(CellMotion, KnowsItsFarthestBarb) {
    const auto barb = [](float speed, double seen_rad) {
        ElementOfTest test(cell(speed, 0));
        ElementInput input = test.input();
        const glm::dvec3 begin = earth::to_ecef({kLatitude, kLongitude, {kBase_m}});
        input.eye = begin + 40'000.0 * kAxes.east;
        LastBarb last = last_barb(input, 0, front(0, seen_rad));
        last.place -= begin;
        return last;
    };
    for (const float speed : {4.0f, 8.0f}) {
        const LastBarb whole = barb(speed, base::kPi);
        EXPECT_EQ(whole.after_s, 1800) << speed;
        EXPECT_NEAR(glm::dot(whole.place, kAxes.north), 1800 * static_cast<double>(speed), 25);
    }
    // Seen from the side at 40 km, 0.13 rad are some 5.2 km, and a barb stands for 2.4 km.
    EXPECT_EQ(barb(8, 0.13).after_s, 600) << "control";
    EXPECT_EQ(barb(60, 0.12).after_s, 0) << "before the first barb";
    ElementOfTest test(cell(8, 0));
    EXPECT_EQ(last_barb(test.input(), 0, CellFront{}).after_s, 0);
}

TEST(CellMotion, LiesAtTheBaseButNotInTheGround) {
    const auto lowest_m = [](const Line& line) {
        double least_m = 1e9;
        for (const glm::dvec3& at : line.vertices()) least_m = std::min(least_m, earth::from_ecef(line.begin + at).height.m);
        return least_m;
    };
    EXPECT_NEAR(lowest_m(Line(8, 0, front(0))), kBase_m, 5);
    EXPECT_NEAR(lowest_m(Line(8, 0, front(0), 4000)), 4000 + kMotionOverGround_m, 5);
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NEAR(lowest_m(Line(8, 0, front(0), unknown)), kBase_m, 5);
}

TEST(CellMotion, WhatStandsOrIsUnknownHasNone) {
    const auto moves = [](float speed, float toward) {
        ElementOfTest test(cell(speed, toward));
        return has_motion(test.input(), 0);
    };
    const float unknown = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(moves(10, 0));
    EXPECT_FALSE(moves(0.1f, 0));
    EXPECT_FALSE(moves(unknown, 0));
    EXPECT_FALSE(moves(10, unknown));
    EXPECT_EQ(Line(10, 0, CellFront{}).room.batch.pieces().size(), 0u) << "nobody knows where its front is";
}

}  // namespace
}  // namespace tedavis::draw::test_cell_motion
