/// A picture of primary rays by our tracer: t of every pixel, generation of the rays included.
#pragma once

#include <cstdint>
#include <vector>

#include "render_core/base/memory_budget.hpp"
#include "render_core/raytrace/trace_ray.hpp"
#include "tests/support/trace_cameras.hpp"

namespace tedavis::bench {

/// The tracer over a grid, with its memory.
class OwnTracer {
public:
    explicit OwnTracer(const raytrace::HeightGrid<std::int16_t>& grid)
        : memory_(raytrace::HeightMipmap<std::int16_t>::bytes_needed(grid.columns, grid.rows)),
          posts_bytes_(std::size_t{grid.stride} * grid.rows * sizeof(std::int16_t)) {
        base::Arena arena(memory_.data(), memory_.size());
        is_started_ = maxima_.start(grid, arena);
    }
    void build(base::Workers& workers) {
        if (is_started_) maxima_.build(workers);
    }
    [[nodiscard]] std::size_t bytes() const { return memory_.size() + posts_bytes_; }
    [[nodiscard]] raytrace::TracedField<std::int16_t> field() const { return {&maxima_}; }

private:
    std::vector<unsigned char> memory_;
    std::size_t posts_bytes_;
    raytrace::HeightMipmap<std::int16_t> maxima_;
    bool is_started_ = false;
};

class OwnPicture {
public:
    OwnPicture(const OwnTracer& tracer, const test_support::TraceCamera& camera, std::vector<float>& t)
        : field_(tracer.field()), camera_(camera), t_(t) {}

    void draw(base::Workers& workers) {
        workers.parallel_for(
            camera_.height, [](void* self, std::uint32_t row) { static_cast<OwnPicture*>(self)->draw_row(row); }, this);
    }

private:
    void draw_row(std::uint32_t y) {
        for (std::uint32_t x = 0; x < camera_.width; ++x)
            t_[std::size_t{y} * camera_.width + x] = raytrace::trace_ray(field_, camera_.ray(x, y)).t;
    }

    raytrace::TracedField<std::int16_t> field_;
    test_support::TraceCamera camera_;
    std::vector<float>& t_;
};

}  // namespace tedavis::bench
