#include "render_core/draw/traced_view.hpp"

#include <limits>

#include "render_core/base/check.hpp"

namespace tedavis::draw {
namespace {

constexpr std::uint64_t kPictureArrays = 5, kPictureAlignment = 64;

}  // namespace

std::uint64_t TracedView::bytes_needed(std::uint32_t width, std::uint32_t height) {
    const std::uint64_t pixels = std::uint64_t{width} * height;
    return pixels * (3 * sizeof(float) + sizeof(std::int32_t) + sizeof(raytrace::HitSide)) + kPictureArrays * kPictureAlignment;
}

bool TracedView::start(std::uint32_t width, std::uint32_t height, base::Arena& arena) {
    width_ = width;
    height_ = height;
    const std::size_t pixels = std::size_t{width} * height;
    hits_.t = arena.allocate_array<float>(pixels);
    hits_.cell = arena.allocate_array<std::int32_t>(pixels);
    hits_.side = arena.allocate_array<raytrace::HitSide>(pixels);
    hits_.u = arena.allocate_array<float>(pixels);
    hits_.v = arena.allocate_array<float>(pixels);
    return !hits_.t.empty() && !hits_.cell.empty() && !hits_.side.empty() && !hits_.u.empty() && !hits_.v.empty();
}

void TracedView::clear() {
    for (float& t : hits_.t) t = std::numeric_limits<float>::infinity();
    for (std::int32_t& cell : hits_.cell) cell = raytrace::HitPicture::kNoCell;
    for (raytrace::HitSide& side : hits_.side) side = raytrace::HitSide::none;
}

void TracedView::trace(const TracedGround& ground, const raytrace::GroundSpace& space, const terrain::View& view,
                       base::Workers& workers) {
    TEDAVIS_CHECK(view.width == width_ && view.height == height_);
    raytrace::trace_ground(ground.field(), space, view, raytrace::view_kernels<float>()[0], workers, hits_);
}

}  // namespace tedavis::draw
