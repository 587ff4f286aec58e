#include "tests/support/files/paths.hpp"

namespace tedavis::test_support {

std::string source_dir() { return TEDAVIS_SOURCE_DIR; }
std::string binary_dir() { return TEDAVIS_BINARY_DIR; }
std::string real_data_dir() { return TEDAVIS_REAL_DATA; }

}  // namespace tedavis::test_support
