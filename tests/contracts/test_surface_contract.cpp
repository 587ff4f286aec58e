// What every surface backend must do, run on each backend of this build in both lanes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "platform/surface_factory.hpp"
#include "platform/window/window_surface.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/programs/gl_session.hpp"
#include "tests/support/programs/headless_backends.hpp"
#include "tests/support/programs/virtual_screen.hpp"

namespace tedavis::test_surface_contract {
namespace {

using test_support::GlSession;
using test_support::TriangleScene;

constexpr std::uint32_t kWidth = 160;
constexpr std::uint32_t kHeight = 120;

struct Variant {
    std::string backend;
    std::string device;
};
void PrintTo(const Variant& variant, std::ostream* out) { *out << variant.device << " on " << variant.backend; }

std::vector<Variant> variants() {
    std::vector<Variant> all;
    std::vector<std::string> backends = test_support::headless_backends();
#if defined(TEDAVIS_HAVE_SDL2)
    backends.push_back("window");
#endif
    for (const std::string& backend : backends)
        for (const char* device : {"es2-small", "es3-mid"}) all.push_back({backend, device});
    return all;
}

class SurfaceContract : public testing::TestWithParam<Variant> {
protected:
    SurfaceContract() {
        if (GetParam().backend == "window") screen_ = std::make_unique<test_support::VirtualScreen>();
    }

    std::unique_ptr<base::Surface> make() const {
        const auto lane = GetParam().device == "es2-small" ? platform::ContextLane::es2 : platform::ContextLane::es3;
        const platform::SurfaceSettings settings{kWidth, kHeight, lane};
        if (GetParam().backend == "window") {
            auto window = platform::make_window(settings, "contract");
            EXPECT_TRUE(window.ok()) << window.error().message.c_str();
            return std::move(window.value());
        }
        auto surface = platform::make_surface(GetParam().backend, settings);
        EXPECT_TRUE(surface.ok()) << surface.error().message.c_str();
        return std::move(surface.value());
    }
    GlSession session() const { return GlSession(make(), test_support::shipped_device(GetParam().device)); }

    std::unique_ptr<test_support::VirtualScreen> screen_;
};

using Bytes = std::vector<std::uint8_t>;

std::vector<int> pixel(const Bytes& pixels, std::uint32_t x, std::uint32_t y) {
    const std::size_t at = (std::size_t{y} * kWidth + x) * 4;
    return {pixels[at], pixels[at + 1], pixels[at + 2], pixels[at + 3]};
}

TEST_P(SurfaceContract, HasTheSizeAndNameItWasAskedFor) {
    const auto surface = make();
    EXPECT_EQ(surface->width(), kWidth);
    EXPECT_EQ(surface->height(), kHeight);
    EXPECT_EQ(surface->backend_name(), GetParam().backend);
}

TEST_P(SurfaceContract, GivesA24BitDepthBufferInTheLaneAskedFor) {
    const auto at = session();
    EXPECT_GE(at.gl.driver().depth_bits, 24);
    EXPECT_EQ(at.gl.denied().total, 0u);
}

TEST_P(SurfaceContract, ClearFillsEveryPixel) {
    auto at = session();
    at.gl->ClearColor(1.0f, 0.5f, 0.25f, 1.0f);
    at.gl->Clear(GL_COLOR_BUFFER_BIT);
    const Bytes pixels = at.pixels();
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
        ASSERT_EQ(pixels[i], 255);
        ASSERT_NEAR(pixels[i + 1], 127.5, 0.5);
        ASSERT_NEAR(pixels[i + 2], 63.75, 0.75);
    }
}

TEST_P(SurfaceContract, RowsReadBackBottomFirst) {
    auto at = session();
    at.gl->ClearColor(0, 0, 0, 1);
    at.gl->Clear(GL_COLOR_BUFFER_BIT);
    at.gl->Enable(GL_SCISSOR_TEST);
    at.gl->Scissor(0, 0, kWidth, 1);
    at.gl->ClearColor(0, 1, 0, 1);
    at.gl->Clear(GL_COLOR_BUFFER_BIT);
    at.gl->Disable(GL_SCISSOR_TEST);
    const Bytes pixels = at.pixels();
    EXPECT_EQ(pixel(pixels, 5, 0)[1], 255);
    EXPECT_EQ(pixel(pixels, 5, 1)[1], 0);
    EXPECT_EQ(pixel(pixels, 5, kHeight - 1)[1], 0);
}

/// Weights of the triangle's corners at a pixel centre, from its corners in TriangleScene: an oracle without GL.
struct Weights {
    double a, b, c;
};
Weights weights_at(std::uint32_t px, std::uint32_t py) {
    const double x = (px + 0.5) / kWidth * 2 - 1, y = (py + 0.5) / kHeight * 2 - 1;
    const double ax = -0.7, ay = -0.6, bx = 0.8, by = -0.5, cx = 0.1, cy = 0.75;
    const double area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    const double a = ((bx - x) * (cy - y) - (cx - x) * (by - y)) / area;
    const double b = ((cx - x) * (ay - y) - (ax - x) * (cy - y)) / area;
    return {a, b, 1 - a - b};
}

TEST_P(SurfaceContract, TriangleHasTheColorsOfItsBarycentricCoordinates) {
    auto at = session();
    TriangleScene scene(at.gl, at.device.budget);
    scene.draw(at.gl, *at.surface);
    const Bytes pixels = at.pixels();
    constexpr double kBorder = 0.02;  // pixels that an edge may cut are left out
    int inside = 0, outside = 0;
    for (std::uint32_t y = 0; y < kHeight; ++y) {
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const Weights w = weights_at(x, y);
            const double least = std::min({w.a, w.b, w.c});
            const std::vector<int> got = pixel(pixels, x, y);
            if (least > kBorder) {
                ++inside;
                ASSERT_NEAR(got[0], 255 * w.a, 1.5) << x << "," << y;
                ASSERT_NEAR(got[1], 255 * w.b, 1.5) << x << "," << y;
                ASSERT_NEAR(got[2], 255 * w.c, 1.5) << x << "," << y;
            } else if (least < -kBorder) {
                ++outside;
                ASSERT_EQ(got, (std::vector<int>{90, 90, 90, 255})) << x << "," << y;
            }
        }
    }
    EXPECT_GT(inside, 2000);
    EXPECT_GT(outside, 2000);
    EXPECT_EQ(at.gl.take_error(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_EQ(at.gl.denied().total, 0u);
}

TEST_P(SurfaceContract, PresentCompletesTheFrameAndNeedsACurrentSurface) {
    auto at = session();
    at.gl->ClearColor(0, 0, 1, 1);
    at.gl->Clear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(at.surface->present(), base::SurfaceState::ready);
    at.surface->release_current();
    EXPECT_EQ(at.surface->present(), base::SurfaceState::failed);
    ASSERT_TRUE(at.surface->make_current());
}

TEST_P(SurfaceContract, DrawsTheSameAfterReleaseAndReturn) {
    auto at = session();
    TriangleScene scene(at.gl, at.device.budget);
    scene.draw(at.gl, *at.surface);
    const Bytes before = at.pixels();
    at.surface->release_current();
    ASSERT_TRUE(at.surface->make_current());
    scene.draw(at.gl, *at.surface);
    EXPECT_EQ(at.pixels(), before);
}

TEST_P(SurfaceContract, SecondSurfaceIsRefusedUntilTheFirstIsReleased) {
    const auto first = make();
    const platform::SurfaceSettings settings{kWidth, kHeight, platform::ContextLane::es3};
    for (const std::string& backend : test_support::headless_backends()) {
        auto second = platform::make_surface(backend, settings);
        ASSERT_TRUE(second.ok());
        ASSERT_TRUE(first->make_current());
        EXPECT_TRUE(first->make_current()) << "again is no error";
        EXPECT_FALSE(second.value()->make_current());
        second.value()->release_current();  // releases nothing: it is not current
        EXPECT_EQ(first->present(), base::SurfaceState::ready);
        first->release_current();
        EXPECT_TRUE(second.value()->make_current());
        second.value()->release_current();
    }
}

INSTANTIATE_TEST_SUITE_P(Backends, SurfaceContract, testing::ValuesIn(variants()), [](const auto& variant) {
    std::string name = variant.param.backend + "_" + variant.param.device;
    for (char& c : name)
        if (c == '-') c = '_';
    return name;
});

Bytes picture(const std::string& backend, const std::string& device) {
    GlSession at(backend, device, kWidth, kHeight);
    TriangleScene scene(at.gl, at.device.budget);
    scene.draw(at.gl, *at.surface);
    return at.pixels();
}

TEST(SurfaceBackends, GiveIdenticalBitsInBothLanesAndInEitherOrder) {
    const std::vector<std::string> backends = test_support::headless_backends();
    const Bytes reference = picture("egl", "es3-mid");
    EXPECT_EQ(picture("egl", "es2-small"), reference);
    for (const std::string& backend : backends)
        for (const char* device : {"es2-small", "es3-mid"})
            EXPECT_EQ(picture(backend, device), reference) << backend << " " << device;
    for (auto backend = backends.rbegin(); backend != backends.rend(); ++backend)
        EXPECT_EQ(picture(*backend, "es2-small"), reference);
}

TEST(SurfaceBackends, TakeTurnsInOneProcessWithTheirObjectsAlive) {
    const std::vector<std::string> backends = test_support::headless_backends();
    std::vector<std::unique_ptr<GlSession>> sessions;
    std::vector<std::unique_ptr<TriangleScene>> scenes;
    for (const std::string& backend : backends) {
        sessions.push_back(std::make_unique<GlSession>(backend, "es3-mid", kWidth, kHeight));
        scenes.push_back(std::make_unique<TriangleScene>(sessions.back()->gl, sessions.back()->device.budget));
        sessions.back()->surface->release_current();
    }
    const Bytes reference = picture("egl", "es3-mid");
    for (int turn = 0; turn < 4; ++turn) {
        for (std::size_t i = 0; i < sessions.size(); ++i) {
            ASSERT_TRUE(sessions[i]->surface->make_current());
            sessions[i]->gl.activate();
            scenes[i]->draw(sessions[i]->gl, *sessions[i]->surface);
            EXPECT_EQ(sessions[i]->pixels(), reference) << backends[i] << ", turn " << turn;
            sessions[i]->surface->release_current();
        }
    }
}

}  // namespace
}  // namespace tedavis::test_surface_contract
