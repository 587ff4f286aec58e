/// Resolves the files that a design of the board names. The short name of a palette is a file in the board's folder of
/// palettes, that of a design a file in the board's folder of designs, or without one beside the design that names it. Paths are
/// relative to that design's folder.
///
/// Memory  reading allocates (start-up only). Failure  one sentence that names the file.
#pragma once

#include <string_view>

#include "platform/files/file_text.hpp"
#include "render_core/design/design_source.hpp"
#include "target/board_config.hpp"

namespace tedavis::target {

/// Folders of files that have short names; each ends in a slash.
struct DesignFolders {
    std::string_view palettes;  ///< empty: the working folder
    std::string_view designs;   ///< empty: none
};

/// Returns the path of a design file; cut() is true where it exceeds the capacity of Path.
[[nodiscard]] Path path_of_design(const base::StatedFile& design, const DesignFolders& folders);

class DesignFiles final : public design::DesignSource {
public:
    /// The texts of `folders` must outlive this object.
    explicit DesignFiles(const DesignFolders& folders) : folders_(folders) {}
    [[nodiscard]] base::Result<design::Palette, base::Error> find(const base::StatedFile& palette) override;
    [[nodiscard]] base::Result<design::DesignText, base::Error> find_design(const base::StatedFile& design) override;

private:
    DesignFolders folders_;
    Path design_;              ///< of the file read last
    platform::FileText text_;  ///< its content
};

}  // namespace tedavis::target
