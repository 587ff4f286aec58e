#include "render_core/draw/data/line_places.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tedavis::draw::test_line_places {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

/// A way along x of legs of so many metres, seen from beside it at `eye_m`.
struct Polyline {
    std::vector<double> legs_m;
    double eye_m = 0;

    [[nodiscard]] PolylineMeasure measured() const {
        PolylineMeasure way;
        double at_m = -eye_m;
        for (const double leg_m : legs_m) {
            way.add_leg(leg_m, {at_m, 0, 50}, {at_m + leg_m, 0, 50});
            at_m += leg_m;
        }
        return way;
    }
    [[nodiscard]] std::vector<double> lines(const design::ElementCues& cues, bool from_end, std::int64_t time_ns) const {
        const LinePlaces places(cues, measured(), from_end, time_ns);
        std::vector<double> found;
        double at_m = 0;
        for (std::size_t n = 0; n < legs_m.size(); ++n) {
            places.visit(at_m, at_m + legs_m[n], n + 1 == legs_m.size(), [&](double along_m) { found.push_back(along_m); });
            at_m += legs_m[n];
        }
        return found;
    }
};

design::ElementCues moving(design::LineMotion motion) {
    design::ElementCues cues;
    cues.line_spacing_m = 100;
    cues.lines_move = motion;
    cues.line_speed_mps = 10;
    return cues;
}

TEST(PolylineMeasure, KnowsItsLengthAndWhereItIsNearest) {
    const PolylineMeasure way = Polyline{{100, 0, 300}, 250}.measured();
    EXPECT_DOUBLE_EQ(way.length_m(), 400);
    EXPECT_DOUBLE_EQ(way.nearest_m(), 250);
    EXPECT_DOUBLE_EQ((Polyline{{100, 300}, 900}.measured().nearest_m()), 400);
}

TEST(LinePlaces, EachStandsOnceHoweverTheWayIsCut) {
    const design::ElementCues still = moving(design::LineMotion::still);
    const std::vector<double> whole{0, 100, 200, 300, 400};
    EXPECT_EQ((Polyline{{400}}.lines(still, false, 0)), whole);
    EXPECT_EQ((Polyline{{100, 0, 50, 150, 100}}.lines(still, false, 0)), whole) << "points at lines, and on each other";
    EXPECT_EQ((Polyline{{430}}.lines(still, true, 0)), (std::vector<double>{30, 130, 230, 330, 430}));
}

TEST(LinePlaces, TheyComeAsFarAsTheTimeSays) {
    const design::ElementCues along = moving(design::LineMotion::along);
    EXPECT_EQ((Polyline{{250}}.lines(along, false, 3 * kSecond_ns)), (std::vector<double>{30, 130, 230}));
    EXPECT_EQ((Polyline{{250}}.lines(along, false, -7 * kSecond_ns)), (std::vector<double>{30, 130, 230}));
    EXPECT_EQ((Polyline{{250}}.lines(moving(design::LineMotion::still), false, 3 * kSecond_ns)),
              (std::vector<double>{0, 100, 200}));
}

TEST(LinePlaces, TheyPartWhereTheWayIsNearest) {
    const design::ElementCues away = moving(design::LineMotion::away);
    EXPECT_EQ((Polyline{{500}, 250}.lines(away, false, 3 * kSecond_ns)), (std::vector<double>{70, 170, 330, 430}));
    EXPECT_EQ((Polyline{{500}, -900}.lines(away, false, 3 * kSecond_ns)), (std::vector<double>{30, 130, 230, 330, 430}));
}

}  // namespace
}  // namespace tedavis::draw::test_line_places
