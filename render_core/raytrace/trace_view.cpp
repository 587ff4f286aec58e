#include "render_core/raytrace/trace_view.hpp"

#include "render_core/base/check.hpp"

namespace tedavis::raytrace {
namespace {

template <class Height>
struct ViewWork {
    ViewJob<Height> job;
    const ViewKernel<Height>* kernel;
    ViewTiles tiles;
};

template <class Height>
void trace_tile_of(void* context, std::uint32_t tile) {
    const auto& work = *static_cast<const ViewWork<Height>*>(context);
    work.kernel->trace_tile(work.job, work.tiles.left(tile), work.tiles.top(tile));
}

}  // namespace

Ray GridCamera::ray(std::uint32_t x, std::uint32_t y) const {
    const glm::vec3 across = right * (static_cast<float>(x) + 0.5f), along = down * (static_cast<float>(y) + 0.5f);
    Ray ray;
    ray.origin = origin;
    ray.direction = corner + across + along;
    return ray;
}

template <class Height>
void trace_view(const TracedField<Height>& field, const GridCamera& camera, const ViewKernel<Height>& kernel,
                base::Workers& workers, std::uint32_t width, std::uint32_t height, const HitPicture& picture) {
    const std::size_t pixels = std::size_t{width} * height;
    TEDAVIS_CHECK(has_pixels(picture, pixels));
    ViewWork<Height> work{{&field, &camera, width, height, picture, {}, false}, &kernel, {width, height}};
    if (!is_in_reach(camera.origin))
        clear_pixels(picture, width, 0, 0, width, height);
    else
        workers.parallel_for(work.tiles.count(), trace_tile_of<Height>, &work);
}

template void trace_view(const TracedField<std::int16_t>&, const GridCamera&, const ViewKernel<std::int16_t>&, base::Workers&,
                         std::uint32_t, std::uint32_t, const HitPicture&);
template void trace_view(const TracedField<float>&, const GridCamera&, const ViewKernel<float>&, base::Workers&, std::uint32_t,
                         std::uint32_t, const HitPicture&);

}  // namespace tedavis::raytrace
