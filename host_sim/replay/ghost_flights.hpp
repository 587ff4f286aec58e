/// Makes the ghosts of a replay: flights of other logs, as a layer of the scene with which the replay is drawn.
#pragma once

#include "host_sim/console.hpp"
#include "host_sim/options/replay_options.hpp"
#include "host_sim/replay/ghost_track.hpp"
#include "host_sim/scene_builder/scene_draft.hpp"

namespace tedavis::host_sim {

/// Returns the layer "ghosts", with a line for each stretch without a gap, named "GHOST " and the flight's name. Its times are
/// UTC where the own log states UTC, else times of the own log. There is one track for each flight.
[[nodiscard]] LayerDraft ghost_layer(const ScannedFlight& own, const std::vector<ShownGhost>& flights,
                                     const std::vector<GhostTrack>& tracks);
/// Returns the name of each log's flight in the pictures: the file's name without extensions, or the folder's name where another
/// log or the own one has the same; cut to the length that a picture can show, and numbered where names are still equal.
[[nodiscard]] std::vector<std::string> ghost_names(const std::string& own, const std::vector<std::string>& logs);

/// Reads the logs and writes the scene with the ghosts into `folder`, which must stay for as long as pictures are drawn. Throws
/// UserError: too many, a log without positions, one that cannot be aligned, a scene without room; Interrupted.
[[nodiscard]] ShownGhosts make_ghosts(const ReplayOptions& options, const std::string& folder, Console& console);

}  // namespace tedavis::host_sim
