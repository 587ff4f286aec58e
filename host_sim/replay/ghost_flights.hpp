/// Makes the ghosts of a replay: flights of other logs, in a layer of the scene that the replay is drawn with.
#pragma once

#include "host_sim/console.hpp"
#include "host_sim/options/replay_options.hpp"
#include "host_sim/replay/ghost_track.hpp"
#include "host_sim/scene_builder/scene_draft.hpp"

namespace tedavis::host_sim {

/// The layer "ghosts": a line for each stretch without a gap, named "GHOST " and its flight. Times are those that the display has
/// then: UTC where the own log knows it, else its own. Tracks are as many as flights.
[[nodiscard]] LayerDraft ghost_layer(const ScannedFlight& own, const std::vector<ShownGhost>& flights,
                                     const std::vector<GhostTrack>& tracks);
/// What the pictures call the flight of each log: the file's name without its kinds, or its folder's where another one, or the
/// own log, has the same; cut where it is longer than a picture can show, and numbered where that is the same again.
[[nodiscard]] std::vector<std::string> ghost_names(const std::string& own, const std::vector<std::string>& logs);

/// Reads the logs and writes the scene with the ghosts into `folder`, which must stay for as long as pictures are drawn. Throws
/// UserError: too many, a log without positions, one that cannot be aligned, a scene without room; Interrupted.
[[nodiscard]] ShownGhosts make_ghosts(const ReplayOptions& options, const std::string& folder, Console& console);

}  // namespace tedavis::host_sim
