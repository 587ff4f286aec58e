#include "render_core/draw/drawers/shadow_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/solid_mesh.hpp"
#include "render_core/draw/drawers/data/solid_casters.hpp"
#include "render_core/draw/shader_texts.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/effects/device.hpp"
#include "tests/support/display/filled_drawers.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_shadow_map {
namespace {

constexpr std::uint32_t kPixels = 192;
constexpr double kFinestTexel_m = 4000.0 / 1024;
using Real = long double;
using Real3 = glm::vec<3, Real, glm::defaultp>;

const char* const kNames[] = {
    kShadowUniformNames[0], kShadowUniformNames[1], kShadowUniformNames[2], kShadowUniformNames[3], "plane", "plane_height"};
const char* const kPlane =
    "uniform vec4 shadow_axes[3];\nuniform vec3 plane[3];\nuniform float plane_height;\n"
    "void main() {\n"
    "    vec4 place = vec4(plane[0] + plane[1] * uv.x + plane[2] * uv.y, 1.0);\n"
    "    vec3 at = vec3(dot(shadow_axes[0], place), dot(shadow_axes[1], place), dot(shadow_axes[2], place));\n"
    "    FRAGMENT_COLOR = vec4(vec3(shadow_at(at, plane_height)), 1.0);\n}\n";

/// A level place of the Earth by its own formulas (WGS 84), in long double.
struct Spot {
    Real latitude, longitude;

    [[nodiscard]] Real3 east() const { return {-std::sin(longitude), std::cos(longitude), 0}; }
    [[nodiscard]] Real3 north() const {
        return {-std::sin(latitude) * std::cos(longitude), -std::sin(latitude) * std::sin(longitude), std::cos(latitude)};
    }
    [[nodiscard]] Real3 up() const {
        return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
    }
    [[nodiscard]] Real3 foot() const {
        const Real a = 6378137.0L, f = 1 / 298.257223563L, e2 = f * (2 - f);
        const Real n = a / std::sqrt(1 - e2 * std::sin(latitude) * std::sin(latitude));
        return {n * up().x, n * up().y, n * (1 - e2) * up().z};
    }
    [[nodiscard]] Real3 towards(Real azimuth, Real elevation) const {
        return std::cos(elevation) * (std::cos(azimuth) * north() + std::sin(azimuth) * east()) + std::sin(elevation) * up();
    }
};

/// A level plate over a plane, and the plane's shade: white is all of the sun's disc.
class ShadowSession {
public:
    explicit ShadowSession(const Spot& spot, double azimuth_deg, double elevation_deg)
        : spot_(spot), azimuth_(base::radians(azimuth_deg)), elevation_(base::radians(elevation_deg)), block_(1u << 22) {
        base::Arena arena(block_.data(), block_.size());
        base::BudgetTable& budget = session_.device.budget;
        EXPECT_EQ(map_.start(session_.gl, *budget.find(effects::kRenderTargets), 1024).message.view(), "");
        EXPECT_EQ(casters_.start(session_.gl).message.view(), "");
        EXPECT_TRUE(
            solids_
                .start(session_.gl, *budget.find(effects::kSceneSolidVertices), arena, {1024, 3072, 16}, gl::BufferUse::streamed)
                .message.empty());
        EXPECT_TRUE(mesh_.start(arena));
        session_.gl.seal();
        set_eye(0, 0);
    }
    ~ShadowSession() {
        session_.gl.retire();
        triangle_.destroy(session_.gl);
        map_.destroy(session_.gl);
        casters_.destroy(session_.gl);
        solids_.destroy(session_.gl);
    }
    void set_eye(double east_m, double north_m) {
        const glm::dvec3 eye = place(east_m, north_m, 1000);
        view_ = test_support::free_view(eye, earth::body_axes(double(spot_.latitude), double(spot_.longitude), 0, -1.2, 0), 64,
                                        48, 1);
    }
    [[nodiscard]] glm::dvec3 place(double east_m, double north_m, double height_m) const {
        return glm::dvec3(spot_.foot() + Real(east_m) * spot_.east() + Real(north_m) * spot_.north() +
                          Real(height_m) * spot_.up());
    }
    void add_plate(double east_m, double north_m, double height_m, double half_east_m, double half_north_m,
                   std::uint8_t alpha = 255) {
        mesh_.begin(place(east_m, north_m, height_m));
        mesh_.set_color({200, 0, 0, alpha});
        mesh_.quad(place(east_m - half_east_m, north_m - half_north_m, height_m),
                   place(east_m + half_east_m, north_m - half_north_m, height_m),
                   place(east_m + half_east_m, north_m + half_north_m, height_m),
                   place(east_m - half_east_m, north_m + half_north_m, height_m));
        EXPECT_TRUE(mesh_.add_to(solids_.batch()));
    }
    /// Its sides.
    void add_mast(double east_m, double north_m, double height_m, double half_m) {
        mesh_.begin(place(east_m, north_m, 0));
        mesh_.set_color({200, 0, 0});
        const double way[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
        for (int n = 0; n < 4; ++n) {
            const double *a = way[n], *b = way[(n + 1) % 4];
            const auto corner = [&](const double* at, double up_m) {
                return place(east_m + half_m * at[0], north_m + half_m * at[1], up_m);
            };
            mesh_.quad(corner(a, 0), corner(b, 0), corner(b, height_m), corner(a, height_m));
        }
        EXPECT_TRUE(mesh_.add_to(solids_.batch()));
    }
    /// Square of `edge_m` round a place of the plane, west to east and south to north; 0..255.
    const std::vector<std::uint8_t>& shade(double east_m, double north_m, double height_m, double edge_m) {
        frame_ = make_shadow_frame({view_, 1000, azimuth_, elevation_, 1024});
        frame_.on_ground = 1;
        for (const SolidPiece& piece : solids_.batch().pieces())
            add_caster(frame_, {piece.anchor, double{piece.radius_m}, double{piece.top_m}});
        EXPECT_TRUE(solids_.upload(session_.gl));
        const SolidBuffers* const all[] = {&solids_};
        for (std::size_t n = 0; n < kShadowLevels; ++n) {
            map_.begin_level(session_.gl, n);
            casters_.draw(session_.gl, all, {~0u, thin_}, {frame_, n, texel_m(frame_.levels[n], 1024), view_.eye});
        }
        map_.end(session_.gl);
        gl::bind_surface(session_.gl, *session_.surface);
        triangle_.program().use(session_.gl);
        set_shadow_uniforms(session_.gl, triangle_.program(), 0, {&map_.texture(), &frame_, frame_.top_m + 30}, view_.eye);
        const glm::vec3 plane[] = {glm::vec3(place(east_m - edge_m / 2, north_m - edge_m / 2, height_m) - view_.eye),
                                   glm::vec3(place(east_m + edge_m, 0, 0) - place(east_m, 0, 0)),
                                   glm::vec3(place(0, north_m + edge_m, 0) - place(0, north_m, 0))};
        session_.gl->Uniform3fv(triangle_.program().uniform(4), 3, &plane[0].x);
        session_.gl->Uniform1f(triangle_.program().uniform(5), static_cast<float>(height_m));
        triangle_.draw(session_.gl);
        EXPECT_EQ(session_.gl.take_error(), 0u);
        EXPECT_EQ(session_.gl.denied().total, 0u);
        const auto pixels = session_.pixels();
        shade_.clear();
        for (std::size_t n = 0; n < pixels.size(); n += 4) shade_.push_back(pixels[n]);
        return shade_;
    }
    /// Middle of what is shaded, metres from the middle of the square.
    [[nodiscard]] glm::dvec2 middle_of_shade(double edge_m) const {
        glm::dvec3 sum(0);
        for (std::size_t n = 0; n < shade_.size(); ++n)
            sum += double(shade_[n]) * glm::dvec3(double(n % kPixels) + 0.5, double(n / kPixels) + 0.5, 1);
        return (glm::dvec2(sum) / sum.z / double(kPixels) - 0.5) * edge_m;
    }
    /// Where the light through a place over the plane meets it: written anew.
    [[nodiscard]] glm::dvec2 cast(double east_m, double north_m, double height_m) const {
        const Real3 sun = spot_.towards(Real(azimuth_), Real(elevation_));
        const Real way = Real(height_m) / glm::dot(sun, spot_.up());
        return {double(east_m - way * glm::dot(sun, spot_.east())), double(north_m - way * glm::dot(sun, spot_.north()))};
    }

    ShadowFrame frame_;
    std::uint32_t thin_ = 0;

private:
    test_support::GlSession session_{"egl", "es3-mid", kPixels, kPixels};
    test_support::ScreenTriangle triangle_{session_.gl, "#define SHADOWS 1\n" + std::string(shader_text(k_shadow_frag)) + kPlane,
                                           base::Span<const char* const>(kNames)};
    Spot spot_;
    double azimuth_, elevation_;
    std::vector<unsigned char> block_;
    ShadowMap map_;
    SolidCasters casters_;
    test_support::FilledSolids solids_;
    SolidMesh mesh_;
    terrain::View view_;
    std::vector<std::uint8_t> shade_;
};

Spot at(double latitude_deg, double longitude_deg) { return {base::radians(latitude_deg), base::radians(longitude_deg)}; }

TEST(ShadowMap, AShadowLiesWhereTheSunCastsIt) {
    struct Case {
        double latitude_deg, longitude_deg, azimuth_deg, elevation_deg, height_m;
    };
    for (const Case& c : {Case{47, 10, 130, 40, 120}, Case{-33.02, 151.03, 20, 62, 700}, Case{68.98, -51.02, 200, 15, 60},
                          Case{0.01, 179.98, 271, 35, 1500}}) {
        ShadowSession test(at(c.latitude_deg, c.longitude_deg), c.azimuth_deg, c.elevation_deg);
        test.add_plate(30, 200, c.height_m, 25, 25);
        const glm::dvec2 wanted = test.cast(30, 200, c.height_m);
        constexpr double kEdge_m = 300;
        test.shade(wanted.x, wanted.y, 0, kEdge_m);
        const glm::dvec2 off = test.middle_of_shade(kEdge_m);
        // The sun stands as at a knot up to 4 km off: it turns by less than a thousandth.
        const double turned_m = 7e-4 * c.height_m / std::pow(std::sin(base::radians(c.elevation_deg)), 2);
        EXPECT_LT(glm::length(off), 0.5 * kFinestTexel_m / std::sin(base::radians(c.elevation_deg)) + turned_m)
            << c.latitude_deg << ' ' << c.elevation_deg << ": " << off.x << ' ' << off.y;
        const glm::dvec2 elsewhere = test.cast(30, 200, c.height_m + 100);
        EXPECT_GT(glm::distance(elsewhere, wanted), 10) << "control: a height tells";
    }
}

TEST(ShadowMap, AMastsShadowRunsFromItsFootToItsTopAndIsNotBroken) {
    ShadowSession test(at(47, 10), 180, 30);
    test.thin_ = ~0u;
    test.add_mast(100, 300, 100, 0.75);
    const double edge_m = 400;
    const std::vector<std::uint8_t>& shade = test.shade(100, 300, 0, edge_m);
    const auto shaded_at = [&](double north_m) {
        const auto row = static_cast<std::size_t>((north_m / edge_m + 0.5) * kPixels);
        int most = 0;
        for (std::size_t x = 0; x < kPixels; ++x) most = std::max<int>(most, shade[row * kPixels + x]);
        return most;
    };
    const double length_m = 100 / std::tan(base::radians(30));
    for (double north_m = 10; north_m < length_m - 10; north_m += 4) EXPECT_GT(shaded_at(north_m), 20) << north_m;
    EXPECT_EQ(shaded_at(length_m + 15), 0);
    EXPECT_EQ(shaded_at(-15), 0) << "towards the sun";
}

/// Spread of an edge: of the slope of the shade across it.
double spread_m(const std::vector<std::uint8_t>& shade, double edge_m) {
    const std::size_t row = kPixels / 2 * kPixels;
    const double step_m = edge_m / kPixels;
    double sum = 0, first = 0, second = 0;
    for (std::size_t x = 0; x + 1 < kPixels; ++x) {
        const double slope = std::fabs(double(shade[row + x + 1]) - double(shade[row + x])), at_m = double(x + 1) * step_m;
        sum += slope;
        first += slope * at_m;
        second += slope * at_m * at_m;
    }
    return std::sqrt(second / sum - first / sum * (first / sum));
}

TEST(ShadowMap, APenumbraIsAsWideAsTheSunsDiscMakesIt) {
    for (const double height_m : {1500.0, 2500.0, 4500.0, 9000.0}) {
        ShadowSession test(at(47, 10), 90, 89.9);
        test.add_plate(-1500, 0, height_m, 1500, 1500);
        constexpr double kEdge_m = 260;
        const glm::dvec2 edge = test.cast(0, 0, height_m);
        const double measured_m = spread_m(test.shade(edge.x, edge.y, 0, kEdge_m), kEdge_m);
        // A disc of radius r shows an edge over 2 r; the spread of that is r / 2. Texels add their own.
        const double radius_m = kSunRadius_rad * height_m;
        const double texel_m = radius_m > 6 * kFinestTexel_m ? 4 * kFinestTexel_m : kFinestTexel_m;
        EXPECT_NEAR(measured_m, std::hypot(radius_m / 2, texel_m * 0.5), 0.15 * measured_m) << height_m;
    }
}

TEST(ShadowMap, NothingShadesWhatIsNearerToTheSunHoweverLowTheSun) {
    for (const double elevation_deg : {3.2, 20.0, 85.0}) {
        ShadowSession test(at(47.024, 10.024), 100, elevation_deg);  // as far from a knot as places are
        test.add_plate(0, 0, 300, 400, 400);
        // Beyond half a texel.
        for (const double over_m : {3.0, 8.0}) {
            const std::vector<std::uint8_t>& lit = test.shade(0, 0, 300 + over_m, 600);
            for (const std::uint8_t taken : lit) ASSERT_EQ(taken, 0) << elevation_deg << " deg, " << over_m << " m over it";
        }
        const glm::dvec2 below = test.cast(0, 0, 15);
        const std::vector<std::uint8_t>& shade = test.shade(below.x, below.y, 285, 300);
        for (const std::uint8_t taken : shade)
            ASSERT_EQ(taken, 255) << elevation_deg << " deg, 15 m below it, beyond what texels span";
    }
}

TEST(ShadowMap, WhatIsHalfThereTakesHalf) {
    ShadowSession test(at(47, 10), 130, 50);
    test.add_plate(0, 0, 200, 200, 200, 128);
    const glm::dvec2 middle = test.cast(0, 0, 200);
    EXPECT_NEAR(test.shade(middle.x, middle.y, 0, 100)[kPixels * kPixels / 2], 128, 1);
}

/// The world and its sun turned about the Earth's axis.
TEST(ShadowMap, ATurnedWorldHasTheSameShadows) {
    const auto shade_at = [](double longitude_deg) {
        ShadowSession test(at(47.013, longitude_deg), 130, 35);
        test.add_plate(120, 80, 400, 120, 30);
        test.add_plate(-20, 180, 900, 20, 200);
        return test.shade(-200, 500, 0, 1500);
    };
    const std::vector<std::uint8_t> here = shade_at(10.017), there = shade_at(135.017);
    int differing = 0, shaded = 0;
    for (std::size_t n = 0; n < here.size(); ++n) {
        differing += std::abs(here[n] - there[n]) > 3 ? 1 : 0;
        shaded += here[n] > 0 ? 1 : 0;
    }
    EXPECT_GT(shaded, 200);
    EXPECT_LE(differing, shaded / 50);
    EXPECT_NE(here, shade_at(10.018)) << "control: elsewhere texels lie elsewhere";
}

TEST(ShadowMap, NoEdgeCrawlsWhileTheEyeMoves) {
    ShadowSession test(at(47, 10), 130, 35);
    test.add_plate(120, 80, 400, 120, 30);
    const glm::dvec2 middle = test.cast(120, 80, 400);
    const std::vector<std::uint8_t> first = test.shade(middle.x, middle.y, 0, 400);
    for (int n = 1; n <= 8; ++n) {
        test.set_eye(1.37 * n, 2.11 * n);
        const std::vector<std::uint8_t>& moved = test.shade(middle.x, middle.y, 0, 400);
        int differing = 0;
        for (std::size_t k = 0; k < first.size(); ++k) differing += std::abs(first[k] - moved[k]) > 2 ? 1 : 0;
        EXPECT_LT(differing, 20) << n;
    }
}

TEST(ShadowMap, WithoutAMapThereIsNoShadow) {
    ShadowSession test(at(47, 10), 130, 35);
    for (const std::uint8_t taken : test.shade(0, 0, 0, 400)) ASSERT_EQ(taken, 0);
    for (const ShadowLevel& level : test.frame_.levels) EXPECT_FALSE(level.is_used);
}

}  // namespace
}  // namespace tedavis::draw::test_shadow_map
