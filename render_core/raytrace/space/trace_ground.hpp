/// Traces pictures of a view in world space, where rays are straight; in grid space they are bent.
///
/// Each tile of a picture has a camera in grid space for each piece of its rays (straight_pieces.hpp); each piece is traced for
/// the rays without a hit. All rays of a tile share the origin of a piece, since their origins differ by less than the error of
/// pieces. The total error is at most kMaxOff_px, which tests measure against rays of the world.
///
/// Memory  the caller's. Thread  uses the workers; the result does not depend on their number.
#pragma once

#include "render_core/base/ports/workers.hpp"
#include "render_core/raytrace/space/straight_pieces.hpp"
#include "render_core/raytrace/view_kernels.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::raytrace {

/// Largest deviation of a pixel's ray, in pixels.
inline constexpr double kMaxOff_px = 0.1;

/// The input to trace pictures of a view tile by tile. Plain data; all members are borrowed.
template <class Height>
struct GroundView {
    const TracedField<Height>* field = nullptr;
    const GroundSpace* space = nullptr;
    const terrain::View* view = nullptr;
    const ViewKernel<Height>* kernel = nullptr;
    PieceEnds ends;
    double highest = 0;  ///< highest post, height steps

    GroundView() = default;
    GroundView(const TracedField<Height>& traced, const GroundSpace& ground, const terrain::View& seen,
               const ViewKernel<Height>& widest);
};

/// Traces the kernel tile (kTileWidth x kTileHeight) whose first pixel is (left, top), clipped to the picture. Any thread.
template <class Height>
void trace_ground_tile(const GroundView<Height>& ground, std::uint32_t left, std::uint32_t top, const HitPicture& picture);

/// Traces a view: t is the depth along its forward direction, in metres, from its eye point to its far plane. Magnifiers and a
/// flat surface of the view are ignored.
template <class Height>
void trace_ground(const TracedField<Height>& field, const GroundSpace& space, const terrain::View& view,
                  const ViewKernel<Height>& kernel, base::Workers& workers, const HitPicture& picture);

/// True where kMax pieces suffice for a view's rays, that is, not close to the poles.
[[nodiscard]] bool can_trace(const GroundSpace& space, const terrain::View& view);

/// The camera of one piece of the rays of a tile.
struct PixelTile {
    std::uint32_t left = 0, top = 0, right = 0, bottom = 0;  ///< right and bottom are exclusive
};
[[nodiscard]] GridCamera fit_camera(const GroundSpace& space, const terrain::View& view, const PixelTile& tile, double from,
                                    double to);
/// Upper bound of the gap between two pieces of a view's rays, in height steps, where the second begins (Ray::gap).
[[nodiscard]] double gap_before(const GroundSpace& space, const terrain::View& view, double from);
/// Returns where a view's rays are divided.
[[nodiscard]] PieceEnds cut_view(const terrain::View& view);

}  // namespace tedavis::raytrace
