/// Which program this is.
#pragma once

namespace tedavis::host_sim {

/// "major.minor.patch"
[[nodiscard]] const char* version();

/// Of the checkout that it was built from: twelve digits, and "+" where files differed from the commit; "unknown" where it was
/// built outside of a git checkout.
[[nodiscard]] const char* commit();

}  // namespace tedavis::host_sim
