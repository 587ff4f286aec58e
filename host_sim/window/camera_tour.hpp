/// A camera that follows a path during the flight, from the file of `--tour`.
///
///     # Comments and blank lines may stand anywhere.
///     time_s,latitude_deg,longitude_deg,altitude_m,heading_deg,pitch_deg,roll_deg
///     0,36.60,-84.25,1500,90,-10,0
///     20,36.60,-84.20,1200,60,-5,0
///
/// The first line names the columns, in this order. `time_s` is seconds since the flight's first frame, strictly ascending; the
/// camera follows the flight's time, so seek, speed and pause apply to both. Degrees; heading true, 0..360 clockwise from north;
/// pitch -90..90, nose up positive; roll -180..180, right wing down positive; `altitude_m` above mean sea level. Values between
/// the points are interpolated smoothly without overshoot; longitude, heading and roll take the shorter way. Before the first and
/// after the last point the camera stands at that point.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "host_sim/importers/monotone_curve.hpp"
#include "host_sim/window/free_camera.hpp"

namespace tedavis::host_sim {

/// Returns the geoid's height above the ellipsoid at a position.
using UndulationAt = std::function<earth::GeoidUndulation(double latitude_rad, double longitude_rad)>;

class CameraTour {
public:
    /// `name` is how the file is called in messages. Throws UserError with file and line.
    CameraTour(std::string_view text, const std::string& name, const UndulationAt& undulation);

    [[nodiscard]] CameraPose at(double time_s) const;

private:
    MonotoneCurve latitude_, longitude_, height_, heading_, pitch_, roll_;
};

}  // namespace tedavis::host_sim
