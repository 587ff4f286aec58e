/// The EGM96 geoid above the WGS84 ellipsoid, from the 15-minute grid that Debian's proj-data installs.
///
/// File: big-endian GTX: latitude and longitude of the south-west node, steps (degrees, float64), rows, columns
/// (int32), then float32 heights in metres, rows from south to north. Interpolation is bilinear, cyclic in longitude.
#pragma once

#include <string>
#include <vector>

#include "render_core/earth/geodetic.hpp"

namespace tedavis::host_sim {

class GeoidEgm96 {
public:
    /// Throws UserError when the file is missing, truncated or not a global grid.
    explicit GeoidEgm96(const std::string& path);
    /// Reads egm96_15.gtx from the first of these folders that has it: $PROJ_DATA, $PROJ_LIB, /usr/share/proj,
    /// /usr/local/share/proj. Throws UserError where none has.
    [[nodiscard]] static GeoidEgm96 installed();

    [[nodiscard]] earth::GeoidUndulation undulation(double latitude_rad, double longitude_rad) const;

private:
    [[nodiscard]] double node(int row, int column) const;

    double south_deg_ = 0, west_deg_ = 0, latitude_step_deg_ = 0, longitude_step_deg_ = 0;
    int rows_ = 0, columns_ = 0;
    std::vector<float> heights_m_;
};

}  // namespace tedavis::host_sim
