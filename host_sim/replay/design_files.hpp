/// The files that a design names: a short name means a shipped file, or one in the folders that a configuration names; a path is
/// found from the folder of the file that says it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host_sim/options/picture_options.hpp"
#include "render_core/design/design_source.hpp"

namespace tedavis::host_sim {

/// A file and what was read from it; nothing where it could not be read.
struct ReadFile {
    std::string path, text;
};

/// Paths of the files that names stand for. Throws UserError for a short name that no shipped file has.
[[nodiscard]] std::string named_palette(const base::StatedFile& palette, const DesignFolders& folders);
[[nodiscard]] std::string named_design(const base::StatedFile& design, const DesignFolders& folders);

class DesignFiles final : public design::DesignSource {
public:
    explicit DesignFiles(DesignFolders folders = {}) : folders_(std::move(folders)) {}
    [[nodiscard]] base::Result<design::Palette, base::Error> find(const base::StatedFile& palette) override;
    [[nodiscard]] base::Result<design::DesignText, base::Error> find_design(const base::StatedFile& design) override;
    /// Every file that was looked for, as it was.
    [[nodiscard]] const std::vector<ReadFile>& files() const { return files_; }

private:
    /// Throws UserError where there is none, which files() remembers, too.
    const ReadFile& read(std::string path);

    DesignFolders folders_;
    std::vector<ReadFile> files_;
};

/// Throws UserError with file and line.
[[nodiscard]] design::Palette palette_from_text(const std::string& text, const std::string& path);

}  // namespace tedavis::host_sim
