/// A design that is based on another says only what is its own.
///
///     based_on = "default"        a name of configs/designs, or a path from this file
///     [[data.element]]
///     name = "wind"               the base's element of this name, with another size
///     size_m = 1200
///
/// What the file does not say is its base's, and so on, at most kMaxBases designs far: tables key by key, lists of tables by the
/// names of the tables (base::ConfigReader::inherit). `name` and [phases] are each design's own.
#pragma once

#include <cstddef>
#include <string_view>

#include "render_core/base/config_reader.hpp"
#include "render_core/design/design_source.hpp"

namespace tedavis::design {

inline constexpr std::size_t kMaxBases = 8;  ///< behind one another

/// Adds to the reader of a design what its bases say. A base that is missing, that is based on this design, or that is one too
/// many is a fault at the line that names it. Start-up only (allocates).
void inherit_bases(base::ConfigReader& reader, DesignSource& files);

}  // namespace tedavis::design
