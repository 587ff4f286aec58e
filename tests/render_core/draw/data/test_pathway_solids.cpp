#include "render_core/draw/data/pathway_solids.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "render_core/draw/data/pathway_frames.hpp"
#include "render_core/draw/data/placement.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_pathway_solids {
namespace {

using design::ElementUncertainty;
using test_support::ElementOfTest;
using test_support::scene_point;
using test_support::SolidRoomOfTest;

constexpr std::size_t kOutlineVertices = 20, kDashedVertices = 48;

/// To the north over flat ground at 600 m; a second line 20 km beside it.
host_sim::LayerDraft planned(float accuracy_m = 0, bool has_other = false) {
    host_sim::LayerDraft layer;
    layer.name = "flight";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::trajectory;
    layer.height_datum = scene::HeightDatum::ellipsoid;
    layer.position_accuracy_m = accuracy_m;
    layer.height_accuracy_m = accuracy_m / 2;
    layer.starts = {0};
    for (int line = 0; line <= (has_other ? 1 : 0); ++line) {
        for (int n = 0; n <= 100; ++n) layer.points.push_back(scene_point(46.5 + 0.002 * n, 9.6 + 0.26 * line, 2000));
        layer.starts.push_back(static_cast<std::uint32_t>(layer.points.size()));
    }
    return layer;
}

struct Built {
    SolidRoomOfTest room;
    ElementCount count;
    PathwayFrames frames;
    explicit Built(std::size_t vertices = 65536) : room(vertices) {}

    [[nodiscard]] const SolidPiece& piece_of(const PathwayFrame& frame) const {
        for (const SolidPiece& piece : room.batch.pieces())
            if (piece.anchor == frame.middle) return piece;
        ADD_FAILURE() << "the frame has no piece";
        return room.batch.pieces()[0];
    }
    [[nodiscard]] glm::dvec3 place(const SolidPiece& piece, std::uint32_t n) const {
        return piece.anchor + glm::dvec3(room.batch.vertices()[piece.first_vertex + n].place_m);
    }
    /// Farthest to the side, and up, of some vertices.
    [[nodiscard]] glm::dvec2 reach_m(const PathwayFrame& frame, std::uint32_t first, std::uint32_t end) const {
        glm::dvec2 most_m(0);
        const SolidPiece& piece = piece_of(frame);
        for (std::uint32_t n = first; n < std::min(end, piece.vertices); ++n) {
            const glm::dvec3 off = place(piece, n) - frame.middle;
            most_m = glm::max(most_m, glm::dvec2(glm::dot(off, frame.right), glm::dot(off, frame.up)));
        }
        return most_m;
    }
};

Built built(ElementOfTest& test, bool is_valid = true, std::size_t vertices = 65536) {
    test.element.technique = design::DataTechnique::pathway;
    Built made(vertices);
    ElementInput input = test.input();
    input.own_ship = {{base::radians(46.55), base::radians(9.6), {0}}, is_valid};
    input.eye = earth::to_ecef({base::radians(46.55), base::radians(9.6), {2010}});
    made.count = add_pathway(made.room.batch, made.room.mesh, input);
    made.frames = pathway_frames(input, planned_pathway(input));
    return made;
}

TEST(PathwaySolids, P27FramesAreOutlinesOf700By200Feet) {
    ElementOfTest test(planned());
    const Built made = built(test);
    ASSERT_GE(made.frames.size(), 5u);
    EXPECT_EQ(made.count.drawn, 1u);
    for (const PathwayFrame& frame : made.frames) {
        EXPECT_EQ(made.piece_of(frame).vertices, kOutlineVertices);
        const glm::dvec2 reach_m = made.reach_m(frame, 0, kOutlineVertices);
        EXPECT_NEAR(2 * reach_m.x, 700 * 0.3048, 1);
        EXPECT_NEAR(2 * reach_m.y, 200 * 0.3048, 1);
        double area_m2 = 0;  // of its triangles as they are given: lines get their width by their normals
        const SolidPiece& piece = made.piece_of(frame);
        for (std::uint32_t n = 0; n < piece.indices; n += 3) {
            const auto at = [&](std::uint32_t k) { return made.place(piece, made.room.batch.indices()[piece.first_index + k]); };
            area_m2 += glm::length(glm::cross(at(n + 1) - at(n), at(n + 2) - at(n))) / 2;
        }
        EXPECT_LT(area_m2, 1) << "nothing is filled";
        EXPECT_FALSE(piece.look.is_thing);
        EXPECT_TRUE(piece.look.is_mixed);
    }
}

/// A normal too short to be shaded moves a vertex by half the line's width, and triangles then face the eye.
TEST(PathwaySolids, LinesAreAsWideOnTheScreenAsTheyAreToBeAndFaceTheEye) {
    ElementOfTest test(planned());
    const Built made = built(test);
    const glm::dvec3 eye = earth::to_ecef({base::radians(46.55), base::radians(9.6), {2010}});
    for (const SolidPiece& piece : made.room.batch.pieces()) {
        const bool is_frame = std::any_of(made.frames.begin(), made.frames.end(),
                                          [&](const PathwayFrame& frame) { return frame.middle == piece.anchor; });
        const auto moved = [&](std::uint32_t n) {
            const SolidVertex& vertex = made.room.batch.vertices()[piece.first_vertex + n];
            const glm::dvec3 normal = (glm::dvec3(vertex.normal[0], vertex.normal[1], vertex.normal[2]) - 127.0) / 127.0;
            EXPECT_LT(glm::length(normal), 0.5);
            const glm::dvec3 from_eye = made.place(piece, n) - eye;
            return from_eye +
                   normal * (static_cast<double>(piece.look.raised_px) / 1000) * glm::length(from_eye);  // focal 1000 px
        };
        if (!is_frame) continue;  // lines are seen from their ends, where both sides are drawn
        for (std::uint32_t n = 0; n < piece.indices; n += 3) {
            const auto at = [&](std::uint32_t k) { return moved(made.room.batch.indices()[piece.first_index + k]); };
            const glm::dvec3 facing = glm::cross(at(n + 1) - at(n), at(n + 2) - at(n));
            EXPECT_LT(glm::dot(facing, at(n)), 0);
        }
        const double wide_m = glm::distance(moved(0), moved(3)), away_m = glm::length(moved(0));
        EXPECT_NEAR(1000 * wide_m / away_m, kFrameLine_px, 0.2);
    }
}

/// Metamorphic: twice the accuracy, twice the margin.
TEST(PathwaySolids, P27FramesAreWidenedByTheAccuracy) {
    for (const float accuracy_m : {40.0f, 80.0f}) {
        ElementOfTest test(planned(accuracy_m));
        test.element.uncertainty = ElementUncertainty::widening;
        const Built made = built(test);
        const PathwayFrame& frame = made.frames[2];
        ASSERT_EQ(made.piece_of(frame).vertices, kOutlineVertices + kDashedVertices);
        const glm::dvec2 inner = made.reach_m(frame, 0, kOutlineVertices),
                         outer = made.reach_m(frame, kOutlineVertices, kOutlineVertices + kDashedVertices);
        EXPECT_NEAR(outer.x - inner.x, accuracy_m, 0.1);
        EXPECT_NEAR(outer.y - inner.y, accuracy_m / 2, 0.1);
    }
}

/// The weaker uncertainty is to be shown, the fewer frames have an accuracy, and the nearest keeps it longest.
TEST(PathwaySolids, TheStrengthIsTheShareOfFramesWithAnAccuracy) {
    for (const auto& [strength, expected] : {std::pair<double, std::size_t>{0, 0}, {0.01, 1}, {0.4, 2}, {0.41, 3}, {1, 5}}) {
        ElementOfTest test(planned(40));
        test.element.uncertainty = ElementUncertainty::widening;
        test.element.uncertainty_strength = strength;
        const Built made = built(test);
        ASSERT_EQ(made.frames.size(), 5u);
        for (std::size_t n = 0; n < made.frames.size(); ++n)
            EXPECT_EQ(made.piece_of(made.frames[n]).vertices, kOutlineVertices + (n < expected ? kDashedVertices : 0u)) << n;
    }
}

/// Control: with another technique, and where nobody states an accuracy, there is one frame.
TEST(PathwaySolids, OnlyStatedAccuracyWidens) {
    ElementOfTest unknown(planned(0)), faded(planned(40));
    unknown.element.uncertainty = ElementUncertainty::widening;
    faded.element.uncertainty = ElementUncertainty::saturation;
    for (ElementOfTest* const test : {&unknown, &faded}) {
        const Built made = built(*test);
        EXPECT_EQ(made.piece_of(made.frames[0]).vertices, kOutlineVertices);
    }
}

TEST(PathwaySolids, WithoutAValidPlaceThereIsTheLineAlone) {
    ElementOfTest test(planned());
    const Built made = built(test, false);
    EXPECT_EQ(made.count.drawn, 1u);
    EXPECT_EQ(made.frames.size(), 0u);
    double south_deg = 90, north_deg = 0;
    for (const SolidPiece& piece : made.room.batch.pieces())
        for (std::uint32_t n = 0; n < piece.vertices; ++n) {
            const earth::Geodetic at = earth::from_ecef(made.place(piece, n));
            EXPECT_NEAR(at.height.m, 2000, 1);
            EXPECT_NEAR(base::degrees(at.longitude_rad), 9.6, 1e-6);
            south_deg = std::min(south_deg, base::degrees(at.latitude_rad));
            north_deg = std::max(north_deg, base::degrees(at.latitude_rad));
        }
    EXPECT_NEAR(south_deg, 46.5, 1e-5);
    EXPECT_NEAR(north_deg, 46.7, 1e-5) << "the whole path";
}

TEST(PathwaySolids, TheLineLeadsOnFromTheFramesToTheEndAndEndsAtTheGround) {
    ElementOfTest test(planned());
    const auto southernmost_deg = [](const Built& made) {
        double south_deg = 90;
        for (const SolidPiece& piece : made.room.batch.pieces()) {
            if (std::any_of(made.frames.begin(), made.frames.end(),
                            [&](const PathwayFrame& frame) { return frame.middle == piece.anchor; }))
                continue;
            for (std::uint32_t n = 0; n < piece.vertices; ++n)
                south_deg = std::min(south_deg, base::degrees(earth::from_ecef(made.place(piece, n)).latitude_rad));
        }
        return south_deg;
    };
    const Built made = built(test);
    EXPECT_GT(southernmost_deg(made), 46.57) << "nothing behind the own ship, and no line through the nearest frames";
    EXPECT_LT(southernmost_deg(made), 46.62);
    test.ground.height = 1997;
    const Built low = built(test);
    EXPECT_EQ(low.room.batch.pieces().size(), low.frames.size()) << "no line";
    test.ground.height = 2001;
    EXPECT_EQ(built(test).count.hidden, 1u) << "a path in the ground";
}

TEST(PathwaySolids, LinesOfOthersHaveNoFrames) {
    ElementOfTest test(planned(0, true));
    const Built made = built(test);
    EXPECT_EQ(made.count.drawn, 2u);
    for (const PathwayFrame& frame : made.frames) EXPECT_EQ(frame.point.feature, 0u);
}

TEST(PathwaySolids, WhatHasNoRoomIsCountedAsHidden) {
    ElementOfTest test(planned(40));
    test.element.uncertainty = ElementUncertainty::widening;
    const Built made = built(test, true, 300);
    EXPECT_EQ(made.count.hidden, 1u);
    EXPECT_EQ(made.count.drawn, 0u);
    EXPECT_GT(made.room.batch.use().refused, 0u);
    EXPECT_LE(made.room.batch.vertices().size(), 300u);
}

TEST(PathwaySolids, ARimIsDarkAndBehindItsLine) {
    ElementOfTest test(planned());
    const std::size_t bare = built(test).room.batch.pieces().size();
    test.element.halo_px = 2;
    test.element.ghost = 0.5;
    const Built made = built(test);
    const auto pieces = made.room.batch.pieces();
    ASSERT_EQ(pieces.size(), 2 * bare);
    for (std::size_t n = 0; n < bare; ++n) {
        EXPECT_EQ(pieces[n].anchor, pieces[n + bare].anchor) << "equally far, and so drawn in this order";
        EXPECT_GT(pieces[n].look.raised_px, pieces[n + bare].look.raised_px);
        EXPECT_EQ(pieces[n].look.ghost, 0);
        EXPECT_LT(made.room.batch.vertices()[pieces[n].first_vertex].rgba[0], 20);
        EXPECT_EQ(made.room.batch.vertices()[pieces[n + bare].first_vertex].rgba[0], 200);
    }
}

TEST(PathwaySolids, AreForPlannedPaths) {
    host_sim::LayerDraft draft = planned();
    for (const auto role : {scene::LayerRole::trajectory, scene::LayerRole::traffic, scene::LayerRole::road}) {
        draft.role = role;
        ElementOfTest test(draft);
        EXPECT_EQ(shows_pathways(test.input().layer), role == scene::LayerRole::trajectory);
    }
}

}  // namespace
}  // namespace tedavis::draw::test_pathway_solids
