#include "render_core/draw/data/runway_strips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/ground_section.hpp"
#include "render_core/draw/data/papi.hpp"
#include "render_core/draw/data/runway_surface.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_runway_strips {
namespace {

using base::kMetresPerNauticalMile;
using test_support::scene_point;

constexpr double kLength_m = 1500, kWidth_m = 45, kFocal_px = 1000;

/// To the north.
host_sim::LayerDraft one_runway(double length_m = kLength_m) {
    host_sim::LayerDraft layer;
    layer.name = "runways";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::runway;
    layer.points = {scene_point(46.8, 9.8, 500), moved(scene_point(46.8, 9.8, 500), {0, length_m})};
    layer.starts = {0, 2};
    layer.names = {"HERE 36/18"};
    host_sim::AttributeDraft width;
    width.name = "width";
    width.of = scene::AttributeOf::feature;
    width.values = {static_cast<float>(kWidth_m)};
    layer.attributes.push_back(width);
    return layer;
}

struct Corner {
    double east_m, north_m, up_m;  ///< from the threshold, on the ground at 600 m
    design::Color color;
};

/// A runway as it is built for an eye before its threshold.
class Built {
public:
    explicit Built(double before_m, double angle_deg = 3, const host_sim::LayerDraft& layer = one_runway(),
                   bool has_own_ship = true, std::size_t room = 65536)
        : test_(layer), room_(room) {
        test_.element.color = {40, 40, 44, 255};
        const scene::ScenePoint at = moved(threshold(), {0, -before_m});
        const double aiming_m = before_m + 300;
        const earth::Geodetic own{at.latitude_rad,
                                  at.longitude_rad,
                                  {600 + aiming_m * std::tan(base::radians(angle_deg)) + aiming_m * aiming_m / (2 * 6.37e6)}};
        ElementInput input = test_.input();
        input.eye = earth::to_ecef(own);
        ApproachFrame frame;
        frame.has_own_ship = has_own_ship;
        frame.own_ship = own;
        frame.forward = earth::north_east_down(at.latitude_rad, at.longitude_rad)[0];
        frame.metres_per_px_m = 1 / kFocal_px;
        eye_ = input.eye;
        count = add_runways(room_.batch, room_.mesh, input, frame);
    }

    [[nodiscard]] std::vector<Corner> corners() const {
        std::vector<Corner> corners;
        const glm::dmat3 axes = earth::north_east_down(threshold().latitude_rad, threshold().longitude_rad);
        const glm::dvec3 from = earth::to_ecef({threshold().latitude_rad, threshold().longitude_rad, {600}});
        for (const SolidPiece& piece : room_.batch.pieces())
            for (std::uint32_t n = 0; n < piece.vertices; ++n) {
                const SolidVertex& vertex = room_.batch.vertices()[piece.first_vertex + n];
                const glm::dvec3 offset = piece.anchor + glm::dvec3(vertex.place_m) - from;
                corners.push_back({glm::dot(offset, axes[1]),
                                   glm::dot(offset, axes[0]),
                                   -glm::dot(offset, axes[2]),
                                   {vertex.rgba[0], vertex.rgba[1], vertex.rgba[2], vertex.rgba[3]}});
            }
        return corners;
    }
    /// Of the vertices with a color, by what they have in common.
    template <class Where>
    [[nodiscard]] std::vector<Corner> where(const Where& where) const {
        std::vector<Corner> found;
        for (const Corner& corner : corners())
            if (where(corner)) found.push_back(corner);
        return found;
    }
    [[nodiscard]] const SolidBatch& batch() const { return room_.batch; }
    static scene::ScenePoint threshold() { return scene_point(46.8, 9.8, 500); }

    ElementCount count;

private:
    test_support::ElementOfTest test_;
    test_support::SolidRoomOfTest room_;
    glm::dvec3 eye_{0};
};

bool is_paint(const Corner& corner) { return corner.color.red == 245 && corner.color.alpha == 255; }
bool is_red(const Corner& corner) { return corner.color.red == 235 && corner.color.green == 30; }
bool is_white_light(const Corner& corner) { return corner.color.red == 255 && corner.color.green == 255; }
bool is_dim(const Corner& corner) { return corner.color.red == 245 && corner.color.alpha == 150; }

TEST(RunwayStrips, P28TheOutlineIsAsWideOnTheScreenAtAnyDistance) {
    for (const double before_nm : {0.5, 2.0, 5.0, 10.0, 20.0}) {
        const Built built(before_nm * kMetresPerNauticalMile);
        ASSERT_EQ(built.count.drawn, 1u);
        double outermost_m = 0;
        for (const Corner& corner : built.corners())
            if (is_paint(corner) && std::fabs(corner.north_m) < 5) outermost_m = std::max(outermost_m, corner.east_m);
        const double distance_m = before_nm * kMetresPerNauticalMile, px_m = distance_m / kFocal_px;
        const double outline_px = (outermost_m - kWidth_m / 2) / px_m;
        EXPECT_GE(outline_px, kMinOutline_px * 0.98) << before_nm;
        EXPECT_LE(outline_px * px_m, std::max(kOutline_m, kMinOutline_px * px_m) * 1.02) << before_nm;
    }
}

TEST(RunwayStrips, P28TheyAreDrawnLastOverAllAndSeatedOnTheGround) {
    const Built built(2 * kMetresPerNauticalMile);
    ASSERT_EQ(built.batch().pieces().size(), 1u);
    const SolidLook& look = built.batch().pieces()[0].look;
    EXPECT_TRUE(look.is_last);
    EXPECT_FALSE(look.is_thing) << "it has no shadow";
    EXPECT_GT(look.nearer_m, 0);
    const auto surface = built.where([](const Corner& corner) { return corner.color.red == 40; });
    EXPECT_GE(surface.size(), 4u);
    for (const Corner& corner : surface) EXPECT_NEAR(corner.up_m, 0.3, 0.5);
}

TEST(RunwayStrips, P29MarkingsAreLeftOutWhereTheyAreSmallerThanAPixel) {
    const auto corners = [](double before_m) { return Built(before_m, 3, one_runway(), false).corners().size(); };
    EXPECT_GT(corners(300), corners(2000));
    EXPECT_GT(corners(2000), corners(15'000));
    const Built far(15'000, 3, one_runway(), false);
    const auto inside =
        far.where([](const Corner& corner) { return is_paint(corner) && std::fabs(corner.east_m) < kWidth_m / 2 - 1; });
    EXPECT_TRUE(inside.empty()) << "from afar there is the surface only";
    const Built near(300, 3, one_runway(), false);
    const auto aiming = near.where([](const Corner& corner) {
        return is_paint(corner) && std::fabs(corner.north_m - 300) < 0.5 && std::fabs(corner.east_m) < 20;
    });
    EXPECT_EQ(aiming.size(), 4u) << "both aiming points begin there";
}

TEST(RunwayStrips, P30TheExtendedCenterLineIsDimWithATickAtEachMile) {
    const Built built(3 * kMetresPerNauticalMile);
    const auto line = built.where([](const Corner& corner) { return is_dim(corner) && std::fabs(corner.east_m) < 100; });
    ASSERT_FALSE(line.empty());
    double out_m = 0;
    for (const Corner& corner : line) {
        out_m = std::max(out_m, -corner.north_m);
        EXPECT_LT(corner.north_m, 10) << "on the side of the approach only";
    }
    EXPECT_NEAR(out_m, kExtendedNm * kMetresPerNauticalMile, 100);
    for (int mile = 1; mile <= kExtendedNm; ++mile) {
        const auto ticks = built.where([&](const Corner& corner) {
            return is_dim(corner) && corner.east_m > 100 && std::fabs(corner.north_m + mile * kMetresPerNauticalMile) < 300;
        });
        EXPECT_EQ(ticks.size(), 2u) << mile;
    }
    EXPECT_TRUE(Built(3 * kMetresPerNauticalMile, 3, one_runway(), false).where(is_dim).empty()) << "control: no position";
}

TEST(RunwayStrips, P31ThePapiHasTheLightsOfTheAngle) {
    const auto lights = [](double angle_deg) {
        const Built built(3 * kMetresPerNauticalMile, angle_deg);
        return std::pair(built.where(is_white_light).size() / 4, built.where(is_red).size() / 4);
    };
    EXPECT_EQ(lights(4), (std::pair<std::size_t, std::size_t>(4, 0)));
    EXPECT_EQ(lights(3.3), (std::pair<std::size_t, std::size_t>(3, 1)));
    EXPECT_EQ(lights(3), (std::pair<std::size_t, std::size_t>(2, 2)));
    EXPECT_EQ(lights(2.7), (std::pair<std::size_t, std::size_t>(1, 3)));
    EXPECT_EQ(lights(2), (std::pair<std::size_t, std::size_t>(0, 4)));
}

TEST(RunwayStrips, P31RedLightsAreLowerThanWhiteOnesAndAllAreSeen) {
    for (const double before_nm : {0.5, 3.0, 9.0}) {
        const double px_m = before_nm * kMetresPerNauticalMile / kFocal_px;
        const Built built(before_nm * kMetresPerNauticalMile);
        const auto height_m = [](const std::vector<Corner>& of) {
            double low = 1e9, high = -1e9;
            for (const Corner& corner : of) {
                low = std::min(low, corner.up_m);
                high = std::max(high, corner.up_m);
            }
            return high - low;
        };
        const double white_m = height_m(built.where(is_white_light)), red_m = height_m(built.where(is_red));
        EXPECT_NEAR(red_m, white_m / 2, 0.1 * white_m) << before_nm;
        EXPECT_GE(red_m / px_m, 2) << before_nm;
        for (const Corner& corner : built.where([](const Corner& c) { return is_red(c) || is_white_light(c); }))
            EXPECT_LT(corner.east_m, -kWidth_m / 2 - kPapiFree_m + 3) << "on the left, beside the runway";
    }
}

TEST(RunwayStrips, P31WithoutAValidPositionOrBeyondTenMilesThereAreNoLights) {
    const auto has_lights = [](const Built& built) {
        return !built.where(is_red).empty() || !built.where(is_white_light).empty();
    };
    EXPECT_TRUE(has_lights(Built(5 * kMetresPerNauticalMile)));
    EXPECT_FALSE(has_lights(Built(5 * kMetresPerNauticalMile, 3, one_runway(), false)));
    EXPECT_FALSE(has_lights(Built(10.5 * kMetresPerNauticalMile)));
}

TEST(RunwayStrips, P31ThePathIsThatOfTheScene) {
    host_sim::LayerDraft steep = one_runway();
    host_sim::AttributeDraft path;
    path.name = "glide_path";
    path.of = scene::AttributeOf::feature;
    path.values = {static_cast<float>(base::radians(5.5))};
    steep.attributes.push_back(path);
    EXPECT_EQ(Built(4000, 5.5, steep).where(is_red).size() / 4, 2u);
    EXPECT_EQ(Built(4000, 5.5).where(is_red).size() / 4, 0u) << "control: the usual path";
}

TEST(RunwayStrips, FullBatchesDrawThemBareAndWhatIsNoneIsHidden) {
    const std::size_t whole = Built(300).corners().size(), bare = Built(300, 3, one_runway(), false).corners().size();
    EXPECT_GT(whole, bare);
    const Built little(300, 3, one_runway(), true, 400);
    EXPECT_EQ(little.count.drawn, 1u);
    EXPECT_LE(little.corners().size(), 400u);
    EXPECT_EQ(Built(300, 3, one_runway(), true, 20).count.hidden, 1u);
    for (const double length_m : {0.0, 20.0, 9000.0}) EXPECT_EQ(Built(300, 3, one_runway(length_m)).count.hidden, 1u) << length_m;
    EXPECT_EQ(Built(120'000).count.hidden, 1u);
}

/// The mesh has room for the longest runway from nearby.
TEST(RunwayStrips, TheLongestOneFits) {
    EXPECT_EQ(Built(300, 3, one_runway(kMaxRunway_m - 1)).count.drawn, 1u);
    EXPECT_FALSE(Built(300, 3, one_runway(kMaxRunway_m - 1)).where(is_red).empty());
}

}  // namespace
}  // namespace tedavis::draw::test_runway_strips
