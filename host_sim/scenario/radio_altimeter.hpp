/// The reading of a radio altimeter on a generated flight: the height of the wheels above the ground below.
///
/// The ground is that of a raster, bilinear between its posts, except the level strip; from the strip's edges the ground changes
/// linearly to the raster's within 150 m. Metres; the altitude is above mean sea level.
#pragma once

#include <optional>

#include "host_sim/scenario/scenario.hpp"
#include "host_sim/terrain_builder/raster.hpp"

namespace tedavis::host_sim {

class RadioAltimeter {
public:
    /// Reads the raster. Throws UserError where it cannot be read.
    RadioAltimeter(const RadioAltimeterSettings& settings, const LandingStrip& strip);

    /// Returns the height; nothing beyond the range, and where the ground is not known. `wheels_msl_m` is the altitude of the
    /// wheels.
    [[nodiscard]] std::optional<double> height_m(double latitude_rad, double longitude_rad, double wheels_msl_m) const;

private:
    [[nodiscard]] std::optional<double> raster_msl_m(double latitude_rad, double longitude_rad) const;
    [[nodiscard]] double off_strip_m(double latitude_rad, double longitude_rad) const;

    double range_m_;
    LandingStrip strip_;
    Raster raster_;
};

}  // namespace tedavis::host_sim
