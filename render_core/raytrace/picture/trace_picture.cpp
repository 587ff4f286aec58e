#include "render_core/raytrace/picture/trace_picture.hpp"

#include <algorithm>

#include "render_core/raytrace/stream/token_writer.hpp"

namespace tedavis::raytrace {
namespace {

constexpr std::uint32_t kRayWords = sizeof(MirroredRay) / sizeof(std::uint32_t);
constexpr std::uint32_t kPixelWords = 2;  ///< set pixel: first place and end; a pixel to resample has a word to spare
/// Four tiles are traced before they are shaded: their pixels fit the second cache (Segment::fits()).
constexpr std::uint32_t kTilesTogether = 1, kWordsLeftByTile = 8192;
constexpr std::uint32_t kPlainOutputs = kPixelWords + 1;
/// What a shaded span gives that has remainders: set pixel, rays and pixels to resample.
constexpr std::uint32_t kMaxOutputsOfShade = kPlainOutputs + PixelSpan::kMax * kRayWords + 1 + PixelSpan::kMax * kPixelWords + 1;

struct TEDAVIS_RECORD PixelRecord {
    std::uint32_t first, end;
};

template <class Height>
Task stage_of(TracePicture<Height>* picture, const char* name, std::uint32_t arguments, std::uint32_t outputs,
              BatchFunction run) {
    Task task;
    task.name = name;
    task.arguments = arguments;
    task.most_outputs = outputs;
    task.run = run;
    task.context = picture;
    return task;
}

}  // namespace

template <class Height>
std::uint64_t TracePicture<Height>::bytes_needed(std::uint32_t width, std::uint32_t height, const StreamSettings& stream) {
    return TraceStages<Height>::bytes_needed(width, height) + TokenStream::bytes_needed(stream) +
           StreamRewriter::bytes_needed(stream) + 64;
}

template <class Height>
typename TracePicture<Height>::Answer TracePicture<Height>::start(std::uint32_t width, std::uint32_t height,
                                                                  const StreamSettings& stream, base::Arena& arena) {
    const std::uint64_t before = arena.use().in_use;
    if (!stages_.start(width, height, arena))
        return base::fail(base::FaultText("a traced picture does not fit its memory; give it bytes_needed()"));
    const Answer started = stream_.start(stream, arena);
    if (!started.ok()) return started;
    const Answer rewriting = rewriter_.start(stream_, arena);
    if (!rewriting.ok()) return rewriting;
    return arena.use().in_use - before;
}

template <class Height>
bool TracePicture<Height>::add_tasks() {
    network_ = TaskNetwork();
    const bool has_more = stages_.has_remainders();
    PictureStages made;
    made.primary = stage_of(this, "primary", kRangeArguments, kPlainOutputs, &TracePicture::run_primary);
    made.primary.left_words = kWordsLeftByTile;
    made.primary.most_count = kTilesTogether;
    if (has_more) made.surface = make_range_task("spans", span_steps_, kNoTask);
    made.shade =
        stage_of(this, "shade", kRangeArguments, has_more ? kMaxOutputsOfShade : kPlainOutputs, &TracePicture::run_shade);
    made.trace = stage_of(this, "trace", kRayWords, kRayWords + 1, &TracePicture::run_trace);
    made.set_pixel = stage_of(this, "set pixel", kPixelWords, 0, &TracePicture::run_set_pixel);
    made.primary.lanes = made.shade.lanes = made.set_pixel.lanes = 1;  // each is a whole tile or span
    const base::Result<PictureTasks, base::FaultText> main = add_picture_tasks(network_, made, tile_steps_);
    if (!main.ok()) return false;
    tasks_.main = main.value();
    Task again = stage_of(this, "resample", kPixelWords, kPlainOutputs, &TracePicture::run_resample);
    again.next = tasks_.main.set_pixel;
    again.lanes = 1;
    const TaskNetwork::Answer added = network_.add(again);
    if (added.ok()) tasks_.resample = added.value();
    return added.ok();
}

template <class Height>
bool TracePicture<Height>::begin(const TracedScene<Height>& scene, const TraceLook& look, const PictureVariants& variants,
                                 base::Span<std::uint8_t> rgb8) {
    stages_.begin(scene, look, variants, rgb8);
    stream_.clear();
    return add_tasks() && begin_picture(stream_, tasks_.main, stages_.tiles());
}

template <class Height>
StreamRewriter::Answer TracePicture<Height>::rewrite(base::Workers& workers, std::uint32_t most_rounds) {
    return rewriter_.rewrite(network_, workers, most_rounds);
}

template <class Height>
void TracePicture<Height>::run_primary(void* self, const Batch& batch, TokenWriter& out) {
    const TraceStages<Height>& stages = static_cast<TracePicture*>(self)->stages_;
    for (std::uint32_t n = 0; n < batch.count; ++n) {
        const std::uint32_t first = batch.record(n)[0], end = batch.record(n)[1];
        for (std::uint32_t tile = first; tile < end; ++tile) stages.trace_tile(tile);
        out.literal(first * TraceStages<Height>::kSpansOfTile);
        out.literal(end * TraceStages<Height>::kSpansOfTile);
        out.call(batch.next);
        out.done();
    }
}

template <class Height>
void TracePicture<Height>::run_shade(void* self, const Batch& batch, TokenWriter& out) {
    const TracePicture& picture = *static_cast<TracePicture*>(self);
    const TraceStages<Height>& stages = picture.stages_;
    SpanRemainder rest;
    for (std::uint32_t n = 0; n < batch.count; ++n) {
        const std::uint32_t first = batch.record(n)[0], end = batch.record(n)[1];
        for (std::uint32_t span = first; span < end; ++span) stages.shade_span(stages.span(span), rest);
        const PixelRecord shaded = {first * PixelSpan::kMax, end * PixelSpan::kMax};
        out.calls(batch.next, &shaded, 1);
        // Only of one span, where there are such: the range before has a grain of 1.
        if (stages.has_remainders()) {
            out.calls(picture.tasks_.main.trace, rest.ray, rest.rays);
            PixelRecord again[PixelSpan::kMax];
            for (std::uint32_t k = 0; k < rest.resampled; ++k) again[k] = {rest.pixel[k], 0};
            out.calls(picture.tasks_.resample, again, rest.resampled);
        }
        out.done();
    }
}

template <class Height>
void TracePicture<Height>::run_trace(void* self, const Batch& batch, TokenWriter& out) {
    const TracePicture& picture = *static_cast<TracePicture*>(self);
    const MirroredRay* const rays = batch.records<MirroredRay>();
    for (std::uint32_t n = 0; n < batch.count; ++n) {
        MirroredRay further;
        if (picture.stages_.follow(rays + n, 1, &further) > 0) {
            out.calls(batch.self, &further, 1);
        } else {
            const std::uint32_t place = picture.stages_.place_of(rays[n].pixel);
            const PixelRecord seen = {place, place + 1};
            out.calls(picture.tasks_.main.set_pixel, &seen, 1);
        }
        out.done();
    }
}

template <class Height>
void TracePicture<Height>::run_resample(void* self, const Batch& batch, TokenWriter& out) {
    const TraceStages<Height>& stages = static_cast<TracePicture*>(self)->stages_;
    for (std::uint32_t n = 0; n < batch.count; ++n) {
        const std::uint32_t pixel = batch.record(n)[0], place = stages.place_of(pixel);
        stages.resample(pixel);
        const PixelRecord seen = {place, place + 1};
        out.each_calls(batch.next, &seen, 1);
    }
}

template <class Height>
void TracePicture<Height>::run_set_pixel(void* self, const Batch& batch, TokenWriter&) {
    const TraceStages<Height>& stages = static_cast<TracePicture*>(self)->stages_;
    const PixelRecord* const records = batch.records<PixelRecord>();
    for (std::uint32_t n = 0; n < batch.count; ++n)
        for (std::uint32_t place = records[n].first; place < records[n].end;) {
            const std::uint32_t skipped = place % PixelSpan::kMax, left = records[n].end - place;
            const PixelSpan span = stages.span(place / PixelSpan::kMax);
            if (skipped < span.count) stages.set_levels({span.first + skipped, std::min(left, span.count - skipped)});
            place += PixelSpan::kMax - skipped;
        }
}

template <class Height>
void TracePicture<Height>::draw_tile(std::uint32_t tile) const {
    SpanRemainder rest;
    stages_.trace_tile(tile);
    for (std::uint32_t n = 0; n < TraceStages<Height>::kSpansOfTile; ++n) {
        const PixelSpan span = stages_.span(tile * TraceStages<Height>::kSpansOfTile + n);
        stages_.shade_span(span, rest);
        for (std::uint32_t left = rest.rays; left > 0;) left = stages_.follow(rest.ray, left, rest.ray);
        for (std::uint32_t k = 0; k < rest.resampled; ++k) stages_.resample(rest.pixel[k]);
        stages_.set_levels(span);
    }
}

template <class Height>
void TracePicture<Height>::draw_directly(base::Workers& workers) {
    stream_.clear();
    workers.parallel_for(
        stages_.tiles(), [](void* self, std::uint32_t tile) { static_cast<const TracePicture*>(self)->draw_tile(tile); }, this);
}

template class TracePicture<std::int16_t>;
template class TracePicture<float>;

}  // namespace tedavis::raytrace
