#include "render_core/raytrace/trace_view.hpp"

#include "render_core/base/check.hpp"

namespace tedavis::raytrace {
namespace {

std::uint32_t beams_over(std::uint32_t pixels, int size) { return (pixels + kBeamSide[size] - 1) / kBeamSide[size]; }

}  // namespace

Ray GridCamera::ray(std::uint32_t x, std::uint32_t y) const {
    const glm::vec3 across = right * (static_cast<float>(x) + 0.5f), along = down * (static_cast<float>(y) + 0.5f);
    Ray ray;
    ray.origin = origin;
    ray.direction = corner + across + along;
    return ray;
}

template <class Height>
std::uint64_t ViewTracer<Height>::bytes_needed(std::uint32_t width, std::uint32_t height) {
    std::uint64_t bytes = 0;
    for (int n = 0; n < kBeamSizes; ++n)
        bytes += std::uint64_t{beams_over(width, n)} * beams_over(height, n) * (sizeof(float) + sizeof(std::int32_t)) + 16;
    return bytes;
}

template <class Height>
bool ViewTracer<Height>::start(std::uint32_t width, std::uint32_t height, base::Arena& arena) {
    if (width == 0 || height == 0 || width > kMostSide || height > kMostSide) return false;
    width_ = width;
    height_ = height;
    for (int n = 0; n < kBeamSizes; ++n) {
        BeamStarts& beams = beams_[n];
        beams.across = beams_over(width, n);
        beams.down = beams_over(height, n);
        beams.t = arena.allocate_array<float>(std::size_t{beams.across} * beams.down);
        beams.level = arena.allocate_array<std::int32_t>(std::size_t{beams.across} * beams.down);
        if (beams.t.empty() || beams.level.empty()) return false;
    }
    return true;
}

template <class Height>
void ViewTracer<Height>::trace(const TracedField<Height>& field, const GridCamera& camera, const ViewKernel<Height>& kernel,
                               base::Workers& workers, const HitPicture& picture) {
    const std::size_t pixels = std::size_t{width_} * height_;
    TEDAVIS_CHECK(picture.t.size() == pixels && picture.cell.size() == pixels && picture.side.size() == pixels);
    struct Work {
        ViewJob<Height> job;
        const ViewKernel<Height>* kernel;
    };
    Work work{{&field, &camera, width_, height_, beams_, picture.t.data(), picture.cell.data(), picture.side.data()}, &kernel};
    if (camera.has_upright_columns()) {
        const auto lanes = static_cast<std::uint32_t>(kernel.lanes);
        workers.parallel_for((width_ + lanes - 1) / lanes,
                             [](void* context, std::uint32_t group) {
                                 const Work& all = *static_cast<const Work*>(context);
                                 all.kernel->trace_columns(all.job, group);
                             },
                             &work);
        return;
    }
    workers.parallel_for((height_ + kBandRows - 1) / kBandRows,
                         [](void* context, std::uint32_t band) {
                             const Work& all = *static_cast<const Work*>(context);
                             all.kernel->trace_band(all.job, band);
                         },
                         &work);
}

template class ViewTracer<std::int16_t>;
template class ViewTracer<float>;

}  // namespace tedavis::raytrace
