/// Writes a scene database. Equal drafts give equal bytes.
#pragma once

#include <string>
#include <vector>

#include "host_sim/scene_builder/scene_draft.hpp"

namespace tedavis::host_sim {

/// Returns the bytes of a .sdb. Throws UserError where there are too many layers, attributes or classes, or a text does not fit
/// its field; the message begins with the layer's name.
[[nodiscard]] std::vector<std::uint8_t> sdb_bytes(const SceneDraft& draft);

}  // namespace tedavis::host_sim
