#include "host_sim/importers/local_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tedavis::host_sim {
namespace {

struct Parabola {
    double value = 0, slope = 0;
};

/// Normal equations of y = a + b t + c t^2 about the centre, times scaled to [-1, 1] for their condition. The centre
/// value is subtracted first, so that large offsets (a longitude, an altitude) cost no digits.
Parabola fit_around(const std::vector<double>& times, const std::vector<double>& values, std::size_t centre, std::size_t first,
                    std::size_t last) {
    const double scale = std::max(times[centre] - times[first], times[last] - times[centre]);
    std::array<double, 5> moments{};
    std::array<double, 3> sums{};
    for (std::size_t i = first; i <= last; ++i) {
        const double t = (times[i] - times[centre]) / scale, y = values[i] - values[centre];
        double power = 1;
        for (std::size_t k = 0; k < 5; ++k, power *= t) {
            moments[k] += power;
            if (k < 3) sums[k] += power * y;
        }
    }
    const double m0 = moments[0], m1 = moments[1], m2 = moments[2], m3 = moments[3], m4 = moments[4];
    const double determinant = m0 * (m2 * m4 - m3 * m3) - m1 * (m1 * m4 - m2 * m3) + m2 * (m1 * m3 - m2 * m2);
    const double a = sums[0] * (m2 * m4 - m3 * m3) - m1 * (sums[1] * m4 - m3 * sums[2]) + m2 * (sums[1] * m3 - m2 * sums[2]);
    const double b = m0 * (sums[1] * m4 - m3 * sums[2]) - sums[0] * (m1 * m4 - m2 * m3) + m2 * (m1 * sums[2] - m2 * sums[1]);
    return {values[centre] + a / determinant, b / determinant / scale};
}

}  // namespace

FittedSeries fit_locally(const std::vector<double>& times_s, const std::vector<double>& values, double half_window_s) {
    const std::size_t count = times_s.size();
    FittedSeries fitted{values, std::vector<double>(count, 0.0)};
    if (count == 2) {
        const double slope = (values[1] - values[0]) / (times_s[1] - times_s[0]);
        fitted.slopes = {slope, slope};
    }
    if (count < 3) return fitted;
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t first = i == 0 ? 0 : i - 1, last = std::min(i + 1, count - 1);
        if (i == 0) last = 2;
        if (i == count - 1) first = count - 3;
        while (first > 0 && times_s[i] - times_s[first - 1] <= half_window_s) --first;
        while (last + 1 < count && times_s[last + 1] - times_s[i] <= half_window_s) ++last;
        const Parabola parabola = fit_around(times_s, values, i, first, last);
        fitted.values[i] = parabola.value;
        fitted.slopes[i] = parabola.slope;
    }
    return fitted;
}

}  // namespace tedavis::host_sim
