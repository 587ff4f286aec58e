/// The network that draws a picture (thesis figures 6.8 and 6.9): a range of tiles expands to tiles, a tile to its primary rays,
/// what these meet goes to the surface stage if there is one, then to shading, which sets pixels or sends further rays.
///
///     tiles ──> primary ──> [surface] ──> shade ──> set pixel
///                 trace ──────^              │
///                   ^────────────────────────┘  recursive: by the number of trace, where a shade's context has it
///
/// Stages are tasks of the caller: what their calls hold is theirs to say, but for primary, which takes the first tile and the
/// end. Stages may be replaced, inserted and removed later, as in every TaskNetwork.
#pragma once

#include "render_core/raytrace/stream/range_task.hpp"
#include "render_core/raytrace/stream/token_stream.hpp"

namespace tedavis::raytrace {

struct PictureStages {
    Task primary;
    Task trace;    ///< of single rays; without a function there is none
    Task surface;  ///< without a function there is none
    Task shade;
    Task set_pixel;
};

struct PictureTasks {
    TaskId tiles = kNoTask, primary = kNoTask, trace = kNoTask, surface = kNoTask, shade = kNoTask, set_pixel = kNoTask;
};

/// Whatever `next` the stages have is set here. `steps` is borrowed. A sentence where a stage is refused.
[[nodiscard]] base::Result<PictureTasks, base::FaultText> add_picture_tasks(TaskNetwork& network, const PictureStages& stages,
                                                                            RangeSteps& steps);

/// Puts one token for the whole picture into the stream; false where it has no room.
[[nodiscard]] bool begin_picture(TokenStream& stream, const PictureTasks& tasks, std::uint32_t tiles);

}  // namespace tedavis::raytrace
