#include "host_sim/time_left.hpp"

#include <cmath>
#include <cstdio>

namespace tedavis::host_sim {

std::string time_left(double elapsed_s, double share_done) {
    constexpr double kTooEarly_s = 2, kLongest_s = 1e7;
    if (!(elapsed_s >= kTooEarly_s) || !(share_done > 0)) return {};
    const double left_s = elapsed_s * std::fmax(0, 1 - share_done) / share_done;
    if (!(left_s < kLongest_s)) return {};
    const int seconds = static_cast<int>(std::ceil(left_s)), minutes = (seconds + 59) / 60;
    char text[40];
    if (seconds <= 90) {
        std::snprintf(text, sizeof text, "%d s left", seconds);
    } else if (minutes < 60) {
        std::snprintf(text, sizeof text, "%d min left", minutes);
    } else {
        std::snprintf(text, sizeof text, "%d h %02d min left", minutes / 60, minutes % 60);
    }
    return text;
}

}  // namespace tedavis::host_sim
