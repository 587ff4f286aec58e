/// A ray tracer's stages without terrain, for tests and benches of the token stream: rays of a tile, work like that of a ray, a
/// shade and pixels. Numbers depend on the pixel and the bounce alone. Sixteen lanes at once, in plain loops.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "render_core/raytrace/stream/picture_tasks.hpp"
#include "render_core/raytrace/stream/token_writer.hpp"

namespace tedavis::test_support {

/// Tiles of 64 pixels in a row; a hit is four words: pixel, bounce, light so far and distance.
class SyntheticRays {
public:
    static constexpr std::uint32_t kLanes = 16, kTilePixels = 64;

    struct TEDAVIS_RECORD Ray {
        std::uint32_t pixel, bounce;
        float light;
    };
    struct TEDAVIS_RECORD Shot {
        std::uint32_t pixel, bounce;
        float light, distance;
    };
    struct TEDAVIS_RECORD Dot {
        std::uint32_t pixel;
        float light;
    };

    explicit SyntheticRays(std::uint32_t pixels, int steps) : picture(pixels), steps_(steps) {}

    std::vector<float> picture;
    std::uint32_t mirrors = 0;  ///< one of so many rays is reflected; 0: none

    void trace(const Ray* rays, std::uint32_t count, Shot* shots) const;
    void shade(const Shot* shots, std::uint32_t count, Dot* dots) const;
    void set_pixels(const Dot* dots, std::uint32_t count);
    static void rays_of_tile(std::uint32_t tile, Ray* rays);
    /// All of a tile by calls of these functions alone, reflected rays gathered from round to round.
    void draw_tile(std::uint32_t tile);
    /// Divides shots into rays to go on and, in order, those that stay. How many go on.
    std::uint32_t reflect(const Shot* shots, std::uint32_t count, Ray* rays, Shot* stay) const;

private:
    bool is_mirror(const Shot& shot) const;

    int steps_;
};

inline void SyntheticRays::draw_tile(std::uint32_t tile) {
    Ray rays[kTilePixels];
    Shot shots[kTilePixels];
    Dot dots[kTilePixels];
    rays_of_tile(tile, rays);
    for (std::uint32_t count = kTilePixels; count > 0;) {
        trace(rays, count, shots);
        const std::uint32_t reflected = mirrors == 0 ? 0 : reflect(shots, count, rays, shots);
        shade(shots, count - reflected, dots);
        set_pixels(dots, count - reflected);
        count = reflected;
    }
}

/// The same as tasks: a range of tiles, tile, trace, shade, set pixel. A tile is traced at once; a reflected ray is a call of its
/// own in tokens that stand for all of those that its token gave.
class SyntheticRayTasks {
public:
    static constexpr std::uint32_t kTile = SyntheticRays::kTilePixels, kChunk = 512;

    raytrace::TaskNetwork network;
    raytrace::PictureTasks tasks;
    raytrace::RangeSteps steps{1, 1024};

    explicit SyntheticRayTasks(SyntheticRays& rays) : rays_(rays) {
        raytrace::PictureStages stages;
        stages.set_pixel = made("set pixel", 2, 0, &SyntheticRayTasks::run_set_pixel);
        stages.shade = made("shade", 4, 4, &SyntheticRayTasks::run_shade);
        stages.trace = made("trace", 3, 5, &SyntheticRayTasks::run_trace);
        stages.primary = made("primary", 2, 4 * kTile + 1, &SyntheticRayTasks::run_tile);
        stages.primary.most_count = 8;
        tasks = raytrace::add_picture_tasks(network, stages, steps).value();
    }
    SyntheticRayTasks(const SyntheticRayTasks&) = delete;

    /// Whether shades that are black come instead of the usual ones; for calls still to be made.
    raytrace::Task black_shade() {
        raytrace::Task task = network.task(tasks.shade);
        task.name = "black";
        task.run = &SyntheticRayTasks::run_black;
        return task;
    }

private:
    using Writer = raytrace::TokenWriter;
    using Batch = raytrace::Batch;

    raytrace::Task made(const char* name, std::uint32_t arguments, std::uint32_t outputs, raytrace::BatchFunction run) {
        raytrace::Task task;
        task.name = name;
        task.arguments = arguments;
        task.most_outputs = outputs;
        task.run = run;
        task.context = this;
        return task;
    }
    static SyntheticRayTasks& of(void* self) { return *static_cast<SyntheticRayTasks*>(self); }

    static void run_tile(void* self, const Batch& batch, Writer& out) {
        SyntheticRays::Ray rays[kTile];
        for (std::uint32_t n = 0; n < batch.count; ++n) {
            SyntheticRays::rays_of_tile(batch.record(n)[0], rays);
            SyntheticRays::Shot* shots = out.calls_in_place<SyntheticRays::Shot>(batch.next, kTile);
            if (shots == nullptr) return;
            of(self).rays_.trace(rays, kTile, shots);
            out.done();
        }
    }
    static void run_trace(void* self, const Batch& batch, Writer& out) {
        SyntheticRays::Shot shots[kChunk];
        for (std::uint32_t first = 0; first < batch.count; first += kChunk) {
            const std::uint32_t count = std::min(kChunk, batch.count - first);
            of(self).rays_.trace(batch.records<SyntheticRays::Ray>() + first, count, shots);
            out.each_calls(batch.next, shots, count);
        }
    }
    static void run_shade(void* self, const Batch& batch, Writer& out) {
        SyntheticRays::Shot stay[kChunk];
        SyntheticRays::Ray rays[kChunk];
        for (std::uint32_t first = 0; first < batch.count;) {
            const std::uint32_t count = std::min(kChunk, out.together());
            const SyntheticRays::Shot* shots = batch.records<SyntheticRays::Shot>() + first;
            const bool has_mirrors = of(self).rays_.mirrors != 0;
            const std::uint32_t reflected = has_mirrors ? of(self).rays_.reflect(shots, count, rays, stay) : 0;
            SyntheticRays::Dot* dots = out.calls_in_place<SyntheticRays::Dot>(batch.next, count - reflected);
            if (dots == nullptr) return;
            of(self).rays_.shade(has_mirrors ? stay : shots, count - reflected, dots);
            out.calls(of(self).tasks.trace, rays, reflected);
            out.done(count);
            first += count;
        }
    }
    static void run_black(void*, const Batch& batch, Writer& out) {
        for (std::uint32_t n = 0; n < batch.count; ++n) {
            const SyntheticRays::Dot dot = {batch.record(n)[0], 0};
            out.each_calls(batch.next, &dot, 1);
        }
    }
    static void run_set_pixel(void* self, const Batch& batch, Writer&) {
        of(self).rays_.set_pixels(batch.records<SyntheticRays::Dot>(), batch.count);
    }

    SyntheticRays& rays_;
};

}  // namespace tedavis::test_support
