/// Converts a scene that was read back to a draft, so that layers can be added.
#pragma once

#include "host_sim/scene_builder/scene_draft.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::host_sim {

/// Written by sdb_bytes() it gives the bytes of the file that the scene was read from.
[[nodiscard]] SceneDraft draft_of(const scene::Scene& scene);

}  // namespace tedavis::host_sim
