#include "host_sim/evaluation/lab_levels.hpp"

#include <new>

#include "render_core/perception/pyramid.hpp"

namespace tedavis::host_sim {
namespace {

perception::LabPlanes planes_at(float* values, int width, int height) {
    const std::size_t size = perception::pixels_of(width, height);
    return {{values, width, height}, {values + size, width, height}, {values + 2 * size, width, height}};
}

void convert_to_lab(const RgbaPicture& picture, const perception::LabPlanes& out) {
    const int width = static_cast<int>(picture.width), height = static_cast<int>(picture.height);
    constexpr std::size_t kAlignment = 64;
    std::vector<std::byte> memory(perception::LabConversion::bytes(width) + kAlignment);
    base::Arena arena(memory.data(), memory.size());
    perception::LabConversion conversion;
    if (!conversion.start(arena, width)) throw std::bad_alloc();
    conversion.convert(perception::packed_picture(picture.pixels.data(), width, height, 4), 0, out);
}

}  // namespace

LabLevels::LabLevels(const RgbaPicture& picture) {
    const auto side = [](std::uint32_t pixels, int level) { return perception::level_side(static_cast<int>(pixels), level); };
    std::size_t total = 0;
    for (int n = 0; n < kLevels; ++n) total += 3 * perception::pixels_of(side(picture.width, n), side(picture.height, n));
    values_.resize(total);
    float* next = values_.data();
    for (int n = 0; n < kLevels; ++n) {
        perception::LabPlanes& level = levels_[static_cast<std::size_t>(n)];
        level = planes_at(next, side(picture.width, n), side(picture.height, n));
        next += 3 * level.lightness.size();
    }
    convert_to_lab(picture, levels_[0]);
    std::vector<float> scratch(perception::reduction_scratch(static_cast<int>(picture.width)));
    for (std::size_t n = 1; n < levels_.size(); ++n) {
        perception::halve(levels_[n - 1].lightness, levels_[n].lightness, {scratch.data(), scratch.size()});
        perception::halve(levels_[n - 1].a, levels_[n].a, {scratch.data(), scratch.size()});
        perception::halve(levels_[n - 1].b, levels_[n].b, {scratch.data(), scratch.size()});
    }
}

}  // namespace tedavis::host_sim
