/// The files that a design names. A short name is that of a shipped file, or of a file in the folders that a configuration names;
/// a path is relative to the file that contains it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host_sim/options/picture_options.hpp"
#include "render_core/design/design_source.hpp"

namespace tedavis::host_sim {

/// A file and its text; the text is empty where the file could not be read.
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
    /// Every file that was requested, with its text at that time.
    [[nodiscard]] const std::vector<ReadFile>& files() const { return files_; }

private:
    /// Reads a file and adds it to files(), also where it cannot be read; then throws UserError.
    const ReadFile& read(std::string path);

    DesignFolders folders_;
    std::vector<ReadFile> files_;
};

/// Throws UserError with file and line.
[[nodiscard]] design::Palette palette_from_text(const std::string& text, const std::string& path);

}  // namespace tedavis::host_sim
