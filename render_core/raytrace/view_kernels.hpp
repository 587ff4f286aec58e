/// The kernels that trace tiles of pictures, of each width of lanes that this build has; which of them a machine can run is found
/// out at run time. Each finds exactly what trace_ray() finds for the ray of a pixel, bit for bit, but many times faster.
///
/// Beams of 16 x 16, 8 x 8 and 4 x 4 pixels of a tile find out how far none of their rays meets anything
/// (kernel/beam_march.hpp); from there rays go on in lanes of the widest vectors that the machine has. What beams and lanes
/// change is the time that it takes.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>

#include "render_core/base/span.hpp"
#include "render_core/raytrace/trace_ray.hpp"

namespace tedavis::raytrace {

/// Of rays through pixel (x, y), 0 at the upper left: origin + t * (corner + (x + 0.5) * right + (y + 0.5) * down), in grid
/// space.
struct GridCamera {
    glm::dvec3 origin{0};
    glm::vec3 corner{0}, right{0}, down{0};

    [[nodiscard]] Ray ray(std::uint32_t x, std::uint32_t y) const;
};

/// What is asked of the rays of a picture: points for t from `from` to `to`, of which the first may be below the surface by `gap`
/// height steps and has met it there then (Ray::gap).
struct RaySpan {
    float from = 0;
    float to = std::numeric_limits<float>::infinity();
    float gap = 0;
};

/// Memory of a picture, borrowed: width x height of each, rows from the top. All but t may be empty: nobody asks.
struct HitPicture {
    static constexpr std::int32_t kNoCell = -1;

    base::Span<float> t;              ///< infinite where nothing is met
    base::Span<std::int32_t> cell{};  ///< row * (columns of cells) + column
    base::Span<HitSide> side{};
    base::Span<float> u{}, v{};  ///< where in the cell, 0..1 towards higher columns and rows; only where something is met
};

/// The size of the tiles in which pictures are traced, pixels.
inline constexpr std::uint32_t kTileWidth = 32, kTileHeight = 32;

template <class Height>
struct ViewJob {
    const TracedField<Height>* field = nullptr;
    const GridCamera* camera = nullptr;
    std::uint32_t width = 0, height = 0;
    HitPicture picture;
    RaySpan span;
    bool goes_on = false;  ///< rays of pixels that have a t are not asked; the others' pixels say that nothing is met
};

template <class Height>
struct ViewKernel {
    const char* name = "";
    int lanes = 1;
    /// The tile whose first pixel is (left, top), as far as the picture has it.
    void (*trace_tile)(const ViewJob<Height>& job, std::uint32_t left, std::uint32_t top) = nullptr;
};

/// Whether each of them that is asked for has so many pixels.
[[nodiscard]] bool has_pixels(const HitPicture& picture, std::size_t pixels);

/// Says that rays of a rectangle of pixels have met nothing.
void clear_pixels(const HitPicture& picture, std::uint32_t width, std::uint32_t left, std::uint32_t top, std::uint32_t right,
                  std::uint32_t bottom);

/// One pixel as trace_ray() finds it: for rays that leave a kernel's way.
template <class Height>
void trace_pixel(const ViewJob<Height>& job, std::uint32_t x, std::uint32_t y);

/// Those that this machine can run, the widest first; the last one is scalar and runs everywhere.
template <class Height>
[[nodiscard]] base::Span<const ViewKernel<Height>> view_kernels();

}  // namespace tedavis::raytrace
