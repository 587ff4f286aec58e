/// Port: finds the design files that a design names. The core opens no files; the reader of a design passes a source.
#pragma once

#include "render_core/design/palette.hpp"

namespace tedavis::design {

/// A design file's name and content.
struct DesignText {
    std::string_view text, file_name;
};

class DesignSource : public PaletteSource {
public:
    /// Finds a design by its short name or path. Both views stay valid until the next call. The error is one sentence.
    [[nodiscard]] virtual base::Result<DesignText, base::Error> find_design(const base::StatedFile& design) = 0;
};

}  // namespace tedavis::design
