/// Paths that a configuration file names.
#pragma once

#include <string_view>

#include "render_core/base/fixed_string.hpp"

namespace tedavis::platform {

using Path = base::FixedString<1023>;

/// Returns the path of `name` relative to the folder of `file`; an absolute name is returned unchanged. cut() is true where the
/// path exceeds the capacity of Path.
[[nodiscard]] Path path_beside(std::string_view file, std::string_view name);

}  // namespace tedavis::platform
