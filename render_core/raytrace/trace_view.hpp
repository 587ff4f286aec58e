/// What a picture's rays meet: one ray a pixel, exactly what trace_ray() finds, bit for bit, but many times faster.
///
/// In tiles of 32 x 32 pixels, beams of 32 x 32, 16 x 16, 8 x 8 and 4 x 4 pixels find out how far none of their rays meets
/// anything (kernel/beam_march.hpp); from there rays go on in lanes of the widest vectors that the machine has
/// (view_kernels.hpp). What beams and lanes change is the time that it takes.
///
/// Memory  the caller's. Thread  uses the workers; the result does not depend on their number.
#pragma once

#include "render_core/base/ports/workers.hpp"
#include "render_core/raytrace/trace_ray.hpp"
#include "render_core/raytrace/view_kernels.hpp"

namespace tedavis::raytrace {

/// Width and height in pixels, not 0; what pictures hold of them is the caller's to see to. The kernel is one of view_kernels().
template <class Height>
void trace_view(const TracedField<Height>& field, const GridCamera& camera, const ViewKernel<Height>& kernel,
                base::Workers& workers, std::uint32_t width, std::uint32_t height, const HitPicture& picture);

/// Tiles across a picture and down; numbered row by row.
struct ViewTiles {
    std::uint32_t across, down;

    ViewTiles(std::uint32_t width, std::uint32_t height)
        : across((width + kTileWidth - 1) / kTileWidth), down((height + kTileHeight - 1) / kTileHeight) {}
    [[nodiscard]] std::uint32_t count() const { return across * down; }
    [[nodiscard]] std::uint32_t left(std::uint32_t tile) const { return tile % across * kTileWidth; }
    [[nodiscard]] std::uint32_t top(std::uint32_t tile) const { return tile / across * kTileHeight; }
};

}  // namespace tedavis::raytrace
