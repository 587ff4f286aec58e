/// The files that a design of the board names: the short name of a palette is a file of the board's folder of palettes, that of a
/// design a file beside the design that names it; paths are found from that design's folder.
///
/// Memory  reading allocates (start-up only). Failure  one sentence that names the file.
#pragma once

#include <string_view>

#include "render_core/design/design_source.hpp"
#include "target/board_config.hpp"
#include "target/file_text.hpp"

namespace tedavis::target {

/// Longer than a Path can be: cut() says so.
[[nodiscard]] Path path_of_design(const base::StatedFile& design);

class DesignFiles final : public design::DesignSource {
public:
    /// `folder`, of the palettes, ends in a slash or is empty (the working folder); it must outlive this object.
    explicit DesignFiles(std::string_view folder) : folder_(folder) {}
    [[nodiscard]] base::Result<design::Palette, base::Error> find(const base::StatedFile& palette) override;
    [[nodiscard]] base::Result<design::DesignText, base::Error> find_design(const base::StatedFile& design) override;

private:
    std::string_view folder_;
    Path design_;    ///< found last
    FileText text_;  ///< of it
};

}  // namespace tedavis::target
