/// A recorded flight straight east across the terrain of flown_circle.hpp (9.6 .. 9.76 E, 46.94 .. 47.1 N), which begins before
/// it and ends beyond it: an IGC file with a fix each second.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace tedavis::test_support {

struct FlownAcross {
    static constexpr double kWest_deg = 9.55, kFullTurn_rad = 6.283185307179586;
    double latitude_deg = 47.04;
    int seconds = 80;
    double step_deg = 0.0032;  ///< of longitude, each second

    /// When it comes over this meridian, in seconds since its first fix.
    [[nodiscard]] double time_at(double longitude_deg) const { return (longitude_deg - kWest_deg) / step_deg; }

    [[nodiscard]] std::string igc() const { return igc_meandering(0, 1); }

    /// To both sides of the parallel, so far, and back in each so many seconds; it begins to the north.
    [[nodiscard]] std::string igc_meandering(double side_deg, double turn_s) const {
        std::string text = "AXXX001\r\nHFDTE120420\r\nHFDTM100GPSDATUM:WGS-1984\r\n";
        for (int s = 0; s <= seconds; ++s) {
            char line[80];
            std::snprintf(line, sizeof line, "B12%02d%02d%sN%sEA0300003000\r\n", s / 60, s % 60,
                          minutes(latitude_deg + side_deg * std::sin(kFullTurn_rad * s / turn_s), 2).c_str(),
                          minutes(kWest_deg + step_deg * s, 3).c_str());
            text += line;
        }
        return text;
    }

private:
    /// "4702400": degrees, then thousandths of minutes.
    static std::string minutes(double degrees, int digits) {
        const long thousandths = std::lround(degrees * 60000);
        char text[40];
        std::snprintf(text, sizeof text, "%0*ld%05ld", digits, thousandths / 60000, thousandths % 60000);
        return text;
    }
};

}  // namespace tedavis::test_support
