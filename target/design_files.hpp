/// Resolves the files that a design of the board names. The short name of a palette is a file in the board's folder of
/// palettes, that of a design a file beside the design that names it. Paths are relative to that design's folder.
///
/// Memory  reading allocates (start-up only). Failure  one sentence that names the file.
#pragma once

#include <string_view>

#include "render_core/design/design_source.hpp"
#include "target/board_config.hpp"
#include "target/file_text.hpp"

namespace tedavis::target {

/// Returns the path of a design file; cut() is true where it exceeds the capacity of Path.
[[nodiscard]] Path path_of_design(const base::StatedFile& design);

class DesignFiles final : public design::DesignSource {
public:
    /// `folder` is that of the palettes; it ends in a slash or is empty (the working folder), and must outlive this object.
    explicit DesignFiles(std::string_view folder) : folder_(folder) {}
    [[nodiscard]] base::Result<design::Palette, base::Error> find(const base::StatedFile& palette) override;
    [[nodiscard]] base::Result<design::DesignText, base::Error> find_design(const base::StatedFile& design) override;

private:
    std::string_view folder_;
    Path design_;    ///< of the file read last
    FileText text_;  ///< its content
};

}  // namespace tedavis::target
