#include "host_sim/accuracy/knobs/traced_square.hpp"
#include "host_sim/scenario/seeded_random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host_sim/user_error.hpp"
#include "platform/clock/monotonic_clock.hpp"
#include "render_core/base/units.hpp"
#include "render_core/raytrace/surface/surface_bounds.hpp"
#include "render_core/raytrace/surface/surface_height.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kLowest_m = 150, kHighest_m = 900, kMinDown_deg = 0.5, kMaxDown_deg = 8, kMaxAside = 0.4;
constexpr std::size_t kMaxTries = 100;  // for each ray: where there is no ground below the border

raytrace::Ray ray_over(const TracedSquare& square, SeededRandom& numbers) {
    raytrace::Ray ray;
    ray.origin = {0, numbers.between(0, square.grid().rows - 1.0), numbers.between(kLowest_m, kHighest_m)};
    const double down = std::tan(base::radians(numbers.between(kMinDown_deg, kMaxDown_deg))) * square.cell_m();
    ray.direction = glm::vec3(1, numbers.between(-kMaxAside, kMaxAside), -down);
    return ray;
}

}  // namespace

TracedSquare::TracedSquare(const TracedGround& ground)
    : columns_(std::min(ground.columns(), kMaxSide)),
      rows_(std::min(ground.rows(), kMaxSide)),
      scale_{ground.space().column_m(0.5 * ground.rows()), ground.space().row_m(0.5 * ground.rows()), 1} {
    const double step_m = ground.space().step_m();
    ground.is_whole() ? take(ground.grid<std::int16_t>(), step_m) : take(ground.grid<float>(), step_m);
}

template <class Height>
void TracedSquare::take(const raytrace::HeightGrid<Height>& all, double step_m) {
    const std::uint32_t column0 = (all.columns - columns_) / 2, row0 = (all.rows - rows_) / 2;
    posts_.reserve(std::size_t{columns_} * rows_);
    for (std::uint32_t row = 0; row < rows_; ++row)
        for (std::uint32_t column = 0; column < columns_; ++column) {
            const Height height = all.at(column0 + column, row0 + row);
            const bool is_void = height == raytrace::HeightGrid<Height>::kVoid;
            posts_.push_back(is_void ? raytrace::HeightGrid<float>::kVoid
                                     : static_cast<float>(static_cast<double>(height) * step_m));
        }
}

BoundedSurface::BoundedSurface(const TracedSquare& square, const raytrace::SurfaceSettings& surface)
    : settings_(surface), memory_(raytrace::HeightMipmap<float>::bytes_needed(square.grid().columns, square.grid().rows)) {
    base::Arena arena(memory_.data(), memory_.size());
    base::SerialWorkers alone;
    const base::Time begun = platform::monotonic_now();
    if (!maxima_.start(square.grid(), arena, raytrace::surface_bounds<float>(settings_)))
        throw UserError("no memory for the bounds of the terrain; name a smaller database");
    maxima_.build(alone);
    build_ms_ = (platform::monotonic_now() - begun).to_seconds() * 1000;
}

std::vector<raytrace::Ray> rays_over(const TracedSquare& square, std::size_t count, std::uint64_t seed) {
    SeededRandom numbers(seed);
    std::vector<raytrace::Ray> rays;
    for (std::size_t tries = 0; rays.size() < count && tries < count * kMaxTries; ++tries) {
        raytrace::Ray ray = ray_over(square, numbers);
        raytrace::SurfacePoint ground;
        if (!raytrace::find_surface(square.grid(), {}, ray.origin.x, ray.origin.y, ground)) continue;
        ray.origin.z += ground.height;
        rays.push_back(ray);
    }
    if (rays.size() < count) throw UserError("the terrain has no heights along its western side; name another --terrain");
    return rays;
}

double end_over(const TracedSquare& square, const raytrace::Ray& ray) {
    const double along = (square.grid().columns - 1 - ray.origin.x) / ray.direction.x;
    const double aside = double{ray.direction.y};
    if (aside == 0) return along;
    return std::min(along, ((aside > 0 ? square.grid().rows - 1.0 : 0.0) - ray.origin.y) / aside);
}

std::string ray_text(const raytrace::Ray& ray) {
    char text[160];
    std::snprintf(text, sizeof text, "the ray from column %.0f, row %.2f, height %.1f m, along (%.0f, %.3f, %.3f)", ray.origin.x,
                  ray.origin.y, ray.origin.z, double{ray.direction.x}, double{ray.direction.y}, double{ray.direction.z});
    return text;
}

}  // namespace tedavis::host_sim
