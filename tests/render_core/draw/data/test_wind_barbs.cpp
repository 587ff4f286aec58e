#include "render_core/draw/data/wind_barbs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "tests/support/draw/billboard_room.hpp"

namespace tedavis::draw::test_wind_barbs {
namespace {

using test_support::BillboardRoom;
using test_support::ElementOfTest;

/// So many metres ahead and right of the eye, at its height.
scene::SelectedGlyph glyph(const BillboardRoom& room, double ahead_m, double right_m, float east_mps, float north_mps) {
    scene::SelectedGlyph result;
    result.summary.place = glm::vec3(room.view.forward * ahead_m + room.view.right * right_m);
    result.summary.value = east_mps;
    result.summary.north_mps = north_mps;
    result.summary.speed_mps = std::hypot(east_mps, north_mps);
    result.summary.members = 1;
    result.summary.state = scene::ValueState::valid;
    result.summary.uncertainty = scene::Uncertainty::from_code(0);
    return result;
}

struct Barbs {
    explicit Barbs(double heading_deg = 0) : room(16'384, heading_deg), test(test_support::small_grid()) {}
    ElementCount build(const std::vector<scene::SelectedGlyph>& glyphs) {
        room.begin();
        return add_wind_barbs(room.sheet, test.input(), {glyphs.data(), glyphs.size()});
    }
    BillboardRoom room;
    ElementOfTest test;
};

TEST(WindBarbs, LeadToWhereTheWindComesFromAsSeenFromTheEye) {
    // A south wind: behind who flies north, below on the picture; on the right of who flies east.
    for (const double heading_deg : {0.0, 90.0, 180.0}) {
        Barbs barbs(heading_deg);
        EXPECT_EQ(barbs.build({glyph(barbs.room, 5000, 0, 0, 10)}).drawn, 1u);
        const Rect bounds = barbs.room.bounds();
        const double off_x = static_cast<double>(bounds.center().x) - 400, off_y = static_cast<double>(bounds.center().y) - 300;
        const double heading = base::radians(heading_deg);
        EXPECT_GT(off_x * std::sin(heading) + off_y * std::cos(heading), 8) << heading_deg;
    }
}

TEST(WindBarbs, SeenFromAboveThePicturesUpIsAhead) {
    Barbs barbs;
    const terrain::View level = barbs.room.view;
    barbs.room.view.forward = level.down;
    barbs.room.view.down = -level.forward;
    EXPECT_EQ(barbs.build({glyph(barbs.room, 5000, 0, 0, -10)}).drawn, 1u);
    EXPECT_LT(barbs.room.bounds().center().y, 300 - 8) << "from the north, which is up";
}

TEST(WindBarbs, TheNearestHaveTheRoomAndMembersAreCounted) {
    Barbs barbs;
    scene::SelectedGlyph far = glyph(barbs.room, 9000, 10, 5, 5), mean = glyph(barbs.room, 9000, 3000, 5, 5);
    far.summary.members = mean.summary.members = 7;
    far.is_aggregate = mean.is_aggregate = true;
    const ElementCount count = barbs.build({far, glyph(barbs.room, 5000, 0, 5, 5), mean, glyph(barbs.room, -500, 0, 5, 5)});
    EXPECT_EQ(count.drawn, 1u);
    EXPECT_EQ(count.aggregated, 7u);
    EXPECT_EQ(count.hidden, 8u);
    EXPECT_EQ(barbs.build({}).all(), 0u);
}

TEST(WindBarbs, ColorsFollowTheSpeedAndWhatIsNotKnown) {
    Barbs barbs;
    barbs.build({glyph(barbs.room, 5000, 0, 5, 5)});
    const auto has = [&](design::Color color) {
        for (const QuadVertex& vertex : barbs.room.drawn())
            if (design::Color{vertex.rgba[0], vertex.rgba[1], vertex.rgba[2], vertex.rgba[3]} == color) return true;
        return false;
    };
    EXPECT_TRUE(has({200, 40, 20, 255}));
    scene::SelectedGlyph missing = glyph(barbs.room, 5000, 0, 5, 5);
    missing.summary.state = scene::ValueState::missing;
    barbs.build({missing});
    EXPECT_TRUE(has({255, 0, 255, 255})) << "the colour of missing data";
    EXPECT_FALSE(has({200, 40, 20, 255}));
    barbs.test.element.uncertainty = design::ElementUncertainty::transparency;
    barbs.test.element.uncertainty_strength = 0.5;
    scene::SelectedGlyph unsure = glyph(barbs.room, 5000, 0, 5, 5);
    unsure.summary.uncertainty = scene::Uncertainty();
    barbs.build({unsure});
    EXPECT_TRUE(has({200, 40, 20, 128}));
}

TEST(WindBarbs, ALinkLeadsDown) {
    Barbs barbs;
    barbs.build({glyph(barbs.room, 5000, 0, 0, 10)});
    const float free = barbs.room.bounds().bottom();
    EXPECT_TRUE(barbs.room.links.vertices().empty());
    barbs.test.element.link = true;
    scene::SelectedGlyph high = glyph(barbs.room, 5000, 0, 0, 10);
    barbs.build({high});
    EXPECT_EQ(barbs.room.bounds().bottom(), free) << "nobody knows how far";
    high.summary.over_ground_m = 400;
    barbs.build({high});
    const double foot_px = 300 + 400 * barbs.room.view.focal_px / 5000;
    EXPECT_NEAR(static_cast<double>(barbs.room.bounds().bottom()), foot_px, 3);
}

}  // namespace
}  // namespace tedavis::draw::test_wind_barbs
