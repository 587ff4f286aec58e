#include "host_sim/accuracy/knobs/cell_cut_knob.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/host_sim/accuracy/knob_errors.hpp"
#include "tests/support/files/hard_case.hpp"
#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::host_sim::test_cell_cut_knob {
namespace {

constexpr int kParts = 120;

std::size_t place_of(int row, int column) {
    return static_cast<std::size_t>(row) * (kParts + 1) + static_cast<std::size_t>(column);
}

/// Whether the inside parts of a face hang together: the face in small squares, filled from one inside corner.
bool hang_together(const FaceValues& face) {
    const auto is_in = [&](int a, int b) {
        const double u = a / double{kParts}, v = b / double{kParts};
        return (1 - u) * ((1 - v) * face.corner[0][0] + v * face.corner[0][1]) +
                   u * ((1 - v) * face.corner[1][0] + v * face.corner[1][1]) >=
               0;
    };
    const bool is_diagonal = face.corner[0][0] >= 0;
    std::vector<bool> seen((kParts + 1) * (kParts + 1));
    std::vector<std::pair<int, int>> open = {{0, is_diagonal ? 0 : kParts}};
    while (!open.empty()) {
        const auto [a, b] = open.back();
        open.pop_back();
        if (a < 0 || b < 0 || a > kParts || b > kParts || !is_in(a, b)) continue;
        const std::size_t at = place_of(a, b);
        if (seen[at]) continue;
        seen[at] = true;
        for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) open.emplace_back(a + x, b + y);
    }
    return seen[place_of(kParts, is_diagonal ? kParts : 0)];
}

TEST(CellCutKnob, TheReferenceJoinsWhatHangsTogether) {
    test_support::Dice dice(1);
    int joined = 0, parted = 0;
    for (int n = 0; n < 4000; ++n) {
        const FaceValues face{{{dice.between(-1, 1), dice.between(-1, 1)}, {dice.between(-1, 1), dice.between(-1, 1)}}};
        if (!face.is_ambiguous()) continue;
        const double straight = face.corner[0][0] * face.corner[1][1], across = face.corner[0][1] * face.corner[1][0];
        if (std::abs(straight - across) < 0.02) continue;  // the neck is thinner than the squares
        EXPECT_EQ(face.joins_inside(), hang_together(face)) << n;
        ++(face.joins_inside() ? joined : parted);
    }
    EXPECT_GT(joined, 100);
    EXPECT_GT(parted, 100);
}

TEST(CellCutKnob, OnlyFaceCasesAreAmbiguous) {
    EXPECT_TRUE((FaceValues{{{1, -1}, {-1, 1}}}).is_ambiguous());
    EXPECT_TRUE((FaceValues{{{-1, 1}, {1, -1}}}).is_ambiguous());
    EXPECT_FALSE((FaceValues{{{1, 1}, {-1, -1}}}).is_ambiguous());
    EXPECT_FALSE((FaceValues{{{1, 1}, {1, -1}}}).is_ambiguous());
    EXPECT_FALSE((FaceValues{{{1, 1}, {1, 1}}}).is_ambiguous());
}

/// Faces are decided without knowing the field, so about half of the ambiguous ones are wrong; cells that are cut alike into five
/// leave open edges besides, nearly everywhere.
TEST(CellCutKnob, CellsThatDoNotMeetLeaveOpenEdges) {
    const test_support::MadeKnobGround made;
    const auto knob = make_cell_cut_knob(made.quick());
    ASSERT_TRUE(knob->facts().only_level.has_value());
    const ErrorDistribution six = test_support::errors_of(*knob, 0), mirrored = test_support::errors_of(*knob, 1),
                            alike = test_support::errors_of(*knob, 2);
    EXPECT_GT(six.mean, 0) << "a rough field has ambiguous faces";
    EXPECT_NEAR(six.mean / mirrored.mean, 1, 0.25) << "neither knows the field";
    EXPECT_GT(alike.mean, 10 * six.mean) << "control: open edges";
    test_support::record_worst("A33", six.mean);
    test_support::record_control("A33", alike.mean);
}

}  // namespace
}  // namespace tedavis::host_sim::test_cell_cut_knob
