/// Inheritance of designs: a design that is based on another only contains what differs.
///
///     based_on = "default"        a name of configs/designs, or a path from this file
///     [[data.element]]
///     name = "wind"               the base's element of this name, with another size
///     size_m = 1200
///
/// Keys that the file does not have are inherited from its base, whose own base may follow, up to kMaxBases designs. Tables are
/// merged key by key, arrays of tables by the names of the tables (base::ConfigReader::inherit). `name` and [phases] are not
/// inherited.
#pragma once

#include <cstddef>
#include <string_view>

#include "render_core/base/config_reader.hpp"
#include "render_core/design/design_source.hpp"

namespace tedavis::design {

inline constexpr std::size_t kMaxBases = 8;  ///< longest chain of bases

/// Adds the keys of a design's bases to its reader. A base that is missing, a cycle, and too long a chain are faults at the
/// line that names the base. Start-up only (allocates).
void inherit_bases(base::ConfigReader& reader, DesignSource& files);

}  // namespace tedavis::design
