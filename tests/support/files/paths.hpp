/// Where the tests find files: the source tree, the build folder, and the recordings and rasters of the label `real`. Absolute,
/// without a slash at the end. They stand in one source, so that no other one compiles differently in another clone.
#pragma once

#include <string>

namespace tedavis::test_support {

[[nodiscard]] std::string source_dir();
[[nodiscard]] std::string binary_dir();
[[nodiscard]] std::string real_data_dir();

}  // namespace tedavis::test_support
