// Compiled with -ffp-contract=fast, for a machine with fused instructions.
#include "render_core/raytrace/lanes/scalar_lanes.hpp"
#include "tests/support/contraction/seam_work.hpp"

namespace tedavis::test_support {
namespace {

struct FusedLanes : raytrace::ScalarLanes {};

}  // namespace

SeamsAsCompiled seams_fused() { return {SeamWork<FusedLanes>::edges, SeamWork<FusedLanes>::trace}; }

}  // namespace tedavis::test_support
