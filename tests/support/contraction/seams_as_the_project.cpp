#include "render_core/raytrace/lanes/scalar_lanes.hpp"
#include "tests/support/contraction/seam_work.hpp"

namespace tedavis::test_support {
namespace {

struct ProjectLanes : raytrace::ScalarLanes {};

}  // namespace

SeamsAsCompiled seams_as_the_project() { return {SeamWork<ProjectLanes>::edges, SeamWork<ProjectLanes>::trace}; }

bool has_fused_instructions() {
#if defined(__x86_64__)
    return __builtin_cpu_supports("fma") != 0;
#else
    return true;
#endif
}

}  // namespace tedavis::test_support
