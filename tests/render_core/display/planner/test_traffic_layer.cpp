#include "render_core/display/planner/traffic_layer.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <cmath>
#include <vector>

#include "render_core/draw/data/traffic_state.hpp"
#include "tests/support/draw/built_element.hpp"
#include "tests/support/flights/sent_traffic.hpp"

namespace tedavis::display::test_traffic_layer {
namespace {

using base::Duration;
using test_support::traffic_report;

constexpr base::Time kNow{50'000'000'000};
constexpr Duration kAhead = Duration::seconds(1'780'000'000);

class TrafficLayerTest : public ::testing::Test {
protected:
    TrafficLayerTest() : block_(8192) {
        base::Arena arena(block_.data(), block_.size());
        EXPECT_TRUE(layer_.start(arena));
    }
    void take(const std::vector<flight::TrafficReport>& reports) {
        flight::Traffic traffic;
        traffic.is_received = true;
        for (const flight::TrafficReport& report : reports) EXPECT_TRUE(traffic.reports.try_push_back(report));
        layer_.take(traffic, kAhead);
    }
    /// So long after kNow, as the techniques see it.
    draw::TrafficState state(double seconds, std::uint32_t feature = 0) {
        const draw::ElementInput input{
            element_, 0, layer_.layer(), ground_, {}, (kNow + kAhead + Duration::from_seconds(seconds)).ns, true};
        return traffic_state(input, feature);
    }

    std::vector<unsigned char> block_;
    test_support::LevelGround ground_;
    design::DataElement element_;
    TrafficLayer layer_;
};

TEST_F(TrafficLayerTest, SaysWhoWhereAndHowSure) {
    flight::TrafficReport other = traffic_report(0x3EEF01, kNow, 47.2);
    other.callsign = {};
    other.place.position_deviation_m = 0;
    take({traffic_report(0xA0F12B, kNow), other});
    const scene::Layer& layer = layer_.layer();
    ASSERT_EQ(layer.entry->feature_count, 2u);
    EXPECT_EQ(layer.entry->role, scene::LayerRole::traffic);
    EXPECT_EQ(layer.name_of(0), "TDV417");
    EXPECT_EQ(layer.name_of(1), "3EEF01");
    EXPECT_EQ(layer.entry->data_time_ns, (kNow + kAhead).ns) << "in the flight's time";
    const draw::TrafficState now = state(0);
    EXPECT_TRUE(now.is_known && now.has_velocity && !now.is_stale);
    EXPECT_EQ(now.point.latitude_rad, base::radians(47.01));
    EXPECT_EQ(now.point.height_m, 1500.5f);
    EXPECT_NEAR(now.accuracy.level_m, 2.4477 * 40, 0.01);
    EXPECT_NEAR(now.accuracy.height_m, 1.96 * 20, 0.01);
    EXPECT_EQ(state(0, 1).accuracy.level_m, 0) << "nobody knows";
}

/// The stated velocity, not one between reports: against the geodesic.
TEST_F(TrafficLayerTest, GoesOnAsItsVelocitySays) {
    for (const double latitude : {-70.0, 0.0, 47.0, 89.0}) {
        flight::TrafficReport report = traffic_report(1, kNow, latitude, 179.9999);
        report.true_track_rad = static_cast<float>(base::radians(60));
        take({report});
        const draw::TrafficState state = this->state(8);
        EXPECT_NEAR(std::hypot(state.east, state.north), 60, 0.02) << latitude;
        EXPECT_NEAR(state.up, 2.5, 0.01) << latitude;
        double expected_latitude = 0, expected_longitude = 0;
        GeographicLib::Geodesic::WGS84().Direct(latitude, 179.9999, 60, 480, expected_latitude, expected_longitude);
        EXPECT_NEAR(base::degrees(state.point.latitude_rad), expected_latitude, 2e-5) << latitude;
        EXPECT_NEAR(std::remainder(base::degrees(state.point.longitude_rad) - expected_longitude, 360) *
                        std::cos(base::radians(latitude)),
                    0, 5e-5)
            << latitude;
        EXPECT_NEAR(static_cast<double>(state.point.height_m), 1500.5 + 8 * 2.5, 0.1);
    }
}

TEST_F(TrafficLayerTest, LeadsTheWayThatItHasCome) {
    flight::TrafficReport report = traffic_report(1, kNow);
    for (int n = 0; n < 3; ++n) {
        flight::TrafficPlace place = report.place;
        place.latitude_rad -= 1e-4 * (3 - n);
        place.at = kNow - Duration::seconds(5 * (2 - n)) - Duration::milliseconds(50);
        ASSERT_TRUE(report.before.try_push_back(place));
    }
    take({report, traffic_report(2, kNow)});
    EXPECT_EQ(layer_.layer().points_of(0).count, 4u) << "the last is too near to say more than the velocity does";
    EXPECT_EQ(layer_.layer().points_of(1).count, 2u);
    for (std::uint32_t n = 1; n < 4; ++n) EXPECT_GT(layer_.layer().points[n].time_ns, layer_.layer().points[n - 1].time_ns);
}

TEST_F(TrafficLayerTest, HoldsAsMuchAsCanBeHeard) {
    flight::TrafficReport report = traffic_report(1, kNow);
    for (std::size_t n = 0; n < flight::kMaxTrafficPlaces; ++n) {
        flight::TrafficPlace place = report.place;
        place.at = kNow - Duration::seconds(static_cast<std::int64_t>(50 - 5 * n));
        ASSERT_TRUE(report.before.try_push_back(place));
    }
    take(std::vector<flight::TrafficReport>(flight::kMaxTraffic, report));
    EXPECT_EQ(layer_.layer().entry->feature_count, flight::kMaxTraffic);
    EXPECT_EQ(layer_.layer().entry->point_count, TrafficLayer::kMaxPoints);
    take({});
    EXPECT_EQ(layer_.layer().entry->feature_count, 0u);
    EXPECT_EQ(layer_.layer().entry->data_time_ns, scene::kNoTime);
}

TEST_F(TrafficLayerTest, StandsAtAPole) {
    take({traffic_report(1, kNow, 90, 10)});
    EXPECT_TRUE(std::isfinite(state(5).point.latitude_rad + state(5).point.longitude_rad));
}

TEST(TrafficLayer, ATooSmallArenaIsSaid) {
    std::vector<unsigned char> block(1024);
    base::Arena arena(block.data(), block.size());
    TrafficLayer layer;
    EXPECT_FALSE(layer.start(arena));
}

}  // namespace
}  // namespace tedavis::display::test_traffic_layer
