/// Heights with their bounds, as the tracer wants them.
#pragma once

#include <vector>

#include "render_core/base/check.hpp"
#include "render_core/raytrace/trace_ray.hpp"
#include "tests/support/terrain/fractal_heights.hpp"

namespace tedavis::test_support {

template <class Height>
class TracedGround {
public:
    enum class Starts : std::uint8_t { above, anywhere };

    explicit TracedGround(HeightField<Height> posts, Starts starts = Starts::above)
        : field(std::move(posts)), has_minima_(starts == Starts::anywhere) {
        for (raytrace::HeightMipmap<Height>* const bounds : {&maxima_, &minima_}) {
            std::vector<std::uint64_t>& memory = bounds == &maxima_ ? maxima_memory_ : minima_memory_;
            memory.resize(raytrace::HeightMipmap<Height>::bytes_needed(field.columns, field.rows) / 8 + 1);
            base::Arena arena(memory.data(), memory.size() * 8);
            TEDAVIS_CHECK(bounds->start(field.grid(), arena));
            base::SerialWorkers workers;
            bounds->build(workers);
        }
    }
    TracedGround(const TracedGround&) = delete;
    TracedGround& operator=(const TracedGround&) = delete;

    [[nodiscard]] raytrace::TracedField<Height> traced(raytrace::CellSurface surface) const {
        return {&maxima_, has_minima_ ? &minima_ : nullptr, surface};
    }
    [[nodiscard]] raytrace::Hit trace(const raytrace::Ray& ray,
                                      raytrace::CellSurface surface = raytrace::CellSurface::two_triangles) const {
        return raytrace::trace_ray(traced(surface), ray);
    }
    /// A fault for tests to find: the last column and the last row of a level count as without a surface.
    void lose_border(std::uint32_t level) {
        const raytrace::MipmapLevel<Height> nodes = maxima_.level(level);
        for (std::uint32_t row = 0; row < nodes.rows; ++row)
            for (std::uint32_t column = 0; column < nodes.columns; ++column)
                if (row + 1 == nodes.rows || column + 1 == nodes.columns)
                    const_cast<Height*>(nodes.nodes)[std::size_t{row} * nodes.columns + column] =
                        raytrace::HeightGrid<Height>::kVoid;
    }

    HeightField<Height> field;

private:
    bool has_minima_;
    std::vector<std::uint64_t> maxima_memory_, minima_memory_;
    raytrace::HeightMipmap<Height> maxima_{raytrace::HeightBound::maximum}, minima_{raytrace::HeightBound::minimum};
};

}  // namespace tedavis::test_support
