/// The kernels that trace tiles of pictures, one for each width of lanes in this build; those that the machine can run are
/// determined at run time. Each gives the same hits as trace_ray() for the rays of pixels, bit for bit, but many times faster.
///
/// Beams of 16 x 16, 8 x 8 and 4 x 4 pixels of a tile find a distance without hits (kernel/beam_march.hpp); from there rays
/// continue in lanes of the machine's widest vectors. Beams and lanes only change the time.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>

#include "render_core/base/span.hpp"
#include "render_core/raytrace/trace_ray.hpp"

namespace tedavis::raytrace {

/// The camera of a picture. The ray through pixel (x, y), 0 at the upper left, is
/// origin + t * (corner + (x + 0.5) * right + (y + 0.5) * down), in grid space.
struct GridCamera {
    glm::dvec3 origin{0};
    glm::vec3 corner{0}, right{0}, down{0};

    [[nodiscard]] Ray ray(std::uint32_t x, std::uint32_t y) const;
};

/// The range of the rays of a picture: points for t from `from` to `to`; a ray that begins below the surface by up to `gap`
/// height steps hits it there (Ray::gap).
struct RaySpan {
    float from = 0;
    float to = std::numeric_limits<float>::infinity();
    float gap = 0;
};

/// The output of a picture, borrowed: width x height of each, rows from the top. All except t may be empty: they are then not
/// computed.
struct HitPicture {
    static constexpr std::int32_t kNoCell = -1;

    base::Span<float> t;              ///< infinite without a hit
    base::Span<std::int32_t> cell{};  ///< row * (columns of cells) + column
    base::Span<HitSide> side{};
    base::Span<float> u{}, v{};  ///< position in the cell, 0..1 towards higher columns and rows; only valid with a hit
};

/// The size of the tiles in which pictures are traced, in pixels.
inline constexpr std::uint32_t kTileWidth = 32, kTileHeight = 32;

template <class Height>
struct ViewJob {
    const TracedField<Height>* field = nullptr;
    const GridCamera* camera = nullptr;
    std::uint32_t width = 0, height = 0;
    HitPicture picture;
    RaySpan span;
    bool goes_on = false;  ///< pixels with a finite t are not traced; all others must have been cleared (clear_pixels())
};

template <class Height>
struct ViewKernel {
    const char* name = "";
    int lanes = 1;
    /// Traces the tile whose first pixel is (left, top), clipped to the picture.
    void (*trace_tile)(const ViewJob<Height>& job, std::uint32_t left, std::uint32_t top) = nullptr;
};

/// True where each output that is not empty has this many pixels.
[[nodiscard]] bool has_pixels(const HitPicture& picture, std::size_t pixels);

/// Initialises a rectangle of pixels without hits.
void clear_pixels(const HitPicture& picture, std::uint32_t width, std::uint32_t left, std::uint32_t top, std::uint32_t right,
                  std::uint32_t bottom);

/// Traces one pixel by trace_ray(), for rays that a kernel cannot follow.
template <class Height>
void trace_pixel(const ViewJob<Height>& job, std::uint32_t x, std::uint32_t y);

/// Returns the kernels that this machine can run, the widest first; the last one is scalar and runs everywhere.
template <class Height>
[[nodiscard]] base::Span<const ViewKernel<Height>> view_kernels();

}  // namespace tedavis::raytrace
