#include "render_core/draw/drawers/geometry_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "render_core/draw/shader_texts.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_geometry_picture {
namespace {

constexpr std::uint32_t kSide = 32, kPixels = kSide * kSide;  // as many pixels as there are numbers, and nothing
constexpr const char* kNumberName[] = {"chunk_number"};
constexpr gl::AttributeBinding kCorners[] = {{"position", 0}};

std::uint32_t bits_of(float value) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

/// A picture of words, and a target of its size.
struct Stage {
    Stage() : at("egl", "es3-mid", kSide, kSide) {
        EXPECT_FALSE(picture.start(at.gl, at.device.budget, kSide, kSide));
        EXPECT_FALSE(screen.start(at.gl, at.device.budget));
        auto built = gl::build_program(
            at.gl, {"white", shader_text(k_terrain_deferred_vert), "void main() { FRAGMENT_COLOR = vec4(1.0); }",
                    base::Span<const gl::AttributeBinding>(kCorners), base::Span<const char* const>(kNumberName), false});
        EXPECT_TRUE(built.ok()) << built.error().message.view();
        white = built.value();
        const gl::TextureSettings texels{gl::TextureFormat::rgba8, gl::TextureFilter::nearest, kSide, kSide};
        target = std::move(
            gl::make_render_target(at.gl, *at.device.budget.find(effects::kRenderTargets), texels, gl::TargetDepth::bits24)
                .value());
        at.gl.seal();
        at.gl.begin_frame();
    }
    ~Stage() {
        at.gl.retire();
        picture.destroy(at.gl);
        screen.destroy(at.gl);
        white.destroy(at.gl);
        target.destroy(at.gl);
    }
    void clear(float depth) {
        target.bind(at.gl);
        at.gl->ClearColor(0, 0, 0, 1);
        at.gl->ClearDepthf(depth);
        at.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        at.gl->ClearDepthf(1);
    }
    [[nodiscard]] std::vector<bool> lit() {
        const std::vector<std::uint8_t> rgba = at.pixels();
        std::vector<bool> lit;
        for (std::size_t n = 0; n < kPixels; ++n) lit.push_back(rgba[4 * n] == 255);
        return lit;
    }

    test_support::GlSession at;
    GeometryPicture picture;
    ScreenTriangle screen;
    gl::Program white;
    gl::RenderTarget target;
};

/// Whatever else their words say.
std::vector<GeometryWords> every_number() {
    std::vector<GeometryWords> words(kPixels);
    for (std::uint32_t n = 0; n < kPixels; ++n) words[n] = {~n, n * 77777u, n << 22u | (n * 2654435761u >> 10u), bits_of(1000)};
    return words;
}

TEST(GeometryPicture, APixelTakesTheColorOfItsOwnChunkAlone) {
    Stage stage;
    gl::Gl& gl = stage.at.gl;
    const std::vector<GeometryWords> words = every_number();
    stage.picture.upload(gl, {words.data(), words.size()});
    for (std::uint32_t number = 1; number <= kMaxGeometrySlots; ++number) {
        stage.clear(1);
        stage.picture.leave_numbers(gl);
        EXPECT_EQ(stage.lit(), std::vector<bool>(kPixels)) << "colours stay";
        gl->Enable(GL_DEPTH_TEST);
        gl->DepthFunc(GL_EQUAL);
        stage.white.use(gl);
        gl->Uniform1f(stage.white.uniform(0), static_cast<float>(number));
        stage.screen.draw(gl);
        gl->DepthFunc(GL_LESS);
        std::vector<bool> expected(kPixels);
        expected[number] = true;
        ASSERT_EQ(stage.lit(), expected) << number;
    }
    EXPECT_EQ(gl.denied().total, 0u);
}

TEST(GeometryPicture, DepthsAreThoseOfTheRange) {
    Stage stage;
    gl::Gl& gl = stage.at.gl;
    const DepthRange range{100, 50'000};
    std::vector<GeometryWords> words(kPixels);
    std::vector<double> depths_m;
    for (std::uint32_t n = 0; n < kPixels; ++n) {
        depths_m.push_back(20 * std::pow(1.01, n));  // 20 m to 526 km
        words[n] = {0, 0, (n % 5 == 0 ? 0u : 1u) << 22u, bits_of(static_cast<float>(depths_m[n]))};
    }
    stage.picture.upload(gl, {words.data(), words.size()});
    for (const double plane_m : {150.0, 1500.0, 30'000.0, 50'000.0}) {
        stage.clear(static_cast<float>(range.far_m * (plane_m - range.near_m) / ((range.far_m - range.near_m) * plane_m)));
        gl->Enable(GL_DEPTH_TEST);
        stage.picture.leave_depths(gl, range);
        const std::vector<bool> lit = stage.lit();
        for (std::uint32_t n = 0; n < kPixels; ++n) {
            if (std::abs(depths_m[n] / plane_m - 1) < 1e-3) continue;
            EXPECT_EQ(lit[n], n % 5 != 0 && depths_m[n] < plane_m) << depths_m[n] << " before " << plane_m;
        }
    }
}

}  // namespace
}  // namespace tedavis::draw::test_geometry_picture
