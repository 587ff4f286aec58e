// Compiled with -ffp-contract=fast, for a machine with fused instructions.
#include "render_core/base/float_probe.hpp"
#include "tests/support/contraction/float_probes.hpp"

namespace tedavis::test_support {

ProbesAsCompiled probes_fused() { return {base::float_probe::knows_nan, base::float_probe::rounds_products}; }

}  // namespace tedavis::test_support
