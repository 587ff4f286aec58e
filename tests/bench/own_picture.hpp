/// A picture of primary rays by our tracer: t of every pixel, generation of the rays included.
#pragma once

#include <cstdint>
#include <vector>

#include "render_core/base/check.hpp"
#include "tests/support/raytrace/trace_cameras.hpp"
#include "tests/support/raytrace/traced_view.hpp"

namespace tedavis::bench {

using OwnKernel = raytrace::ViewKernel<std::int16_t>;

/// The bounds of a grid, with their memory.
class OwnBounds {
public:
    explicit OwnBounds(const raytrace::HeightGrid<std::int16_t>& grid)
        : bytes_(raytrace::HeightMipmap<std::int16_t>::bytes_needed(grid.columns, grid.rows)), memory_(bytes_ / 8 + 1) {
        base::Arena arena(memory_.data(), memory_.size() * 8);
        TEDAVIS_CHECK(maxima_.start(grid, arena));
    }
    void build(base::Workers& workers) { maxima_.build(workers); }
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
    [[nodiscard]] raytrace::TracedField<std::int16_t> field(raytrace::CellSurface surface) const {
        return {&maxima_, nullptr, surface};
    }

private:
    std::uint64_t bytes_;
    std::vector<std::uint64_t> memory_;
    raytrace::HeightMipmap<std::int16_t> maxima_;
};

class OwnPicture {
public:
    OwnPicture(std::uint32_t width, std::uint32_t height) : t(std::size_t{width} * height), width_(width), height_(height) {}
    void draw(const raytrace::TracedField<std::int16_t>& field, const test_support::TraceCamera& camera, const OwnKernel& kernel,
              base::Workers& workers) {
        test_support::trace_view(field, camera.view(), kernel, workers, width_, height_, {t});
    }

    std::vector<float> t;

private:
    std::uint32_t width_, height_;
};

}  // namespace tedavis::bench
