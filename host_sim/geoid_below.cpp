#include "host_sim/geoid_below.hpp"

namespace tedavis::host_sim {

earth::GeoidUndulation GeoidBelow::at(double latitude_rad, double longitude_rad) {
    if (database_ != nullptr) return database_->undulation(latitude_rad, longitude_rad);
    if (!grid_) grid_ = GeoidEgm96::installed();
    return grid_->undulation(latitude_rad, longitude_rad);
}

}  // namespace tedavis::host_sim
