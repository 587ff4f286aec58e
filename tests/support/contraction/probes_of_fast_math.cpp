// Compiled with -ffast-math.
#include "render_core/base/float_probe.hpp"
#include "tests/support/contraction/float_probes.hpp"

namespace tedavis::test_support {

ProbesAsCompiled probes_of_fast_math() { return {base::float_probe::knows_nan, base::float_probe::rounds_products}; }

}  // namespace tedavis::test_support
