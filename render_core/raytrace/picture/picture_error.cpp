#include "render_core/raytrace/picture/picture_error.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::raytrace {

double picture_error(base::Span<const glm::vec3> light, base::Span<const glm::vec3> best) {
    TEDAVIS_CHECK(light.size() == best.size());
    double sum = 0;
    for (std::size_t n = 0; n < light.size(); ++n)
        for (int c = 0; c < 3; ++c) {
            const double off = double{std::min(light.data()[n][c], 1.0f)} - double{std::min(best.data()[n][c], 1.0f)};
            sum += off * off;
        }
    return light.empty() ? 0 : std::sqrt(sum / (3.0 * static_cast<double>(light.size())));
}

}  // namespace tedavis::raytrace
