#include "render_core/draw/drawers/air_table.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render_core/base/check.hpp"
#include "render_core/base/units.hpp"
#include "render_core/draw/view_frame.hpp"

namespace tedavis::draw {
namespace {

constexpr double kFirst_m = 1000, kOctaves = 9.6456;  // to 800 km
constexpr int kStepsOut = 48;
constexpr glm::dvec3 kLuminance{0.2126, 0.7152, 0.0722};

/// Light of the sky at the horizon before phase functions.
struct HorizonLight {
    glm::dvec3 by_molecules, by_aerosol;
    double molecules, aerosol;  ///< luminances, in parts of that square to the sun
    double square;              ///< by what the parts are divided
};

HorizonLight horizon_light(const earth::Air& air, const earth::SunThroughAir& sun, double eye_height_m) {
    earth::AirPath level(air, sun, eye_height_m, -std::sin(horizon_dip_rad(eye_height_m)));
    level.walk_to(50'000, 32);
    level.walk_out(128);
    const earth::AirLight light = level.light();
    const double molecules = glm::dot(light.by_molecules, kLuminance), aerosol = glm::dot(light.by_aerosol, kLuminance);
    const double square = std::fmax(molecules * earth::molecule_phase(0) + aerosol * earth::aerosol_phase(0), 1e-12);
    return {light.by_molecules, light.by_aerosol, molecules / square, aerosol / square, square};
}

}  // namespace

std::uint16_t half_of(double value) noexcept {
    constexpr double kLargest = 65504, kSmallestNormal = 6.103515625e-5, kSmallestStep = 5.9604644775390625e-8;
    if (!(value > 0)) return 0;
    if (value >= kLargest) return 0x7BFF;
    // nearbyint: ties to even, as the rounding mode is never changed.
    if (value < kSmallestNormal) return static_cast<std::uint16_t>(std::nearbyint(value / kSmallestStep));
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);  // 0.5 .. 1
    const double steps = std::nearbyint(mantissa * 2048);  // 1024 .. 2048; 2048 carries into the exponent
    return static_cast<std::uint16_t>((exponent + 13) * 1024 + static_cast<int>(steps));
}

double AirTable::sine_of_row(double row, double dip_rad) noexcept {
    const double root = (row - 0.5 * (kRows - 1)) / (0.5 * (kRows - 1));
    return std::clamp(root * std::fabs(root) - std::sin(dip_rad), -1.0, 1.0);
}

double AirTable::distance_of_column_m(double column) noexcept {
    return kFirst_m * (std::exp2(column / (kColumns - 2.0) * kOctaves) - 1);
}

base::Error AirTable::start(gl::Gl& gl, base::BudgetLine& line) {
    auto made = gl::make_texture(gl, line, {gl::TextureFormat::rgba16f, gl::TextureFilter::linear, kColumns, kRows * kBlocks});
    if (!made.ok()) return made.error();
    texture_ = static_cast<gl::Texture&&>(made.value());
    return {};
}

void AirTable::update(gl::Gl& gl, const design::AirSettings& settings, double eye_height_m, double sun_elevation_rad) {
    const long long height_step = std::llround(std::clamp(eye_height_m, -500.0, 90'000.0) / kHeightStep_m);
    const long long sun_step = std::llround(sun_elevation_rad / kSunStep_rad);
    if (is_known_ && height_step == height_step_ && sun_step == sun_step_ && settings.visibility_m == settings_.visibility_m &&
        settings.horizon_brightness == settings_.horizon_brightness)
        return;
    const double height_m = static_cast<double>(height_step) * kHeightStep_m;
    const double dip_rad = horizon_dip_rad(height_m);
    const earth::Air air = earth::air_of_visibility(settings.visibility_m);
    const earth::SunThroughAir sun(air, static_cast<double>(sun_step) * kSunStep_rad);
    const HorizonLight horizon = horizon_light(air, sun, height_m);
    // Brightness is a root of light.
    const double scale = settings.horizon_brightness * settings.horizon_brightness / horizon.square;
    light_.molecule_light = horizon.molecules;
    light_.aerosol_light = horizon.aerosol;
    light_.horizon_molecules = scale * horizon.by_molecules;
    light_.horizon_aerosol = scale * horizon.by_aerosol;
    for (std::uint32_t row = 0; row < kRows; ++row)
        upload_row(gl, row, earth::AirPath(air, sun, height_m, sine_of_row(row, dip_rad)), scale);
    is_known_ = true;
    settings_ = settings;
    height_step_ = height_step;
    sun_step_ = sun_step;
}

AirFrame AirTable::frame() const {
    AirFrame frame = light_;
    frame.map = &texture_;
    return frame;
}

void AirTable::upload_row(gl::Gl& gl, std::uint32_t row, earth::AirPath way, double scale) const {
    std::uint16_t texels[kBlocks][kColumns][4];
    for (std::uint32_t column = 0; column < kColumns; ++column) {
        if (column + 1 < kColumns)
            way.walk_to(distance_of_column_m(column), 1);
        else
            way.walk_out(kStepsOut);
        const earth::AirLight light = way.light();
        const glm::dvec3 blocks[kBlocks] = {light.transmittance, scale * light.by_molecules, scale * light.by_aerosol};
        for (std::uint32_t block = 0; block < kBlocks; ++block) {
            for (int band = 0; band < 3; ++band) texels[block][column][band] = half_of(blocks[block][band]);
            texels[block][column][3] = 0;
        }
    }
    for (std::uint32_t block = 0; block < kBlocks; ++block)
        TEDAVIS_CHECK(texture_.upload(gl, {0, block * kRows + row, kColumns, 1}, texels[block]));
}

void set_air_uniforms(gl::Gl& gl, const gl::Program& program, std::size_t first, const AirFrame& air, const glm::dmat3& axes) {
    if (air.map != nullptr) air.map->bind(gl, kAirUnit);
    const glm::vec3 sun(glm::transpose(axes) * air.towards_sun), up(glm::transpose(axes) * air.up);
    gl->Uniform1i(program.uniform(first), static_cast<GLint>(kAirUnit));
    gl->Uniform4f(program.uniform(first + 1), sun.x, sun.y, sun.z, static_cast<float>(air.eye_height_m));
    gl->Uniform4f(program.uniform(first + 2), up.x, up.y, up.z, static_cast<float>(std::sin(air.dip_rad)));
    gl->Uniform3f(program.uniform(first + 3), air.map != nullptr ? static_cast<float>(air.share) : 0.0f,
                  static_cast<float>(air.molecule_light), static_cast<float>(air.aerosol_light));
}

}  // namespace tedavis::draw
