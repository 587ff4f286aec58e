/// Draws a traced picture. Its stages are tasks of the functional model, run by the token stream on any number of workers
/// (thesis 6.2.2.3), or called directly; both give the same picture bit for bit.
///
///     tiles ──> primary ──> [spans] ──> shade ──> set pixel
///                            trace <────┘   │       ^ ^
///                             └─> trace ────│───────┘ │      recursive: mirrors
///                                           └─> resample     more rays where a pixel covers much
///
/// Without mirrors and supersampling there are no spans: a tile passes all stages while it is in the cache.
///
/// Tasks may be replaced, inserted and removed between rounds: network() and tasks().
///
/// Memory  from an arena, at start; nothing is allocated afterwards. One caller.
#pragma once

#include "render_core/raytrace/picture/trace_stages.hpp"
#include "render_core/raytrace/stream/picture_tasks.hpp"
#include "render_core/raytrace/stream/stream_rewriter.hpp"

namespace tedavis::raytrace {

struct TracePictureTasks {
    PictureTasks main;
    TaskId resample = kNoTask;
};

template <class Height>
class TracePicture {
public:
    using Answer = base::Result<std::uint64_t, base::FaultText>;
    static constexpr std::uint32_t kManyRounds = 1'000'000;

    TracePicture() = default;
    TracePicture(const TracePicture&) = delete;
    TracePicture& operator=(const TracePicture&) = delete;

    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t width, std::uint32_t height, const StreamSettings& stream);
    /// Returns the allocated bytes, or one sentence.
    [[nodiscard]] Answer start(std::uint32_t width, std::uint32_t height, const StreamSettings& stream, base::Arena& arena);

    /// See TraceStages::begin(). Builds the network for these settings and fills the stream; returns false where the stream has
    /// no room. Afterwards call rewrite() until it is finished, or draw_directly().
    [[nodiscard]] bool begin(const TracedScene<Height>& scene, const TraceLook& look, const PictureVariants& variants,
                             base::Span<std::uint8_t> rgb8);
    [[nodiscard]] StreamRewriter::Answer rewrite(base::Workers& workers, std::uint32_t most_rounds = kManyRounds);
    /// Draws without the stream, which is cleared.
    void draw_directly(base::Workers& workers);

    [[nodiscard]] TaskNetwork& network() { return network_; }
    [[nodiscard]] const TracePictureTasks& tasks() const { return tasks_; }
    [[nodiscard]] const TraceStages<Height>& stages() const { return stages_; }

private:
    [[nodiscard]] bool add_tasks();
    void draw_tile(std::uint32_t tile) const;
    static void run_primary(void* self, const Batch& batch, TokenWriter& out);
    static void run_shade(void* self, const Batch& batch, TokenWriter& out);
    static void run_trace(void* self, const Batch& batch, TokenWriter& out);
    static void run_resample(void* self, const Batch& batch, TokenWriter& out);
    static void run_set_pixel(void* self, const Batch& batch, TokenWriter& out);

    TraceStages<Height> stages_;
    TaskNetwork network_;
    RangeSteps tile_steps_{1, 2048};
    RangeSteps span_steps_{1, 1024};
    TracePictureTasks tasks_;
    TokenStream stream_;
    StreamRewriter rewriter_;
};

}  // namespace tedavis::raytrace
