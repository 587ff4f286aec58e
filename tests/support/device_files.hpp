/// The shipped device files, as the tests need them.
#pragma once

#include <string>

#include "render_core/effects/device.hpp"

namespace tedavis::test_support {

/// The content of a file of the source tree; stops the test program when it is not there.
[[nodiscard]] std::string source_file(const std::string& path_from_root);

/// `name` as in configs/devices/NAME.toml; stops the test program with the reader's sentence when it does not load.
[[nodiscard]] effects::DeviceSettings shipped_device(const std::string& name);

}  // namespace tedavis::test_support
