/// Port: the ground below spatial data, provided by the terrain. Called on the display's thread.
#pragma once

namespace tedavis::scene {

class Ground {
public:
    virtual ~Ground() = default;
    /// Returns the height of the true surface above the ellipsoid, m; NaN where it is unknown.
    [[nodiscard]] virtual double height_m(double latitude_rad, double longitude_rad) = 0;
    /// Returns the same of the surface that the frame draws; where that is not known, of the true one.
    [[nodiscard]] virtual double drawn_height_m(double latitude_rad, double longitude_rad) {
        return height_m(latitude_rad, longitude_rad);
    }
    /// Returns the height of the geoid above the ellipsoid, m.
    [[nodiscard]] virtual double undulation_m(double latitude_rad, double longitude_rad) = 0;

protected:
    Ground() = default;
    Ground(const Ground&) = default;
    Ground& operator=(const Ground&) = default;
};

}  // namespace tedavis::scene
