/// Pictures of the ground as a view of the world sees it: rays are straight there, and bent in grid space.
///
/// Each tile of a picture has a camera of grid space for each piece of its rays (straight_pieces.hpp); pieces go on with the rays
/// that have met nothing yet. All rays of a tile share one origin of a piece: what separates theirs is less than what pieces are
/// off by. Together they are off by no more than PictureError says, which is measured in tests against rays of the world.
///
/// Memory  the caller's. Thread  uses the workers; the result does not depend on their number.
#pragma once

#include "render_core/base/ports/workers.hpp"
#include "render_core/raytrace/space/straight_pieces.hpp"
#include "render_core/raytrace/view_kernels.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::raytrace {

/// Of a pixel, that the middle of a pixel's ray is off by at most.
inline constexpr double kMaxOff_px = 0.1;

/// What pictures of a view are traced with, tile by tile. Plain data; all borrowed.
template <class Height>
struct GroundView {
    const TracedField<Height>* field = nullptr;
    const GroundSpace* space = nullptr;
    const terrain::View* view = nullptr;
    const ViewKernel<Height>* kernel = nullptr;
    PieceEnds ends;
    double highest = 0;  ///< of all posts, height steps

    GroundView() = default;
    GroundView(const TracedField<Height>& traced, const GroundSpace& ground, const terrain::View& seen,
               const ViewKernel<Height>& widest);
};

/// The tile of the kernel (kTileWidth x kTileHeight) whose first pixel is (left, top), as far as the view has it. Any thread.
template <class Height>
void trace_ground_tile(const GroundView<Height>& ground, std::uint32_t left, std::uint32_t top, const HitPicture& picture);

/// Of a view: t is the depth along its forward direction, in metres, from its eye to its far plane. Magnifiers and a flat surface
/// of the view are not heeded.
template <class Height>
void trace_ground(const TracedField<Height>& field, const GroundSpace& space, const terrain::View& view,
                  const ViewKernel<Height>& kernel, base::Workers& workers, const HitPicture& picture);

/// Whether a view's rays can be cut in as many pieces as there may be: not close to the poles.
[[nodiscard]] bool can_trace(const GroundSpace& space, const terrain::View& view);

/// Of the rays of a tile of pixels, for one piece.
struct PixelTile {
    std::uint32_t left = 0, top = 0, right = 0, bottom = 0;  ///< right and bottom are behind the last ones
};
[[nodiscard]] GridCamera fit_camera(const GroundSpace& space, const terrain::View& view, const PixelTile& tile, double from,
                                    double to);
/// Height steps that may lie between two pieces of a view's rays, where the second begins (Ray::gap).
[[nodiscard]] double gap_before(const GroundSpace& space, const terrain::View& view, double from);
/// Where a view's rays are cut.
[[nodiscard]] PieceEnds cut_view(const terrain::View& view);

}  // namespace tedavis::raytrace
