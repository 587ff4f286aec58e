#include "render_core/raytrace/space/trace_ground.hpp"

#include <cmath>

#include "render_core/base/check.hpp"
#include "render_core/raytrace/view_tiles.hpp"

namespace tedavis::raytrace {
namespace {

/// Of what rays may be off, the share of their pieces; the rest is for what a tile's rays have in common.
constexpr double kPieceShare = 0.4;
/// A ray that rises more steeply than this does not sink again: the geoid's slope is less.
constexpr double kSurelyRises = 1e-3;

glm::dvec3 direction_at(const terrain::View& view, double x, double y) {
    return view.forward + view.right * ((x - 0.5 * view.width) / view.focal_px) +
           view.down * ((y - 0.5 * view.height) / view.focal_px);
}

double stretch_of(const terrain::View& view) {
    const double x = view.half_width_tangent(), y = view.half_height_tangent();
    return std::sqrt(1 + x * x + y * y);
}

/// Where a tile's rays are over a piece: linear in x, y and t each, so corners have the extremes.
struct PieceBox {
    glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
    glm::dvec3 slowest{std::numeric_limits<double>::infinity()}, fastest{-std::numeric_limits<double>::infinity()};

    PieceBox(const GridCamera& camera, const PixelTile& tile, double from, double to) {
        for (int corner = 0; corner < 4; ++corner) {
            const double x = (corner & 1) != 0 ? tile.right : tile.left, y = (corner & 2) != 0 ? tile.bottom : tile.top;
            const glm::dvec3 speed = glm::dvec3(camera.corner) + x * glm::dvec3(camera.right) + y * glm::dvec3(camera.down);
            const glm::dvec3 begin = camera.origin + from * speed, end = camera.origin + to * speed;
            low = glm::min(low, glm::min(begin, end));
            high = glm::max(high, glm::max(begin, end));
            slowest = glm::min(slowest, speed);
            fastest = glm::max(fastest, speed);
        }
    }
};

bool is_all_hit(const HitPicture& picture, std::uint32_t width, const PixelTile& tile) {
    for (std::uint32_t y = tile.top; y < tile.bottom; ++y) {
        const float* const row = picture.t.data() + std::size_t{y} * width;
        bool is_hit = true;
        for (std::uint32_t x = tile.left; x < tile.right; ++x) is_hit &= row[x] <= std::numeric_limits<float>::max();
        if (!is_hit) return false;
    }
    return true;
}

/// What becomes of a tile's rays in a piece.
enum class PieceUse : std::uint8_t { traced, passed, over };

template <class Height>
PieceUse use_of(const GroundView<Height>& ground, const PieceBox& box, double gap) {
    if (box.low.z > ground.highest + gap)
        return box.slowest.z * ground.space->step_m() > kSurelyRises ? PieceUse::over : PieceUse::passed;
    const double columns = ground.field->grid().columns - 1, rows = ground.field->grid().rows - 1;
    const bool is_beside = box.high.x < 0 || box.high.y < 0 || box.low.x > columns || box.low.y > rows;
    if (!is_beside) return PieceUse::traced;
    // Away from the window by more than it is wide, and further away: a ray is nearly straight, and does not come back.
    const bool has_left = (box.high.x < -columns && box.fastest.x < 0) || (box.high.y < -rows && box.fastest.y < 0) ||
                          (box.low.x > 2 * columns && box.slowest.x > 0) || (box.low.y > 2 * rows && box.slowest.y > 0);
    return has_left ? PieceUse::over : PieceUse::passed;
}

template <class Height>
struct GroundWork {
    GroundView<Height> ground;
    ViewTiles tiles;
    const HitPicture* picture;
};

template <class Height>
void ground_tile_of(void* context, std::uint32_t tile) {
    const auto& work = *static_cast<const GroundWork<Height>*>(context);
    trace_ground_tile(work.ground, work.tiles.left(tile), work.tiles.top(tile), *work.picture);
}

}  // namespace

double gap_before(const GroundSpace& space, const terrain::View& view, double from) {
    return 2 * kMaxOff_px / view.focal_px * from / space.step_m();
}

PieceEnds cut_view(const terrain::View& view) {
    return cut_rays(view.eye, kPieceShare * kMaxOff_px / view.focal_px, stretch_of(view), view.far_m);
}

bool can_trace(const GroundSpace& space, const terrain::View& view) {
    const PieceEnds ends = cut_view(view);
    return ends.end[ends.count] >= view.far_m && is_in_reach(space.place(view.eye));
}

GridCamera fit_camera(const GroundSpace& space, const terrain::View& view, const PixelTile& tile, double from, double to) {
    const double x[2] = {static_cast<double>(tile.left), static_cast<double>(tile.right)};
    const double y[2] = {static_cast<double>(tile.top), static_cast<double>(tile.bottom)};
    StraightPiece lines[2][2];
    GridCamera camera;
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 2; ++column) {
            lines[row][column] = straight_piece(space, view.eye, direction_at(view, x[column], y[row]), from, to);
            camera.origin += 0.25 * lines[row][column].origin;
        }
    glm::dvec3 slope[2][2];  // of lines from the common origin that meet theirs in the middle of the piece
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 2; ++column)
            slope[row][column] = lines[row][column].direction + (lines[row][column].origin - camera.origin) / (0.5 * (from + to));
    const glm::dvec3 right = (slope[0][1] - slope[0][0] + slope[1][1] - slope[1][0]) / (2 * (x[1] - x[0]));
    const glm::dvec3 down = (slope[1][0] - slope[0][0] + slope[1][1] - slope[0][1]) / (2 * (y[1] - y[0]));
    const glm::dvec3 middle = 0.25 * (slope[0][0] + slope[0][1] + slope[1][0] + slope[1][1]);
    camera.right = glm::vec3(right);
    camera.down = glm::vec3(down);
    camera.corner = glm::vec3(middle - right * (0.5 * (x[0] + x[1])) - down * (0.5 * (y[0] + y[1])));
    return camera;
}

template <class Height>
GroundView<Height>::GroundView(const TracedField<Height>& traced, const GroundSpace& ground, const terrain::View& seen,
                               const ViewKernel<Height>& widest)
    : field(&traced), space(&ground), view(&seen), kernel(&widest), ends(cut_view(seen)) {
    const MipmapLayout& layout = traced.maxima->layout();
    highest = static_cast<double>(traced.maxima->level(static_cast<std::uint32_t>(layout.top)).nodes[0]);
}

template <class Height>
void trace_ground_tile(const GroundView<Height>& ground, std::uint32_t left, std::uint32_t top, const HitPicture& picture) {
    const terrain::View& view = *ground.view;
    const std::uint32_t right = left + kTileWidth, bottom = top + kTileHeight;
    const PixelTile tile{left, top, right < view.width ? right : view.width, bottom < view.height ? bottom : view.height};
    clear_pixels(picture, view.width, tile.left, tile.top, tile.right, tile.bottom);
    for (int piece = 0; piece < ground.ends.count; ++piece) {
        const double from = ground.ends.end[piece], to = ground.ends.end[piece + 1];
        const GridCamera camera = fit_camera(*ground.space, view, tile, from, to);
        const double gap = gap_before(*ground.space, view, from);
        const PieceUse use = use_of(ground, PieceBox(camera, tile, from, to), gap);
        if (use == PieceUse::over) return;
        if (use == PieceUse::passed) continue;
        const RaySpan span{static_cast<float>(from), static_cast<float>(to), static_cast<float>(gap)};
        const ViewJob<Height> job{ground.field, &camera, view.width, view.height, picture, span, true};
        ground.kernel->trace_tile(job, tile.left, tile.top);
        if (is_all_hit(picture, view.width, tile)) return;
    }
}

template <class Height>
void trace_ground(const TracedField<Height>& field, const GroundSpace& space, const terrain::View& view,
                  const ViewKernel<Height>& kernel, base::Workers& workers, const HitPicture& picture) {
    const std::size_t pixels = std::size_t{view.width} * view.height;
    TEDAVIS_CHECK(has_pixels(picture, pixels));
    TEDAVIS_CHECK(can_trace(space, view));
    GroundWork<Height> work{{field, space, view, kernel}, {view.width, view.height}, &picture};
    workers.parallel_for(work.tiles.count(), ground_tile_of<Height>, &work);
}

template void trace_ground(const TracedField<std::int16_t>&, const GroundSpace&, const terrain::View&,
                           const ViewKernel<std::int16_t>&, base::Workers&, const HitPicture&);
template void trace_ground(const TracedField<float>&, const GroundSpace&, const terrain::View&, const ViewKernel<float>&,
                           base::Workers&, const HitPicture&);

template struct GroundView<std::int16_t>;
template struct GroundView<float>;
template void trace_ground_tile(const GroundView<std::int16_t>&, std::uint32_t, std::uint32_t, const HitPicture&);
template void trace_ground_tile(const GroundView<float>&, std::uint32_t, std::uint32_t, const HitPicture&);

}  // namespace tedavis::raytrace
