#include "render_core/draw/drawers/air_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <string>

#include "render_core/base/units.hpp"
#include "render_core/draw/shader_texts.hpp"
#include "render_core/draw/view_frame.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_air_table {
namespace {

using test_support::GlSession;

constexpr std::uint32_t kWidth = 64, kHeight = 48;
constexpr glm::dvec3 kGround{0.5, 0.35, 0.2};

double distance_of(double right) { return 100 * std::pow(4000.0, right); }  // 100 m .. 400 km
double elevation_of(double up) { return base::radians(-12 + 18 * up); }

/// Every pixel a ray and a distance of its own, square to the sun.
std::string program_of(const std::string& air) {
    return "#define AIR 1\n" + std::string(shader_text(k_air_frag)) + std::string(shader_text(k_fine_distance_frag)) +
           "void main() {\n"
           "    float elevation = radians(-12.0 + 18.0 * uv.y), distance_m = 100.0 * exp2(uv.x * 11.9657843);\n"
           "    vec3 ray = vec3(cos(elevation), 0.0, sin(elevation)), ground = vec3(0.5, 0.35, 0.2);\n    " +
           air + "}\n";
}
const char* const kThroughAir = "FRAGMENT_COLOR = vec4(through_air(ground, ray, distance_m), 1.0);\n";
/// The ground and its distance in four bytes of an off-screen picture first.
const char* const kThroughPicture =
    "float half_air;\n"
    "    vec4 texel = floor(255.0 * with_fine_distance(ground, distance_m, 0.0) + 0.5) / 255.0;\n"
    "    vec4 read = color_and_distance(texel, half_air);\n"
    "    FRAGMENT_COLOR = vec4(through_air(read.rgb, ray, read.a), 1.0);\n";
/// How far the distance that was read is off, in steps of 0.01 %; the colour in steps of a tenth of 1/255; what was said of the
/// air.
const char* const kReadBack =
    "float half_air, said = step(0.5, fract(gl_FragCoord.x * 0.5));\n"
    "    ground = fract(vec3(3.0, 5.0, 7.0) * (uv.x + uv.y));\n"
    "    vec4 texel = floor(255.0 * with_fine_distance(ground, distance_m, said) + 0.5) / 255.0;\n"
    "    vec4 read = color_and_distance(texel, half_air);\n"
    "    vec3 off = abs(read.rgb - ground) * 255.0;\n"
    "    FRAGMENT_COLOR = vec4(abs(read.a / distance_m - 1.0) * 10000.0, max(max(off.r, off.g), off.b) * 10.0,\n"
    "                          255.0 * abs(half_air - said), through_air(ground, ray, distance_m).r) / 255.0;\n";

struct Scene {
    double eye_height_m, sun_elevation_rad;
    design::AirSettings settings;
};

/// The same by places in space, with the sun's own direction at each of them and 1500 steps.
glm::dvec3 color_of(const Scene& scene, double elevation_rad, double distance_m, double scale) {
    const earth::Air air = earth::air_of_visibility(scene.settings.visibility_m);
    const glm::dvec3 eye(0, 0, earth::kMeanRadius_m + scene.eye_height_m);
    const glm::dvec3 ray(std::cos(elevation_rad), 0, std::sin(elevation_rad));
    const glm::dvec3 sun(0, std::cos(scene.sun_elevation_rad), std::sin(scene.sun_elevation_rad));
    const auto depth = [&](double molecules_m, double aerosol_m) {
        return air.molecules_per_m * molecules_m + air.aerosol_per_m / earth::kAerosolAlbedo * aerosol_m;
    };
    const auto densities = [&](const glm::dvec3& place) {
        const double height_m = glm::length(place) - earth::kMeanRadius_m;
        return glm::dvec2(std::exp(-height_m / air.molecules_height_m), std::exp(-height_m / air.aerosol_height_m));
    };
    glm::dvec2 column(0, 0);
    glm::dvec3 light(0, 0, 0);
    constexpr int kSteps = 1500, kSunSteps = 150;
    for (int n = 0; n < kSteps; ++n) {
        const double step_m = distance_m / kSteps;
        const glm::dvec3 place = eye + ray * (step_m * (n + 0.5));
        const glm::dvec2 here = densities(place) * step_m;
        glm::dvec2 to_sun(0, 0);
        const double way_m = 300'000;
        for (int m = 0; m < kSunSteps; ++m) {
            const double from = way_m * m * m / (kSunSteps * kSunSteps), to = way_m * (m + 1) * (m + 1) / (kSunSteps * kSunSteps);
            to_sun += densities(place + sun * (0.5 * (from + to))) * (to - from);
        }
        const glm::dvec3 left = glm::exp(-depth(column.x + 0.5 * here.x, column.y + 0.5 * here.y) - depth(to_sun.x, to_sun.y));
        light += left *
                 (here.x * air.molecules_per_m * earth::molecule_phase(0) + here.y * air.aerosol_per_m * earth::aerosol_phase(0));
        column += here;
    }
    const glm::dvec3 root = glm::sqrt(kGround * kGround * glm::exp(-depth(column.x, column.y)) + scale * light);
    return 255.0 * glm::min(root, glm::dvec3(1));
}

/// Of light, so that the horizon square to the sun has the wanted brightness. Nothing of the ground is left over so far.
double scale_by_horizon(const Scene& scene) {
    const double out_m = 2 * std::sqrt(2 * earth::kMeanRadius_m * 100'000.0);
    const glm::dvec3 root = color_of(scene, -horizon_dip_rad(scene.eye_height_m), out_m, 0.01) / 255.0;
    const double wanted = scene.settings.horizon_brightness * scene.settings.horizon_brightness;
    return 0.01 * wanted / glm::dot(root * root, glm::dvec3(0.2126, 0.7152, 0.0722));
}

class AirPicture : public ::testing::Test {
protected:
    void draw(const Scene& scene, double share = 1) { draw(triangle_, scene, share); }
    void draw(const test_support::ScreenTriangle& triangle, const Scene& scene, double share = 1) {
        table_.update(session_.gl, scene.settings, scene.eye_height_m, scene.sun_elevation_rad);
        AirFrame air = table_.frame();
        air.towards_sun = {0, std::cos(scene.sun_elevation_rad), std::sin(scene.sun_elevation_rad)};
        air.up = {0, 0, 1};
        air.dip_rad = horizon_dip_rad(scene.eye_height_m);
        air.share = share;
        gl::bind_surface(session_.gl, *session_.surface);
        triangle.program().use(session_.gl);
        set_air_uniforms(session_.gl, triangle.program(), 0, air);
        triangle.draw(session_.gl);
        pixels_ = session_.pixels();
    }
    void SetUp() override {
        ASSERT_EQ(table_.start(session_.gl, *session_.device.budget.find(effects::kRenderTargets)).message.view(), "");
    }
    void TearDown() override {
        table_.destroy(session_.gl);
        for (test_support::ScreenTriangle* triangle : {&triangle_, &by_picture_, &read_back_}) triangle->destroy(session_.gl);
    }
    /// Of what was drawn to the same with 1500 steps, over all rays that end above the sea.
    [[nodiscard]] double worst_step(const Scene& scene) const {
        const double scale = scale_by_horizon(scene);
        double worst = 0;
        for (std::uint32_t y = 0; y < kHeight; y += 3)
            for (std::uint32_t x = 1; x < kWidth; x += 9) {
                const double distance_m = distance_of((x + 0.5) / kWidth), elevation = elevation_of((y + 0.5) / kHeight);
                const double end_m = std::hypot(distance_m * std::cos(elevation),
                                                earth::kMeanRadius_m + scene.eye_height_m + distance_m * std::sin(elevation)) -
                                     earth::kMeanRadius_m;
                if (end_m < 0) continue;  // below the sea
                const glm::dvec3 wanted = color_of(scene, elevation, distance_m, scale);
                for (int band = 0; band < 3; ++band)
                    worst = std::max(worst, std::fabs(wanted[band] - static_cast<double>(pixel(x, y)[band])));
            }
        return worst;
    }
    [[nodiscard]] const std::uint8_t* pixel(std::uint32_t x, std::uint32_t y) const {
        return pixels_.data() + (std::size_t{y} * kWidth + x) * 4;
    }

    GlSession session_{"egl", "es3-mid", kWidth, kHeight};
    test_support::ScreenTriangle triangle_{session_.gl, program_of(kThroughAir), kAirUniformNames};
    test_support::ScreenTriangle by_picture_{session_.gl, program_of(kThroughPicture), kAirUniformNames};
    test_support::ScreenTriangle read_back_{session_.gl, program_of(kReadBack), kAirUniformNames};
    AirTable table_;
    std::vector<std::uint8_t> pixels_;
};

const Scene kScenes[] = {{3000, base::radians(40), {}}, {11'000, base::radians(15), {true, 80'000, 0.75}}};

TEST_F(AirPicture, IsThatOfManySteps) {
    for (const Scene& scene : kScenes) {
        draw(scene);
        EXPECT_LT(worst_step(scene), 2.5) << "of 255 steps, at " << scene.eye_height_m << " m";
        draw(by_picture_, scene);
        EXPECT_LT(worst_step(scene), 3.5) << "by way of a picture, at " << scene.eye_height_m << " m";
    }
}

/// As a picture off-screen has them: distances to half a percent, colours to one step.
TEST_F(AirPicture, DistancesAndColorsAreReadBack) {
    draw(read_back_, kScenes[0]);
    int distance = 0, color = 0;
    for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t x = 0; x + 1 < kWidth; ++x) {  // the last column lies beyond the last code
            distance = std::max(distance, int{pixel(x, y)[0]});
            color = std::max(color, int{pixel(x, y)[1]});
            ASSERT_EQ(pixel(x, y)[2], 0) << x << ", " << y;
        }
    EXPECT_LE(distance, 75) << "in 0.01 %: at 100 m half of it is the 50 m that the code begins at";
    EXPECT_GE(distance, 30) << "there are steps";
    EXPECT_LE(color, 11);
    EXPECT_GE(color, 5);
}

TEST_F(AirPicture, NoShareIsNoAir) {
    draw({3000, base::radians(40), {}}, 0);
    for (std::uint32_t x = 0; x < kWidth; ++x) {
        EXPECT_NEAR(pixel(x, 20)[0], 127.5, 0.6);
        EXPECT_NEAR(pixel(x, 20)[2], 51, 0.6);
    }
}

TEST_F(AirPicture, FarGroundIsPalerAndBluerAndNearGroundIsAsItIs) {
    draw({3000, base::radians(40), {}});
    const std::uint8_t *near = pixel(0, 20), *far = pixel(kWidth - 8, 32);
    EXPECT_NEAR(near[0], 127.5, 4);
    EXPECT_GT(far[2] - far[0], near[2] - near[0] + 60);
}

/// The table is made by rounded values: small changes leave every pixel, and a step is not seen.
TEST_F(AirPicture, StepsOfTheTableAreNotSeen) {
    const Scene scene{3001, base::radians(40), {}};
    draw(scene);
    const auto before = pixels_;
    const std::uint64_t uploaded = session_.gl.frame().uploaded_bytes;
    draw({3003.9, base::radians(40.05), {}});
    EXPECT_EQ(session_.gl.frame().uploaded_bytes, uploaded) << "nothing is computed again";
    draw({3001 + AirTable::kHeightStep_m, base::radians(40), {}});
    EXPECT_GT(session_.gl.frame().uploaded_bytes, uploaded);
    for (std::size_t n = 0; n < before.size(); ++n) EXPECT_NEAR(before[n], pixels_[n], 2) << n;
    draw({6000, base::radians(40), {}});
    EXPECT_NE(before, pixels_);
}

TEST(AirTable, RowsAndColumnsHaveTheirPlaces) {
    EXPECT_NEAR(AirTable::distance_of_column_m(0), 0, 1e-9);
    EXPECT_NEAR(AirTable::distance_of_column_m(62), 800'000, 100);
    EXPECT_NEAR(AirTable::sine_of_row(31.5, 0.02), -std::sin(0.02), 1e-12) << "the horizon";
    EXPECT_EQ(AirTable::sine_of_row(63, 0), 1);
    EXPECT_EQ(AirTable::sine_of_row(0, 0), -1);
}

TEST(AirTable, HalvesAreTheNearest) {
    EXPECT_EQ(half_of(0), 0);
    EXPECT_EQ(half_of(-1), 0);
    EXPECT_EQ(half_of(1), 0x3C00);
    EXPECT_EQ(half_of(0.5), 0x3800);
    EXPECT_EQ(half_of(65504), 0x7BFF);
    EXPECT_EQ(half_of(1e9), 0x7BFF);
    EXPECT_EQ(half_of(5.9604644775390625e-8), 1);
    EXPECT_EQ(half_of(6.103515625e-5), 0x0400);
    EXPECT_EQ(half_of(1 + 1.0 / 2048), 0x3C00) << "a tie goes to the even one";
    EXPECT_EQ(half_of(1 + 3.0 / 2048), 0x3C02);
    EXPECT_EQ(half_of(1.9999), 0x4000) << "carries into the exponent";
}

}  // namespace
}  // namespace tedavis::draw::test_air_table
