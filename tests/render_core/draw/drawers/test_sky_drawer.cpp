#include "render_core/draw/drawers/sky_drawer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/programs/gl_session.hpp"
#include "tests/support/programs/headless_backends.hpp"

namespace tedavis::draw::test_sky_drawer {
namespace {

using base::radians;

constexpr std::uint32_t kWidth = 160, kHeight = 120;

/// Sky red, ground green: told apart in every pixel.
SkyInput sky_input(double pitch_deg, double roll_deg, double height_m) {
    SkyInput input;
    input.view = make_view_frame(kWidth, kHeight, radians(60), radians(40), radians(pitch_deg), radians(roll_deg));
    input.dip_rad = horizon_dip_rad(height_m);
    input.colors.zenith = input.colors.horizon = {255, 0, 0};
    input.colors.ground = input.colors.ground_horizon = {0, 255, 0};
    return input;
}

/// Whether the ray of a pixel misses the Earth's sphere: the quadratic of ray and sphere, in long double, with the frames
/// of the Earth module; no dip formula.
bool misses_the_earth(double x, double y, double pitch_deg, double roll_deg, double height_m) {
    const glm::dmat3 body = earth::body_axes(0, 0, radians(40), radians(pitch_deg), radians(roll_deg));
    const double focal = kWidth / 2.0 / std::tan(radians(30));
    const glm::dvec3 ray = body * glm::dvec3(1, (x - kWidth / 2.0) / focal, (y - kHeight / 2.0) / focal);
    const long double radius = 6'371'008.8L, eye = radius + static_cast<long double>(height_m);  // at (eye, 0, 0)
    const long double b = eye * static_cast<long double>(ray.x), a = static_cast<long double>(glm::dot(ray, ray)),
                      c = eye * eye - radius * radius;
    return b >= 0 || b * b - a * c < 0;
}

struct SkySession {
    SkySession(const std::string& backend, const std::string& device) : session(backend, device, kWidth, kHeight) {
        const base::Error error = sky.start(session.gl, session.device.budget);
        EXPECT_EQ(error.message.view(), "");
        session.gl.seal();
    }
    ~SkySession() {
        session.gl.retire();
        sky.destroy(session.gl);
    }
    std::vector<std::uint8_t> picture(const SkyInput& input) {
        gl::bind_surface(session.gl, *session.surface);
        session.gl->Clear(GL_DEPTH_BUFFER_BIT);
        sky.draw(session.gl, input);
        return session.pixels();
    }
    test_support::GlSession session;
    SkyDrawer sky;
};

TEST(SkyDrawer, TheHorizonIsWhereRaysTouchTheEarth) {
    for (const char* device : {"es2-small", "es3-mid"}) {
        SkySession gl("egl", device);
        for (double height : {0.0, 300.0, 12'000.0})
            for (double pitch : {-30.0, -5.0, 0.0, 10.0, 30.0})
                for (double roll : {-60.0, 0.0, 20.0, 60.0, 180.0}) {
                    const auto pixels = gl.picture(sky_input(pitch, roll, height));
                    for (std::uint32_t row = 0; row < kHeight; ++row)
                        for (std::uint32_t column = 0; column < kWidth; ++column) {
                            const std::uint8_t* pixel =
                                &pixels[4 * (static_cast<std::size_t>(kHeight - 1 - row) * kWidth + column)];
                            const double x = column + 0.5, y = row + 0.5;
                            // A pixel whose neighbourhood of one pixel is all sky or all ground must be that, purely.
                            int sky = 0;
                            for (int i = 0; i < 4; ++i)
                                sky += misses_the_earth(x + (i % 2 ? 1 : -1), y + (i / 2 ? 1 : -1), pitch, roll, height) ? 1 : 0;
                            if (sky != 0 && sky != 4) continue;
                            ASSERT_EQ(pixel[0], sky == 4 ? 255 : 0) << device << " " << height << " m, pitch " << pitch
                                                                    << " roll " << roll << " at " << x << "," << y;
                            ASSERT_EQ(pixel[1], sky == 4 ? 0 : 255);
                            ASSERT_EQ(pixel[3], 255);
                        }
                }
        EXPECT_EQ(gl.session.gl.denied().total, 0u);
        EXPECT_EQ(gl.session.gl.take_error(), 0u);
    }
}

TEST(SkyDrawer, TheDipMovesTheHorizonDown) {
    SkySession gl("egl", "es3-mid");
    const auto count_sky = [&](double height) {
        const auto pixels = gl.picture(sky_input(0, 0, height));
        int sky = 0;
        for (std::size_t i = 0; i < pixels.size(); i += 4) sky += pixels[i] > 127 ? 1 : 0;
        return sky;
    };
    const int flat = count_sky(0), high = count_sky(12'000);
    EXPECT_EQ(flat, static_cast<int>(kWidth * kHeight / 2));
    const double focal = kWidth / 2.0 / std::tan(radians(30));
    EXPECT_NEAR((high - flat) / static_cast<double>(kWidth), focal * std::tan(std::acos(6'371'008.8 / 6'383'008.8)),
                1.2);  // 3.5 degrees
}

TEST(SkyDrawer, StraightUpIsAllSkyAndStraightDownAllGround) {
    SkySession gl("egl", "es3-mid");
    for (double pitch : {-90.0, 90.0}) {
        const auto pixels = gl.picture(sky_input(pitch, 30, 1000));
        for (std::size_t i = 0; i < pixels.size(); i += 4) ASSERT_EQ(pixels[i], pitch > 0 ? 255 : 0);
    }
}

TEST(SkyDrawer, OnlyWhereNothingElseWasDrawn) {
    SkySession gl("egl", "es3-mid");
    gl::bind_surface(gl.session.gl, *gl.session.surface);
    gl.session.gl->ClearColor(0, 0, 1, 1);
    gl.session.gl->ClearDepthf(0.999f);
    gl.session.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.sky.draw(gl.session.gl, sky_input(0, 0, 0));
    const auto pixels = gl.session.pixels();
    for (std::size_t i = 0; i < pixels.size(); i += 4)
        ASSERT_EQ(pixels[i + 2], 255) << "something nearer than the sky stands here";
}

TEST(SkyDrawer, OsMesaAndEglAgreeBitForBit) {
    const auto backends = test_support::headless_backends();
    std::vector<std::vector<std::uint8_t>> pictures;
    for (const std::string& backend : backends) {
        SkySession gl(backend, "es3-mid");
        SkyInput input = sky_input(7, 33, 3000);
        input.colors = design::SkySettings();
        pictures.push_back(gl.picture(input));
    }
    for (const auto& picture : pictures) EXPECT_EQ(picture, pictures.front());
}

}  // namespace
}  // namespace tedavis::draw::test_sky_drawer
