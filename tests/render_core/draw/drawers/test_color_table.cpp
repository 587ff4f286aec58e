#include "render_core/draw/drawers/color_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "render_core/draw/drawers/terrain_program.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_color_table {
namespace {

constexpr HeightSpan kSpan{200, 3400};
constexpr float kAny_m = 1e9f;

/// A table and a surface of its size to read it back from.
class Table {
public:
    Table() : session_("egl", "es3-mid", ColorTable::kSide, ColorTable::kSide), design_(test_support::shipped_design("default")) {
        design_.terrain.style.texture = design::TerrainTexture::hypsometric;  // natural ground has no table
        EXPECT_EQ(table_.start(session_.gl, *session_.device.budget.find("render_targets")).message.view(), "");
        session_.gl.seal();
    }
    ~Table() {
        session_.gl.retire();
        triangle_.destroy(session_.gl);
        table_.destroy(session_.gl);
    }
    void update(double aircraft_m, double haze_per_m = 0, const HeightSpan& span = kSpan, const AlertColors& alert = {}) {
        session_.gl.begin_frame();
        const TerrainBands bands =
            aircraft_m > 0 ? bands_within(design_.warning_bands, aircraft_m, false, -kAny_m, kAny_m) : TerrainBands();
        table_.update(session_.gl, design_.terrain, span, bands, design_.sky, haze_per_m, alert);
        uploaded_ = session_.gl.frame().uploaded_bytes;
    }
    void forget() { table_.forget(); }
    /// Row by row, RGBA.
    std::vector<std::uint8_t> texels() {
        session_.gl->Disable(GL_BLEND);
        triangle_.copy(session_.gl, table_.texture());
        return session_.pixels();
    }
    [[nodiscard]] design::DesignSettings& design() { return design_; }
    [[nodiscard]] std::uint64_t uploaded() const { return uploaded_; }

private:
    test_support::GlSession session_;
    design::DesignSettings design_;
    ColorTable table_;
    test_support::ScreenTriangle triangle_{session_.gl};
    std::uint64_t uploaded_ = 0;
};

const std::uint8_t* texel(const std::vector<std::uint8_t>& texels, std::uint32_t row, std::uint32_t column) {
    return texels.data() + 4 * (std::size_t{row} * ColorTable::kSide + column);
}

/// The colour that a height has by the design alone: the palette, under the highest band that it reaches.
design::Color expected(const design::DesignSettings& design, double height_m, double aircraft_m) {
    const design::Color tint = design::color_of_value(design.terrain.palette, height_m);
    for (const design::WarningBand& band : design.warning_bands)
        if (height_m >= aircraft_m + band.lower_m) return design::blended(tint, band.color, band.strength);
    return tint;
}

TEST(ColorTable, EveryCodeHasTheColorOfItsHeight) {
    Table table;
    for (const double aircraft_m : {900.0, 2410.3}) {
        table.update(aircraft_m);
        const auto texels = table.texels();
        for (std::uint32_t row = 0; row < ColorTable::kHeightRows; ++row)
            for (std::uint32_t column = 0; column < ColorTable::kSide; column += 5) {
                const double height = 200 + 3200 * (row + column / 255.0) / 254;
                bool at_limit = false;  // of a band, where one float or one double decides
                for (const design::WarningBand& band : table.design().warning_bands)
                    at_limit = at_limit || std::fabs(height - aircraft_m - band.lower_m) < 0.01;
                if (at_limit) continue;
                const design::Color color = expected(table.design(), height, aircraft_m);
                const std::uint8_t* seen = texel(texels, row, column);
                ASSERT_NEAR(seen[0], color.red, 1) << height;
                ASSERT_NEAR(seen[1], color.green, 1) << height;
                ASSERT_NEAR(seen[2], color.blue, 1) << height;
            }
    }
}

/// Three columns a step: with bands, and under each color of the alert in place of them.
TEST(ColorTable, InAnAlertEveryHeightHasItsColorsToo) {
    Table table;
    table.update(900);
    const auto before = table.texels();
    AlertColors alert;
    alert.is_shown = true;
    constexpr double kAircraft_m = 900;
    table.update(kAircraft_m, 0, kSpan, alert);
    const auto texels = table.texels();
    for (std::uint32_t row = 0; row < ColorTable::kHeightRows; row += 3)
        for (std::uint32_t column = 0; column < 255; ++column) {
            const std::uint32_t step = column / 3;
            const double height = 200 + 3200 * (row + (step + 0.5) / 85) / 254;
            bool at_limit = false;
            for (const design::WarningBand& band : table.design().warning_bands)
                at_limit = at_limit || std::fabs(height - kAircraft_m - band.lower_m) < 0.01;
            if (at_limit) continue;
            const design::Color tint = design::color_of_value(table.design().terrain.palette, height);
            const design::Color colors[3] = {expected(table.design(), height, kAircraft_m),
                                             design::blended(tint, alert.caution, alert.strength),
                                             design::blended(tint, alert.warning, alert.strength)};
            const std::uint8_t* seen = texel(texels, row, column);
            ASSERT_NEAR(seen[0], colors[column % 3].red, 1) << height;
            ASSERT_NEAR(seen[1], colors[column % 3].green, 1) << height;
            ASSERT_NEAR(seen[2], colors[column % 3].blue, 1) << height;
        }
    const design::Color sea = design::blended(table.design().terrain.sea, alert.warning, alert.strength);
    EXPECT_NEAR(texel(texels, ColorTable::kSeaRow, 2)[0], sea.red, 1);
    table.update(kAircraft_m);
    EXPECT_EQ(table.texels(), before) << "after it, as before it";
}

TEST(ColorTable, FollowingTheAircraftGivesWhatStartingThereGives) {
    Table table;
    for (double height = 500; height < 3000; height += 83.7) {
        table.update(height, 1e-5);
        const auto followed = table.texels();
        table.forget();
        table.update(height, 1e-5);
        ASSERT_EQ(followed, table.texels()) << height;
    }
}

TEST(ColorTable, OnlyWhatChangedIsUploaded) {
    Table table;
    table.update(1500, 1e-5);
    EXPECT_EQ(table.uploaded(), 256u * 256 * 4);
    table.update(1500, 1e-5);
    EXPECT_EQ(table.uploaded(), 0u);
    table.update(1502, 1e-5);
    EXPECT_GT(table.uploaded(), 0u);
    EXPECT_LT(table.uploaded(), 20u * 256 * 4) << "a few rows round each limit";
    table.update(1502, 2e-5);
    EXPECT_EQ(table.uploaded(), 256u * 4) << "the haze alone";
    table.design().sky.ground.red ^= 255;
    table.update(1502, 2e-5);
    EXPECT_EQ(table.uploaded(), 256u * 4) << "the sky alone";
    EXPECT_EQ(texel(table.texels(), ColorTable::kSkyRow, 0)[0], table.design().sky.ground.red);
    table.forget();
    table.update(1502, 2e-5);
    EXPECT_EQ(table.uploaded(), 256u * 256 * 4);
}

TEST(ColorTable, HazeFollowsTheDistanceCode) {
    Table table;
    table.update(0, 1.0 / 30'000);
    const auto texels = table.texels();
    for (std::uint32_t code = 0; code < 255; ++code) {
        const double distance_m = 50 * (std::pow(2.0, 13.0 * code / 255) - 1);
        EXPECT_NEAR(texel(texels, ColorTable::kSkyRow, code)[3], 255 * (1 - std::exp(-distance_m / 30'000)), 0.51) << code;
    }
    EXPECT_EQ(texel(texels, ColorTable::kSkyRow, 255)[3], 0) << "where nothing was drawn is no haze";
}

TEST(ColorTable, TheSkyRunsFromTheGroundOverTheHorizonToTheZenith) {
    Table table;
    table.update(0, 1e-5);
    const auto texels = table.texels();
    const design::SkySettings& sky = table.design().sky;
    const auto expect = [&](std::uint32_t column, design::Color color) {
        const std::uint8_t* seen = texel(texels, ColorTable::kSkyRow, column);
        EXPECT_NEAR(seen[0], color.red, 1) << column;
        EXPECT_NEAR(seen[1], color.green, 1) << column;
        EXPECT_NEAR(seen[2], color.blue, 1) << column;
    };
    expect(0, sky.ground);
    expect(32, design::blended(sky.ground, sky.ground_horizon, 0.5));
    expect(64, sky.ground_horizon);
    expect(96, design::blended(sky.ground_horizon, sky.horizon, 0.5));
    expect(128, sky.horizon);
    expect(255, sky.zenith);
}

TEST(ColorTable, TheSeaHasItsColorAndItsBand) {
    Table table;
    table.update(0);
    const design::Color sea = table.design().terrain.sea;
    EXPECT_EQ(texel(table.texels(), ColorTable::kSeaRow, 0)[2], sea.blue);
    table.update(100);
    const design::Color warned = [&] {
        for (const design::WarningBand& band : table.design().warning_bands)
            if (0 >= 100 + band.lower_m) return design::blended(sea, band.color, band.strength);
        return sea;
    }();
    EXPECT_NEAR(texel(table.texels(), ColorTable::kSeaRow, 0)[0], warned.red, 1);
    EXPECT_NE(warned.red, sea.red) << "the test would see nothing";
}

TEST(ColorTable, ATerrainAsFlatAsATableStillHasColors) {
    Table table;
    table.update(0, 0, {12, 12});
    const design::Color color = design::color_of_value(table.design().terrain.palette, 12);
    EXPECT_EQ(texel(table.texels(), 0, 0)[1], color.green);
}

}  // namespace
}  // namespace tedavis::draw::test_color_table
