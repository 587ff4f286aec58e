#include "render_core/draw/drawers/color_table.hpp"

#include <cmath>
#include <cstring>

#include "render_core/draw/drawers/terrain_program.hpp"

namespace tedavis::draw {
namespace {

constexpr std::uint32_t kCodesOfStep = 3, kAlertSteps = ColorTable::kSide / kCodesOfStep;

/// The band that holds at a height: its place from the lowest up, counted from 1; 0 for none.
std::size_t band_at(const TerrainBands& bands, double height_m) {
    std::size_t at = 0;
    for (std::size_t n = 0; n < bands.count; ++n)
        if (static_cast<float>(height_m) >= bands.lower_m[n]) at = n + 1;
    return at;
}

const float* color_of(const TerrainBands& bands, std::size_t band) {
    return band > 0 ? bands.color + std::ptrdiff_t{4} * static_cast<std::ptrdiff_t>(band - 1) : nullptr;
}

/// Of a column of the sky's row.
design::Color sky_at(const design::SkySettings& sky, std::uint32_t column) {
    constexpr std::uint32_t kGround = ColorTable::kGroundAtHorizon, kSky = ColorTable::kSkyAtHorizon, kZenith = 255;
    if (column <= kGround) return design::blended(sky.ground, sky.ground_horizon, column / double{kGround});
    if (column <= kSky) return design::blended(sky.ground_horizon, sky.horizon, (column - kGround) / double{kSky - kGround});
    return design::blended(sky.horizon, sky.zenith, (column - kSky) / double{kZenith - kSky});
}

/// What a column of a height or of the sea says of the alert, and its color where that is not of none.
struct ColumnAlert {
    ColumnAlert(const AlertColors& alert, std::uint32_t column) {
        if (!alert.is_shown || column % kCodesOfStep == 0 || column == ColorTable::kSide - 1) return;
        const design::Color& color = column % kCodesOfStep == 1 ? alert.caution : alert.warning;
        is_any = true;
        rgba[0] = static_cast<float>(color.red) / 255.0f;
        rgba[1] = static_cast<float>(color.green) / 255.0f;
        rgba[2] = static_cast<float>(color.blue) / 255.0f;
        rgba[3] = static_cast<float>(alert.strength);
    }
    bool is_any = false;
    float rgba[4]{};
};

/// `over`: red, green, blue, strength; null for nothing.
void put(std::uint8_t* texel, design::Color color, const float* over) {
    const float rgb[3] = {static_cast<float>(color.red), static_cast<float>(color.green), static_cast<float>(color.blue)};
    for (int c = 0; c < 3; ++c) {
        const float mixed = over != nullptr ? rgb[c] + (255 * over[c] - rgb[c]) * over[3] : rgb[c];
        texel[c] = static_cast<std::uint8_t>(std::lround(mixed));
    }
    texel[3] = 255;
}

/// Whether a row looks the same under both: no band begins inside it under either, and the same one holds.
bool same_in_row(const TerrainBands& a, const TerrainBands& b, const HeightSpan& span, std::uint32_t row) {
    const double low_m = ColorTable::height_m(span, row, 0), high_m = ColorTable::height_m(span, row, ColorTable::kSide - 1);
    const std::size_t band = band_at(a, low_m);
    return band_at(a, high_m) == band && band_at(b, low_m) == band && band_at(b, high_m) == band;
}

bool same_colors(const TerrainBands& a, const TerrainBands& b) {
    return a.count == b.count && std::memcmp(a.color, b.color, a.count * 4 * sizeof(float)) == 0;
}

bool same_colors(const design::SkySettings& a, const design::SkySettings& b) {
    return a.zenith == b.zenith && a.horizon == b.horizon && a.ground == b.ground && a.ground_horizon == b.ground_horizon;
}

bool same_colors(const AlertColors& a, const AlertColors& b) {
    return a.is_shown == b.is_shown && a.warning == b.warning && a.caution == b.caution && a.strength == b.strength;
}

bool same_limits(const TerrainBands& a, const TerrainBands& b) {
    return a.count == b.count && std::memcmp(a.lower_m, b.lower_m, a.count * sizeof(float)) == 0;
}

}  // namespace

double ColorTable::height_m(const HeightSpan& span, std::uint32_t row, std::uint32_t column, bool in_alert) {
    const double reach_m = span.highest_m > span.lowest_m ? span.highest_m - span.lowest_m : 1;
    const std::uint32_t step = column / kCodesOfStep;
    const double of_row = in_alert ? (step + 0.5) / kAlertSteps : column / (kSide - 1.0);
    return span.lowest_m + reach_m * (row + of_row) / kHeightRows;
}

base::Error ColorTable::start(gl::Gl& gl, base::BudgetLine& line) {
    auto texture = gl::make_texture(gl, line, {gl::TextureFormat::rgba8, gl::TextureFilter::nearest, kSide, kSide});
    if (!texture.ok()) return texture.error();
    texture_ = static_cast<gl::Texture&&>(texture.value());
    known_ = false;
    return {};
}

void ColorTable::update(gl::Gl& gl, const design::TerrainSettings& terrain, const HeightSpan& span, const TerrainBands& bands,
                        const design::SkySettings& sky, double haze_per_m, const AlertColors& alert) {
    const bool all = !known_ || !same_colors(alert, alert_) || span.lowest_m != span_.lowest_m ||
                     span.highest_m != span_.highest_m || !same_colors(bands, bands_);
    alert_ = alert;
    if (all || !same_limits(bands, bands_)) {
        for (std::uint32_t row = 0; row < kHeightRows; ++row)
            if (all || !same_in_row(bands_, bands, span, row)) update_heights(gl, terrain, span, bands, row);
        update_sea(gl, terrain, bands);
    }
    if (!known_ || haze_per_m != haze_per_m_ || !same_colors(sky, sky_)) update_sky(gl, sky, haze_per_m);
    known_ = true;
    span_ = span;
    bands_ = bands;
    sky_ = sky;
    haze_per_m_ = haze_per_m;
}

void ColorTable::update_heights(gl::Gl& gl, const design::TerrainSettings& terrain, const HeightSpan& span,
                                const TerrainBands& bands, std::uint32_t row) const {
    const bool tinted = terrain.style.texture == design::TerrainTexture::hypsometric;
    std::uint8_t texels[4 * kSide];
    for (std::uint32_t column = 0; column < kSide; ++column) {
        const double at_m = height_m(span, row, column, alert_.is_shown);
        const ColumnAlert alert(alert_, column);
        put(texels + 4 * column, tinted ? design::color_of_value(terrain.palette, at_m) : terrain.style.plain,
            alert.is_any ? alert.rgba : color_of(bands, band_at(bands, at_m)));
    }
    upload_row(gl, row, texels);
}

void ColorTable::update_sea(gl::Gl& gl, const design::TerrainSettings& terrain, const TerrainBands& bands) const {
    std::uint8_t texels[4 * kSide];
    for (std::uint32_t column = 0; column < kSide; ++column) {
        const ColumnAlert alert(alert_, column);
        put(texels + 4 * column, terrain.sea, alert.is_any ? alert.rgba : color_of(bands, band_at(bands, 0)));
    }
    upload_row(gl, kSeaRow, texels);
}

void ColorTable::update_sky(gl::Gl& gl, const design::SkySettings& sky, double haze_per_m) const {
    std::uint8_t texels[4 * kSide];
    for (std::uint32_t code = 0; code < kSide; ++code) {
        put(texels + 4 * code, sky_at(sky, code), nullptr);
        const double distance_m = kDistanceCodeStart_m * (std::exp2(kDistanceCodeOctaves * code / 255.0) - 1);
        texels[4 * code + 3] = static_cast<std::uint8_t>(std::lround(255 * -std::expm1(-distance_m * haze_per_m)));
    }
    texels[4 * kSide - 1] = 0;  // the sky's own code
    upload_row(gl, kSkyRow, texels);
}

void ColorTable::upload_row(gl::Gl& gl, std::uint32_t row, const std::uint8_t* texels) const {
    TEDAVIS_CHECK(texture_.upload(gl, {0, row, kSide, 1}, texels));
}

}  // namespace tedavis::draw
