#include "render_core/base/float_environment.hpp"

#include <cfenv>
#include <cmath>
#include <limits>

#include "render_core/base/float_probe.hpp"

namespace tedavis::base {

void set_float_environment() noexcept { static_cast<void>(std::fesetenv(FE_DFL_ENV)); }

FloatFault float_fault() noexcept {
    if (!float_probe::rounds_to_nearest()) return FloatFault::rounding;
    if (!float_probe::reads_denormals()) return FloatFault::denormal_inputs;
    if (!float_probe::keeps_tiny_results()) return FloatFault::tiny_results;
    if (!float_probe::knows_nan()) return FloatFault::nan;
    return float_probe::rounds_products() ? FloatFault::none : FloatFault::fused;
}

std::string_view words_of(FloatFault fault) noexcept {
    constexpr std::string_view kWords[] = {"arithmetic is that of IEEE 754", "results are not rounded to nearest",
                                           "denormal numbers are read as 0", "results below the least normal number become 0",
                                           "NaN is not recognized",          "products are not rounded before they are added"};
    return kWords[static_cast<std::size_t>(fault)];
}

}  // namespace tedavis::base
