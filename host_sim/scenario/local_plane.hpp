/// A local plane in metres around a place, for data that a scenario generates near its strip: east and north are divided by the
/// ellipsoid's radii of curvature there, as for grids and the display's moving cells. For tens of kilometres, not hundreds.
#pragma once

namespace tedavis::host_sim {

struct PlanePlace {
    double latitude_rad = 0, longitude_rad = 0;  ///< [-pi, pi)
};

class LocalPlane {
public:
    LocalPlane(double latitude_rad, double longitude_rad);

    [[nodiscard]] PlanePlace at(double east_m, double north_m) const;
    /// Radians per metre.
    [[nodiscard]] double longitude_per_m() const { return longitude_per_m_; }
    [[nodiscard]] double latitude_per_m() const { return latitude_per_m_; }

private:
    double latitude_rad_, longitude_rad_, longitude_per_m_, latitude_per_m_;
};

}  // namespace tedavis::host_sim
