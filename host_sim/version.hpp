/// Version and commit of the program.
#pragma once

namespace tedavis::host_sim {

/// "major.minor.patch"
[[nodiscard]] const char* version();

/// The commit of the checkout from which it was built: twelve digits, and "+" where files differed from the commit; "unknown"
/// where it was built outside of a git checkout.
[[nodiscard]] const char* commit();

}  // namespace tedavis::host_sim
