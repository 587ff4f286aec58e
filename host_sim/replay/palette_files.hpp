/// The palettes that a design names: a short name means a shipped file, a path is found from the design file's folder.
#pragma once

#include <string>
#include <vector>

#include "render_core/design/palette.hpp"

namespace tedavis::host_sim {

/// A file and what was read from it; nothing where it could not be read.
struct ReadFile {
    std::string path, text;
};

class PaletteFiles final : public design::PaletteSource {
public:
    explicit PaletteFiles(std::string design_path) : design_path_(std::move(design_path)) {}

    [[nodiscard]] base::Result<design::Palette, base::Error> find(std::string_view name) override;
    /// Every file that was looked for, as it was.
    [[nodiscard]] const std::vector<ReadFile>& files() const { return files_; }

private:
    std::string design_path_;
    std::vector<ReadFile> files_;
};

/// Throws UserError with file and line.
[[nodiscard]] design::Palette palette_from_text(const std::string& text, const std::string& path);

}  // namespace tedavis::host_sim
