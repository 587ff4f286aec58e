/// Finds the files that a design names. The core opens none: who reads a design hands over a source of them.
#pragma once

#include "render_core/design/palette.hpp"

namespace tedavis::design {

/// A design file and what stands in it.
struct DesignText {
    std::string_view text, file_name;
};

class DesignSource : public PaletteSource {
public:
    /// As a design writes it: the name of a shipped design, or a path. Both views hold until the source is asked again. The error
    /// is one sentence.
    [[nodiscard]] virtual base::Result<DesignText, base::Error> find_design(const base::StatedFile& design) = 0;
};

}  // namespace tedavis::design
