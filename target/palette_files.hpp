/// The palettes that the board's design names: a short name is a file of the board's folder of palettes, a path is found from the
/// design file's folder.
///
/// Memory  reading allocates (start-up only). Failure  one sentence that names the file.
#pragma once

#include <string_view>

#include "render_core/design/palette.hpp"
#include "target/board_config.hpp"

namespace tedavis::target {

class PaletteFiles final : public design::PaletteSource {
public:
    /// `folder` ends in a slash or is empty (the working folder). Both paths must outlive this object.
    PaletteFiles(std::string_view design_file, std::string_view folder) : design_file_(design_file), folder_(folder) {}
    [[nodiscard]] base::Result<design::Palette, base::Error> find(std::string_view name) override;

private:
    std::string_view design_file_, folder_;
};

}  // namespace tedavis::target
