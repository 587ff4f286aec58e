/// The probes of render_core/base/float_environment.hpp as compilers make them that may break the rules: the control that the
/// probes would see it.
#pragma once

namespace tedavis::test_support {

struct ProbesAsCompiled {
    bool (*knows_nan)();
    bool (*rounds_products)();
};

ProbesAsCompiled probes_of_fast_math();
/// `rounds_products` must not be called where the machine has no fused instructions (seams.hpp).
ProbesAsCompiled probes_fused();

}  // namespace tedavis::test_support
