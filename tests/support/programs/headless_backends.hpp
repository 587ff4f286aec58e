/// Backends of this build that need no screen.
#pragma once

#include <string>
#include <vector>

namespace tedavis::test_support {

[[nodiscard]] inline std::vector<std::string> headless_backends() {
#if defined(TEDAVIS_HAVE_OSMESA)
    return {"egl", "osmesa"};
#else
    return {"egl"};
#endif
}

}  // namespace tedavis::test_support
