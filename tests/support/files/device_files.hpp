/// The shipped device and design files, as the tests need them.
#pragma once

#include <string>

#include "render_core/design/design_settings.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::test_support {

/// The content of a file of the source tree; stops the test program when it is not there.
[[nodiscard]] std::string source_file(const std::string& path_from_root);

/// `name` as in configs/devices/NAME.toml; stops the test program with the reader's sentence when it does not load.
[[nodiscard]] effects::DeviceSettings shipped_device(const std::string& name);

/// Finds palettes as configs/palettes/NAME.toml, and bases as configs/designs/NAME.toml or from the design's folder; a fault
/// becomes the design's.
class ShippedFiles final : public design::DesignSource {
public:
    [[nodiscard]] base::Result<design::Palette, base::Error> find(const base::StatedFile& palette) override;
    [[nodiscard]] base::Result<design::DesignText, base::Error> find_design(const base::StatedFile& design) override;

private:
    std::string path_, text_;
};
/// As above, configs/designs/NAME.toml and the palettes that it names.
[[nodiscard]] design::DesignSettings shipped_design(const std::string& name);

}  // namespace tedavis::test_support
