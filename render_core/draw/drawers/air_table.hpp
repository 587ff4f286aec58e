/// A table of atmospheric scattering and extinction as a texture, read by programs with shaders/air.frag: by the ray's angle
/// above the horizon and by the distance. All programs of a frame share it.
///
/// Rows are densest at the horizon; columns are at equal ratios of 1 km + distance up to 800 km, the last one for rays that
/// leave the air. Light is scaled so that the sky at the horizon, 90 degrees from the sun, has the design's brightness, and
/// hardly more towards the sun, where symbols must stay visible. The table is computed again when the eye point's height has
/// changed by kHeightStep_m or the sun's elevation by kSunStep_rad, from rounded values, so that a frame does not depend on
/// earlier ones.
///
/// Memory    half floats charged to the line render_targets. Thread  the GL thread. Failure  start(): one sentence.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "render_core/base/memory_budget.hpp"
#include "render_core/design/design_settings.hpp"
#include "render_core/earth/atmosphere.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/texture.hpp"

namespace tedavis::draw {

/// The air of a frame, for the programs. Without a map no air is drawn.
struct AirFrame {
    const gl::Texture* map = nullptr;
    double molecule_light = 0, aerosol_light = 0;                     ///< light of the horizon before phase functions
    glm::dvec3 horizon_molecules{0, 0, 0}, horizon_aerosol{0, 0, 0};  ///< the same by colour, scaled as the table
    glm::dvec3 towards_sun{0, 0, 1}, up{0, 0, 1};                     ///< unit vectors, ECEF
    double dip_rad = 0;                                               ///< of the visible horizon
    double eye_height_m = 0;                                          ///< above the sea
    double share = 1;  ///< 0..1, share of the air's effect; reduced during the transition to the map
};

/// Uniforms of every program that is built with AIR.
inline constexpr std::size_t kAirUniforms = 4;
inline constexpr const char* kAirUniformNames[kAirUniforms] = {"air_map", "air_sun", "air_up", "air_look"};
inline constexpr std::uint32_t kAirUnit = 9;  ///< texture unit; devices with fewer units have no such programs

/// Sets the uniforms; the program must be in use. `first` is the index of kAirUniformNames in its list; the columns of `axes`
/// (ECEF) are the axes of the frame in which the program states its rays.
void set_air_uniforms(gl::Gl& gl, const gl::Program& program, std::size_t first, const AirFrame& air,
                      const glm::dmat3& axes = glm::dmat3(1.0));

class AirTable {
public:
    /// The texture has three blocks of kRows rows: transmittance, light scattered by molecules, light scattered by aerosol.
    static constexpr std::uint32_t kRows = 64, kColumns = 64, kBlocks = 3;
    static constexpr double kHeightStep_m = 8, kSunStep_rad = 0.25 / 57.29577951308232;

    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetLine& line);
    [[nodiscard]] bool is_started() const { return texture_.valid(); }
    void update(gl::Gl& gl, const design::AirSettings& settings, double eye_height_m, double sun_elevation_rad);
    /// Returns the map and its light; the caller fills the other members.
    [[nodiscard]] AirFrame frame() const;
    void destroy(gl::Gl& gl) { texture_.destroy(gl); }

    /// Sine of the elevation that a row stands for, and the distance of a column; the last column has none.
    [[nodiscard]] static double sine_of_row(double row, double dip_rad) noexcept;
    [[nodiscard]] static double distance_of_column_m(double column) noexcept;

private:
    void upload_row(gl::Gl& gl, std::uint32_t row, earth::AirPath way, double scale) const;

    gl::Texture texture_;
    bool is_known_ = false;
    design::AirSettings settings_;
    long long height_step_ = 0, sun_step_ = 0;
    AirFrame light_;  ///< map not set; the light of the computed table
};

/// Returns the IEEE 754 binary16 nearest to a number 0..65504, ties to even.
[[nodiscard]] std::uint16_t half_of(double value) noexcept;

}  // namespace tedavis::draw
