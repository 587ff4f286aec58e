/// Port: how high the ground is at most, provided by the terrain. Called on the display's thread.
#pragma once

namespace tedavis::policy {

class GroundBound {
public:
    virtual ~GroundBound() = default;
    /// Returns an upper bound of the true surface's height above the ellipsoid, m, within `radius_m` of a place; -infinity where
    /// no ground is known there. Where all ground is below `floor_m`, any number below that will do.
    [[nodiscard]] virtual double highest_m(double latitude_rad, double longitude_rad, double radius_m, double floor_m) = 0;

protected:
    GroundBound() = default;
    GroundBound(const GroundBound&) = default;
    GroundBound& operator=(const GroundBound&) = default;
};

}  // namespace tedavis::policy
