/// The network that draws a picture (thesis figures 6.8 and 6.9): a range of tiles expands to tiles, and a tile to its primary
/// rays. Their hits go to the surface stage, if there is one, and then to shading, which sets pixels or sends further rays.
///
///     tiles ──> primary ──> [surface] ──> shade ──> set pixel
///                 trace ──────^              │
///                   ^────────────────────────┘  recursive: shade calls the task number of trace
///
/// Stages are tasks of the caller, who defines their arguments; only `primary` has fixed ones: the first tile and the end of the
/// range. Stages may be replaced, inserted and removed later, as in every TaskNetwork.
#pragma once

#include "render_core/raytrace/stream/range_task.hpp"
#include "render_core/raytrace/stream/token_stream.hpp"

namespace tedavis::raytrace {

struct PictureStages {
    Task primary;
    Task trace;    ///< traces single rays; left out where `run` is null
    Task surface;  ///< left out where `run` is null
    Task shade;
    Task set_pixel;
};

struct PictureTasks {
    TaskId tiles = kNoTask, primary = kNoTask, trace = kNoTask, surface = kNoTask, shade = kNoTask, set_pixel = kNoTask;
};

/// Adds the tasks and sets the `next` of each stage. `steps` is borrowed. Returns one sentence where a stage is refused.
[[nodiscard]] base::Result<PictureTasks, base::FaultText> add_picture_tasks(TaskNetwork& network, const PictureStages& stages,
                                                                            RangeSteps& steps);

/// Appends one token for the whole picture to the stream; returns false where it has no room.
[[nodiscard]] bool begin_picture(TokenStream& stream, const PictureTasks& tasks, std::uint32_t tiles);

}  // namespace tedavis::raytrace
