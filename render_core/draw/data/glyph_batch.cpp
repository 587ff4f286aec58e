#include "render_core/draw/data/glyph_batch.hpp"

#include <cmath>

namespace tedavis::draw {

GlyphInstance make_glyph(const glm::vec3& place, const glm::vec3& size_m, const glm::dvec3& direction,
                         design::Color color) noexcept {
    GlyphInstance glyph{place, size_m, {}, {color.red, color.green, color.blue, color.alpha}};
    constexpr double kOne = 127;
    for (int axis = 0; axis < 3; ++axis) glyph.direction[axis] = static_cast<std::int8_t>(std::lround(direction[axis] * kOne));
    const bool has_none = glyph.direction[0] == 0 && glyph.direction[1] == 0 && glyph.direction[2] == 0;
    glyph.direction[3] = has_none ? static_cast<std::int8_t>(kOne) : std::int8_t{0};
    return glyph;
}

void GlyphBatch::clear() {
    runs_.clear();
    slot_ = 0;
    use_.in_use = 0;
}

base::Span<GlyphInstance> GlyphBatch::add(GlyphShape shape, GlyphFacing facing, bool is_transparent, std::uint32_t count) {
    if (count == 0) return {};
    const auto first = static_cast<std::uint32_t>(use_.in_use);
    if (count > use_.capacity - use_.in_use || !runs_.try_push_back({shape, facing, is_transparent, slot_, first, count})) {
        use_.refused += count;
        return {};
    }
    use_.take(count);
    return instances_.subspan(first, count);
}

void GlyphBatch::move_to_shown(std::size_t n, const earth::Magnifiers& magnifiers, const glm::dvec3& eye) {
    if (magnifiers.empty()) return;
    for (; n < use_.in_use; ++n) instances_[n].place = glm::vec3(magnifiers.moved(eye + glm::dvec3(instances_[n].place)) - eye);
}

}  // namespace tedavis::draw
