#include "render_core/scene/wind.hpp"

#include <cmath>

#include "render_core/earth/geodetic.hpp"

namespace tedavis::scene {

Wind wind_of(double east_mps, double north_mps) noexcept {
    WindMean mean;
    mean.add(east_mps, north_mps);
    return mean.mean();
}

void WindMean::add(double east_mps, double north_mps) noexcept {
    if (!std::isfinite(east_mps) || !std::isfinite(north_mps)) {
        ++left_out_;
        return;
    }
    east_ += east_mps;
    north_ += north_mps;
    speed_ += std::hypot(east_mps, north_mps);
    ++count_;
}

Wind wind_of_means(double east_mps, double north_mps, double speed_mps) noexcept {
    Wind wind;
    wind.speed_mps = speed_mps;
    if (!(speed_mps >= kCalm_mps)) {
        wind.state = WindState::calm;
        return wind;
    }
    wind.constancy = std::fmin(std::hypot(east_mps, north_mps) / speed_mps, 1.0);
    wind.state = wind.constancy >= kMinConstancy ? WindState::steady : WindState::variable;
    if (wind.state == WindState::steady) wind.from_rad = earth::wrap_heading(std::atan2(-east_mps, -north_mps));
    return wind;
}

Wind WindMean::mean() const noexcept {
    if (count_ == 0) return {};
    return wind_of_means(east_ / count_, north_ / count_, speed_ / count_);
}

TrackWind along_track(double east_mps, double north_mps, double track_rad) noexcept {
    const double sine = std::sin(track_rad), cosine = std::cos(track_rad);
    return {-(east_mps * sine + north_mps * cosine), -(east_mps * cosine - north_mps * sine)};
}

}  // namespace tedavis::scene
