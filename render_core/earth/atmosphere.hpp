/// Extinction and single scattering of light by air molecules and aerosol on its path to the eye point, over a spherical Earth.
///
/// Molecules scatter after Rayleigh, aerosol after Mie with a fixed asymmetry (Nishita et al., "Display of the Earth Taking
/// into Account Atmospheric Scattering", SIGGRAPH 1993; Bruneton, Neyret, "Precomputed Atmospheric Scattering", EGSR 2008,
/// section 2). Densities fall exponentially with height above a sphere. Refraction and multiple scattering are neglected, and
/// the sun has the same elevation along the whole ray. Colours are three linear bands: 680, 550 and 440 nm.
///
/// Pure. SI and radians. Thread  any. Memory  none.
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace tedavis::earth {

/// Scattering coefficients at sea level, per metre, and scale heights over which densities fall to 1/e.
struct Air {
    glm::dvec3 molecules_per_m{5.8e-6, 13.5e-6, 33.1e-6};
    double molecules_height_m = 8000;
    double aerosol_per_m = 5.7e-5;  ///< scattering; 0.9 of the aerosol's extinction
    double aerosol_height_m = 1200;
};
inline constexpr double kAerosolAlbedo = 0.9;
inline constexpr double kAirEnds_m = 100'000;  ///< upper end of the atmosphere

/// Returns air in which contrast falls to 2 % over the visibility, after Koschmieder. Range 1 km .. 290 km; beyond that the
/// molecules alone limit the visibility.
[[nodiscard]] Air air_of_visibility(double visibility_m) noexcept;

/// Accumulated effect of the air between a point of a ray and the eye point.
struct AirLight {
    glm::dvec3 transmittance{1, 1, 1};  ///< 0..1: the share of light from the ray's end that arrives
    glm::dvec3 by_molecules{0, 0, 0};   ///< in-scattered light as a share of the sun's irradiance, before the phase function
    glm::dvec3 by_aerosol{0, 0, 0};
};

/// Share of sunlight that reaches a height, for one elevation of the sun; tabulated by height.
class SunThroughAir {
public:
    SunThroughAir(const Air& air, double sun_elevation_rad) noexcept;
    [[nodiscard]] glm::dvec3 at(double height_m) const noexcept;

private:
    static constexpr std::size_t kHeights = 64;
    std::array<glm::dvec3, kHeights> depths_{};  ///< indexed by the square root of the height
};

/// Integrates along a straight ray from the eye point, in steps that the caller chooses.
class AirPath {
public:
    /// `sine` is that of the ray's elevation above the horizontal plane at the eye point, -1..1; `eye_height_m` is -500 ..
    /// 99,000.
    AirPath(const Air& air, const SunThroughAir& sun, double eye_height_m, double sine) noexcept;
    /// Integrates on to `length_m` from the eye point in `steps` equal steps (Gauss, two points each).
    void walk_to(double length_m, int steps) noexcept;
    /// Integrates on to the end of the atmosphere, or over the same length again for a ray that ends on the ground.
    void walk_out(int steps) noexcept;
    [[nodiscard]] AirLight light() const noexcept;
    /// Distance at which the ray leaves the atmosphere; rays into the ground leave it on the far side of the Earth.
    [[nodiscard]] double length_in_air_m() const noexcept;

private:
    void add(double from_m, double to_m) noexcept;
    [[nodiscard]] double height_at(double length_m) const noexcept;

    const Air& air_;
    const SunThroughAir& sun_;
    double eye_height_m_, sine_;
    double length_m_ = 0;
    double molecules_m_ = 0, aerosol_m_ = 0;  ///< columns so far, in metres of air at sea-level density
    glm::dvec3 by_molecules_{0, 0, 0}, by_aerosol_{0, 0, 0};
};

/// Phase functions, per steradian, by the cosine of the angle between the ray and the direction to the sun. Their mean over the
/// sphere is 1 / 4 pi.
[[nodiscard]] double molecule_phase(double cosine) noexcept;
[[nodiscard]] double aerosol_phase(double cosine) noexcept;
/// Asymmetry of the aerosol's phase function (Cornette, Shanks 1992).
inline constexpr double kAerosolAsymmetry = 0.76;

}  // namespace tedavis::earth
