/// The ground below spatial data, as whoever knows the terrain answers for it. Asked on the display's thread.
#pragma once

namespace tedavis::scene {

class Ground {
public:
    virtual ~Ground() = default;
    /// Of the true surface over the ellipsoid, m; NaN where it is not known.
    [[nodiscard]] virtual double height_m(double latitude_rad, double longitude_rad) = 0;
    /// Of the geoid over the ellipsoid, m.
    [[nodiscard]] virtual double undulation_m(double latitude_rad, double longitude_rad) = 0;

protected:
    Ground() = default;
    Ground(const Ground&) = default;
    Ground& operator=(const Ground&) = default;
};

}  // namespace tedavis::scene
