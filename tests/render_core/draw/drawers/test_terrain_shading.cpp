// Ground that rays met is shaded in the scissored part of the picture in which each chunk may be seen.
#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "host_sim/scenario/posed_aircraft.hpp"
#include "tests/support/display/drawn_pixels.hpp"
#include "tests/support/flights/default_flight.hpp"
#include "tests/support/terrain/built_database.hpp"

namespace tedavis::draw::test_terrain_shading {
namespace {

constexpr std::uint32_t kWidth = 320, kHeight = 240;

const test_support::BuiltDatabase& rough() {
    static const test_support::BuiltDatabase built(test_support::make_rough_raster(161, 161));
    return built;
}

/// The shipped style, which codes cannot tell.
design::DesignSettings design_by(design::TerrainRenderer renderer) {
    design::DesignSettings design = test_support::shipped_design("default");
    design.terrain.renderer = renderer;
    design.terrain.tau_px = 0.1;
    return design;
}

class Renderer {
public:
    explicit Renderer(design::TerrainRenderer renderer)
        : bytes_(rough().image),
          headless_("egl", test_support::shipped_device("es3-mid"), kWidth, kHeight, &bytes_, design_by(renderer)) {}
    [[nodiscard]] std::vector<std::uint8_t> picture(const host_sim::AircraftPose& pose) {
        const flight::AircraftState aircraft = host_sim::posed_aircraft(pose, headless_.display());
        return test_support::settled_pixels(headless_, aircraft, host_sim::kPosedTime);
    }
    [[nodiscard]] std::string_view renderer() { return headless_.display().record().terrain.renderer.view(); }

private:
    test_support::MemoryBytes bytes_;
    test_support::HeadlessDisplay headless_;
};

constexpr std::size_t kPoses = 12;
host_sim::AircraftPose pose_at(std::size_t n) {
    const double altitude_m = n % 2 == 0 ? 1300 : 3000, pitch_deg = n % 3 == 0 ? -3 : n % 3 == 1 ? -20 : -60;
    return {47.03, 9.66, altitude_m, 30.0 * static_cast<double>(n), pitch_deg, n % 4 == 3 ? 40.0 : 0.0};
}

std::vector<std::vector<std::uint8_t>> pictures(design::TerrainRenderer renderer, std::string_view name) {
    Renderer drawn(renderer);
    std::vector<std::vector<std::uint8_t>> all;
    for (std::size_t n = 0; n < kPoses; ++n) {
        all.push_back(drawn.picture(pose_at(n)));
        EXPECT_EQ(drawn.renderer(), name);
    }
    return all;
}

double share_apart(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    std::size_t apart = 0;
    for (std::size_t n = 0; n < a.size(); n += 4) {
        bool differs = false;
        for (std::size_t c = n; c < n + 3; ++c) differs = differs || std::abs(int{a[c]} - int{b[c]}) > 12;
        apart += differs ? 1 : 0;
    }
    return static_cast<double>(apart) / (0.25 * static_cast<double>(a.size()));
}

/// Round the compass, low and high, level, steep and banked: chunks lie across every edge of the picture and behind the eye.
TEST(TerrainShading, NoPartOfAnyChunkIsLeftOut) {
    const auto traced = pictures(design::TerrainRenderer::trace, "trace"),
               drawn = pictures(design::TerrainRenderer::raster, "raster");
    for (std::size_t n = 0; n < kPoses; ++n) EXPECT_LT(share_apart(traced[n], drawn[n]), 0.02) << n;
    EXPECT_GT(share_apart(traced[0], drawn[1]), 0.3) << "a control: another pose";
}

}  // namespace
}  // namespace tedavis::draw::test_terrain_shading
