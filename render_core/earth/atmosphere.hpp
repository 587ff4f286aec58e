/// What air does to light on its way to the eye: extinction and single scattering by molecules and aerosol, on a round Earth.
///
/// Molecules after Rayleigh, aerosol after Mie with one direction of scattering (Nishita et al., "Display of the Earth Taking
/// into Account Atmospheric Scattering", SIGGRAPH 1993; Bruneton, Neyret, "Precomputed Atmospheric Scattering", EGSR 2008,
/// section 2). Densities fall exponentially with the height above a sphere. No refraction, no second scattering; the sun stands
/// at one angle over the whole way. Colours are three bands, linear: 680, 550 and 440 nm.
///
/// Pure. SI and radians. Thread  any. Memory  none.
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace tedavis::earth {

/// At sea level, per metre; heights over which densities fall to 1/e.
struct Air {
    glm::dvec3 molecules_per_m{5.8e-6, 13.5e-6, 33.1e-6};
    double molecules_height_m = 8000;
    double aerosol_per_m = 5.7e-5;  ///< scattered; 0.9 of what it takes away
    double aerosol_height_m = 1200;
};
inline constexpr double kAerosolAlbedo = 0.9;
inline constexpr double kAirEnds_m = 100'000;  ///< above there is none

/// Air in which contrast falls to 2 % over the visibility (1 km .. 290 km; more is limited by the molecules alone), after
/// Koschmieder.
[[nodiscard]] Air air_of_visibility(double visibility_m) noexcept;

/// Light on its way along a ray, from each point of it to the eye.
struct AirLight {
    glm::dvec3 transmittance{1, 1, 1};  ///< 0..1: what is left of a light at the end
    glm::dvec3 by_molecules{0, 0, 0};   ///< scattered in, parts of the sun's irradiance, before the phase function
    glm::dvec3 by_aerosol{0, 0, 0};
};

/// Share of sunlight that is left at a height, by the sun's elevation; tabulated by height.
class SunThroughAir {
public:
    SunThroughAir(const Air& air, double sun_elevation_rad) noexcept;
    [[nodiscard]] glm::dvec3 at(double height_m) const noexcept;

private:
    static constexpr std::size_t kHeights = 64;
    std::array<glm::dvec3, kHeights> depths_{};  ///< by the root of the height
};

/// A way from the eye along a straight ray, walked in steps of the caller's choice.
class AirWay {
public:
    /// `sine`: of the ray's elevation above the eye's horizontal plane, -1..1. `eye_height_m` -500 .. 99,000.
    AirWay(const Air& air, const SunThroughAir& sun, double eye_height_m, double sine) noexcept;
    /// Walks on to `length_m` from the eye in `steps` equal steps (two places of each, Gauss).
    void walk_to(double length_m, int steps) noexcept;
    /// To where the air ends, or the same length again for a ray that ends on the ground.
    void walk_out(int steps) noexcept;
    [[nodiscard]] AirLight light() const noexcept;
    /// Over which the ray leaves the air; for rays into the ground the far side of the Earth.
    [[nodiscard]] double length_in_air_m() const noexcept;

private:
    void add(double from_m, double to_m) noexcept;
    [[nodiscard]] double height_at(double length_m) const noexcept;

    const Air& air_;
    const SunThroughAir& sun_;
    double eye_height_m_, sine_;
    double length_m_ = 0;
    double molecules_m_ = 0, aerosol_m_ = 0;  ///< columns so far: metres of air as at sea level
    glm::dvec3 by_molecules_{0, 0, 0}, by_aerosol_{0, 0, 0};
};

/// Phase functions, per steradian, by the cosine of the angle between the ray and the way to the sun. Their mean over the sphere
/// is 1 / 4 pi.
[[nodiscard]] double molecule_phase(double cosine) noexcept;
[[nodiscard]] double aerosol_phase(double cosine) noexcept;
/// Of the aerosol: Cornette, Shanks 1992.
inline constexpr double kAerosolAsymmetry = 0.76;

}  // namespace tedavis::earth
