#include "render_core/raytrace/view_kernels.hpp"

#include <algorithm>

#include "render_core/raytrace/hit_place.hpp"
#include "render_core/raytrace/kernel/view_kernel_list.hpp"

namespace tedavis::raytrace {
namespace {

#ifdef __x86_64__
constexpr const char* kVector4 = "sse2";
bool has_avx2() { return __builtin_cpu_supports("avx2") != 0; }
bool has_avx512() {
    return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
           __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0;
}
#else
constexpr const char* kVector4 = "neon";
#endif

}  // namespace

Ray GridCamera::ray(std::uint32_t x, std::uint32_t y) const {
    const glm::vec3 across = right * (static_cast<float>(x) + 0.5f), along = down * (static_cast<float>(y) + 0.5f);
    Ray ray;
    ray.origin = origin;
    ray.direction = corner + across + along;
    return ray;
}

template <class Height>
base::Span<const ViewKernel<Height>> view_kernels() {
#ifdef __x86_64__
    static constexpr ViewKernel<Height> kKernels[] = {{"avx512", 32, trace_tile_vector16},
                                                      {"avx2", 8, trace_tile_vector8},
                                                      {kVector4, 4, trace_tile_vector4},
                                                      {"scalar", 1, trace_tile_scalar}};
    const std::size_t first = has_avx512() ? 0 : has_avx2() ? 1 : 2;
#else
    static constexpr ViewKernel<Height> kKernels[] = {{kVector4, 4, trace_tile_vector4}, {"scalar", 1, trace_tile_scalar}};
    const std::size_t first = 0;
#endif
    return base::Span<const ViewKernel<Height>>(kKernels).subspan(first, std::size(kKernels) - first);
}

bool has_pixels(const HitPicture& picture, std::size_t pixels) {
    const auto fits = [pixels](std::size_t size) { return size == 0 || size == pixels; };
    return picture.t.size() == pixels && fits(picture.cell.size()) && fits(picture.side.size()) && fits(picture.u.size()) &&
           picture.u.size() == picture.v.size();
}

void clear_pixels(const HitPicture& picture, std::uint32_t width, std::uint32_t left, std::uint32_t top, std::uint32_t right,
                  std::uint32_t bottom) {
    for (std::uint32_t y = top; y < bottom; ++y) {
        const std::size_t first = std::size_t{y} * width + left, count = right - left;
        std::fill_n(picture.t.data() + first, count, std::numeric_limits<float>::infinity());
        if (!picture.cell.empty()) std::fill_n(picture.cell.data() + first, count, HitPicture::kNoCell);
        if (!picture.side.empty()) std::fill_n(picture.side.data() + first, count, HitSide::none);
    }
}

template <class Height>
void trace_pixel(const ViewJob<Height>& job, std::uint32_t x, std::uint32_t y) {
    const HitPicture& picture = job.picture;
    Ray ray = job.camera->ray(x, y);
    ray.from = job.span.from;
    ray.to = job.span.to;
    ray.gap = job.span.gap;
    const Hit hit = trace_ray(*job.field, ray);
    const std::size_t to = std::size_t{y} * job.width + x;
    picture.t[to] = hit.t;
    const std::uint32_t columns = job.field->grid().columns - 1;
    const auto cell = static_cast<std::int32_t>(hit.row * columns + hit.column);
    if (!picture.side.empty()) picture.side[to] = hit.side;
    if (!picture.cell.empty()) picture.cell[to] = hit.side == HitSide::none ? HitPicture::kNoCell : cell;
    if (picture.u.empty()) return;
    const HitPlace place = hit_place(ray, hit);
    picture.u[to] = place.u;
    picture.v[to] = place.v;
}

template base::Span<const ViewKernel<std::int16_t>> view_kernels();
template base::Span<const ViewKernel<float>> view_kernels();
template void trace_pixel(const ViewJob<std::int16_t>&, std::uint32_t, std::uint32_t);
template void trace_pixel(const ViewJob<float>&, std::uint32_t, std::uint32_t);

}  // namespace tedavis::raytrace
