#include "host_sim/window/free_camera.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim::test_free_camera {
namespace {

using base::Duration;
using base::radians;

CameraPose pose_at(double latitude_deg, double longitude_deg, double height_m, double heading_deg, double pitch_deg) {
    return {{radians(latitude_deg), radians(longitude_deg), {height_m}}, radians(heading_deg), radians(pitch_deg), 0};
}

FreeCamera camera_at(const CameraPose& pose) {
    FreeCamera camera;
    camera.place(pose);
    return camera;
}

TEST(FreeCamera, FliesAlongItsView) {
    FreeCamera camera = camera_at(pose_at(47, 9, 3000, 90, 0));
    const CameraPose before = camera.pose();
    camera.fly({1, 0, 0}, Duration::milliseconds(500));
    EXPECT_NEAR(earth::surface_distance_m(before.position, camera.pose().position), 100, 0.1) << "200 m/s for 0.5 s";
    EXPECT_GT(camera.pose().position.longitude_rad, before.position.longitude_rad) << "east";
    EXPECT_NEAR(camera.pose().position.latitude_rad, before.position.latitude_rad, 1e-9);
    EXPECT_NEAR(camera.pose().position.height.m, 3000, 0.01);
}

TEST(FreeCamera, EachMotionIsUndoneByItsOpposite) {
    FreeCamera camera = camera_at(pose_at(-33, 151, 500, 200, -20));
    const earth::Ecef start = earth::to_ecef(camera.pose().position);
    for (const CameraMotion motion : {CameraMotion{1, 0, 0}, CameraMotion{0, 1, 0}, CameraMotion{0, 0, 1}}) {
        camera.fly(motion, Duration::milliseconds(100));
        EXPECT_NEAR(glm::distance(earth::to_ecef(camera.pose().position), start), 20, 0.001);
        camera.fly({-motion.forward, -motion.right, -motion.up}, Duration::milliseconds(100));
        EXPECT_NEAR(glm::distance(earth::to_ecef(camera.pose().position), start), 0, 0.001);
    }
}

TEST(FreeCamera, UpIsStraightUpHoweverItLooks) {
    FreeCamera camera = camera_at(pose_at(10, 20, 100, 45, -80));
    camera.fly({0, 0, 1}, Duration::seconds(1));
    EXPECT_NEAR(camera.pose().position.height.m, 300, 1e-3);
    EXPECT_NEAR(camera.pose().position.latitude_rad, radians(10), 1e-9);
}

TEST(FreeCamera, StaysWhereTerrainMakesSense) {
    FreeCamera camera = camera_at(pose_at(10, 20, 100, 45, -80));
    for (int n = 0; n < 100; ++n) camera.change_speed(1);
    EXPECT_EQ(camera.speed_mps(), 50'000);
    for (int n = 0; n < 100; ++n) camera.fly({0, 0, 1}, Duration::seconds(1));
    EXPECT_EQ(camera.pose().position.height.m, 100'000);
    for (int n = 0; n < 100; ++n) camera.fly({0, 0, -1}, Duration::seconds(1));
    EXPECT_EQ(camera.pose().position.height.m, -1000);
    for (int n = 0; n < 100; ++n) camera.change_speed(-1);
    EXPECT_EQ(camera.speed_mps(), 1);
}

TEST(FreeCamera, LooksAroundButNeverOverhead) {
    FreeCamera camera = camera_at(pose_at(10, 20, 100, 350, 0));
    camera.look(radians(20), radians(30));
    EXPECT_NEAR(camera.pose().heading_rad, radians(10), 1e-12);
    EXPECT_NEAR(camera.pose().pitch_rad, radians(30), 1e-12);
    camera.look(0, 10);
    EXPECT_NEAR(camera.pose().pitch_rad, radians(89), 1e-12);
    camera.look(0, -10);
    EXPECT_NEAR(camera.pose().pitch_rad, radians(-89), 1e-12);
}

TEST(FreeCamera, IsLevelWhenItTakesOver) {
    CameraPose pose = pose_at(10, 20, 100, 45, -95);
    pose.roll_rad = 1;
    const FreeCamera camera = camera_at(pose);
    EXPECT_EQ(camera.pose().roll_rad, 0);
    EXPECT_NEAR(camera.pose().pitch_rad, radians(-89), 1e-12);
}

TEST(FreeCamera, ItsViewSeesWhatLiesAhead) {
    const CameraPose pose = pose_at(47, 9, 2000, 0, -45);
    const terrain::View view = view_of(pose, 640, 480, radians(60), 7);
    EXPECT_EQ(view.width, 640u);
    EXPECT_EQ(view.near_m, 7);
    EXPECT_NEAR(view.half_width_tangent(), std::tan(radians(30)), 1e-12);
    // 45 degrees down towards the north: 2000 m north on the ground lies in the middle of the picture.
    const earth::Ecef ahead = earth::to_ecef({radians(47) + 2000 / earth::meridian_radius_m(radians(47)), radians(9), {0}});
    const glm::dvec3 seen = ahead - view.eye;
    EXPECT_NEAR(glm::dot(seen, view.right), 0, 1e-3);
    EXPECT_NEAR(glm::dot(seen, view.down), 0, 2);
    EXPECT_NEAR(glm::dot(seen, view.forward), 2000 * std::sqrt(2.0), 2);
}

}  // namespace
}  // namespace tedavis::host_sim::test_free_camera
