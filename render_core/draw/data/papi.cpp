#include "render_core/draw/data/papi.hpp"

#include <cmath>

namespace tedavis::draw {
namespace {

constexpr double kFromPath_deg[kPapiLights] = {0.5, 1.0 / 6, -1.0 / 6, -0.5};

}  // namespace

PapiLights papi_lights(double angle_deg, double path_deg) {
    PapiLights lights{};
    for (std::size_t n = 0; n < kPapiLights; ++n) lights[n] = angle_deg > path_deg + kFromPath_deg[n];
    return lights;
}

bool is_papi_seen(double before_m, double aside_m) {
    return before_m > 0 && std::hypot(before_m, aside_m) <= kPapiReach_m &&
           std::fabs(aside_m) <= before_m * std::tan(base::radians(kPapiAzimuth_deg));
}

}  // namespace tedavis::draw
