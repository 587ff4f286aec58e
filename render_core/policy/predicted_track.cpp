#include "render_core/policy/predicted_track.hpp"

namespace tedavis::policy {

earth::Geodetic PredictedTrack::at(double seconds, double right_m) const {
    const double speed_mps = ground_speed_mps();
    const double aside_s = speed_mps > 0 ? right_m / speed_mps : 0;  // the track, turned to its right
    const double north_m = north_mps * seconds - east_mps * aside_s, east_m = east_mps * seconds + north_mps * aside_s;
    return {from.latitude_rad + north_m / metres_per_latitude_rad(),
            from.longitude_rad + east_m / metres_per_longitude_rad(),
            {from.height.m + up_mps * seconds}};
}

}  // namespace tedavis::policy
