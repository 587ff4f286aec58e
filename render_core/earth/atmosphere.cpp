#include "render_core/earth/atmosphere.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::earth {
namespace {

constexpr double kLowest_m = -500;
constexpr double kThickest = 80;  // of optical depths: exp() stays a normal number in every format
/// Places of Gauss's rule with two points, in a step from 0 to 1.
constexpr double kGauss[2] = {0.21132486540518712, 0.78867513459481288};

/// Height above the sphere on a ray, without the difference of two large numbers.
double height_on_ray(double eye_height_m, double sine, double length_m) {
    const double r = kMeanRadius_m + eye_height_m;
    const double rise = length_m * (length_m + 2 * r * sine);
    return eye_height_m + rise / (r + std::sqrt(std::fmax(r * r + rise, 0)));
}

double density(double height_m, double scale_m) { return std::exp(-std::fmax(height_m, kLowest_m) / scale_m); }

glm::dvec3 depth_of(const Air& air, double molecules_m, double aerosol_m) {
    return glm::min(air.molecules_per_m * molecules_m + air.aerosol_per_m / kAerosolAlbedo * aerosol_m, glm::dvec3(kThickest));
}

double height_of_row(std::size_t row, std::size_t rows) {
    const double part = static_cast<double>(row) / static_cast<double>(rows - 1);
    return kLowest_m + (kAirEnds_m - kLowest_m) * part * part;
}

}  // namespace

Air air_of_visibility(double visibility_m) noexcept {
    constexpr double kKoschmieder = 3.912;
    Air air;
    const double extinction = kKoschmieder / visibility_m;
    air.aerosol_per_m = kAerosolAlbedo * std::fmax(extinction - air.molecules_per_m.y, 0);
    return air;
}

SunThroughAir::SunThroughAir(const Air& air, double sun_elevation_rad) noexcept {
    const double sine = std::sin(sun_elevation_rad);
    constexpr int kSteps = 96;
    for (std::size_t row = 0; row < kHeights; ++row) {
        const double height_m = height_of_row(row, kHeights);
        const double r = kMeanRadius_m + height_m, end = kMeanRadius_m + kAirEnds_m;
        const double way_m = -r * sine + std::sqrt(std::fmax(r * r * (sine * sine - 1) + end * end, 0));
        double molecules_m = 0, aerosol_m = 0;
        // Steps that grow with the square of the way: the air is thick where it begins.
        for (int step = 0; step < kSteps; ++step) {
            const double from = way_m * step * step / (kSteps * kSteps), to = way_m * (step + 1) * (step + 1) / (kSteps * kSteps);
            for (const double place : kGauss) {
                const double at = height_on_ray(height_m, sine, from + (to - from) * place);
                molecules_m += 0.5 * (to - from) * density(at, air.molecules_height_m);
                aerosol_m += 0.5 * (to - from) * density(at, air.aerosol_height_m);
            }
        }
        depths_[row] = depth_of(air, molecules_m, aerosol_m);
    }
}

glm::dvec3 SunThroughAir::at(double height_m) const noexcept {
    const double part = std::clamp((height_m - kLowest_m) / (kAirEnds_m - kLowest_m), 0.0, 1.0);
    const double row = std::sqrt(part) * static_cast<double>(kHeights - 1);
    const auto below = std::min(static_cast<std::size_t>(row), kHeights - 2);
    return glm::exp(-glm::mix(depths_[below], depths_[below + 1], row - static_cast<double>(below)));
}

AirPath::AirPath(const Air& air, const SunThroughAir& sun, double eye_height_m, double sine) noexcept
    : air_(air), sun_(sun), eye_height_m_(eye_height_m), sine_(sine) {}

double AirPath::height_at(double length_m) const noexcept { return height_on_ray(eye_height_m_, sine_, length_m); }

void AirPath::add(double from_m, double to_m) noexcept {
    const double half_m = 0.5 * (to_m - from_m);
    for (const double place : kGauss) {
        const double height_m = height_at(from_m + (to_m - from_m) * place);
        const double molecules = density(height_m, air_.molecules_height_m);
        const double aerosol = density(height_m, air_.aerosol_height_m);
        // Half of this place's own air lies before it.
        const glm::dvec3 left =
            glm::exp(-depth_of(air_, molecules_m_ + 0.5 * half_m * molecules, aerosol_m_ + 0.5 * half_m * aerosol));
        const glm::dvec3 lit = left * sun_.at(height_m) * half_m;
        by_molecules_ += lit * molecules * air_.molecules_per_m;
        by_aerosol_ += lit * aerosol * air_.aerosol_per_m;
        molecules_m_ += half_m * molecules;
        aerosol_m_ += half_m * aerosol;
    }
}

void AirPath::walk_to(double length_m, int steps) noexcept {
    const double from_m = length_m_, step_m = (length_m - length_m_) / steps;
    for (int step = 0; step < steps; ++step) add(from_m + step * step_m, from_m + (step + 1) * step_m);
    length_m_ = length_m;
}

double AirPath::length_in_air_m() const noexcept {
    const double r = kMeanRadius_m + eye_height_m_, end = kMeanRadius_m + kAirEnds_m;
    return -r * sine_ + std::sqrt(std::fmax(r * r * (sine_ * sine_ - 1) + end * end, 0));
}

void AirPath::walk_out(int steps) noexcept {
    const double out_m = length_in_air_m();
    if (out_m > length_m_) walk_to(out_m, steps);
}

AirLight AirPath::light() const noexcept {
    return {glm::exp(-depth_of(air_, molecules_m_, aerosol_m_)), by_molecules_, by_aerosol_};
}

double molecule_phase(double cosine) noexcept { return 3 / (16 * base::kPi) * (1 + cosine * cosine); }

double aerosol_phase(double cosine) noexcept {
    constexpr double g = kAerosolAsymmetry;
    const double away = 1 + g * g - 2 * g * cosine;
    return 3 / (8 * base::kPi) * (1 - g * g) * (1 + cosine * cosine) / ((2 + g * g) * away * std::sqrt(away));
}

}  // namespace tedavis::earth
