#include "render_core/draw/data/label_room.hpp"

#include <algorithm>

namespace tedavis::draw {

LabelRoom::Parts LabelRoom::parts_of(const Rect& box) const {
    const auto part = [](float at, float size) {
        return static_cast<std::size_t>(std::clamp(float{kParts} * at / std::max(size, 1.0f), 0.0f, float{kParts} - 1));
    };
    return {part(box.x - screen_.x, screen_.width), part(box.y - screen_.y, screen_.height),
            part(box.right() - screen_.x, screen_.width), part(box.bottom() - screen_.y, screen_.height)};
}

void LabelRoom::take(const Rect& box) {
    if (count_ == kMax) return;
    const Parts parts = parts_of(box);
    for (std::size_t y = parts.top; y <= parts.bottom; ++y)
        for (std::size_t x = parts.left; x <= parts.right; ++x)
            sets_[y * kParts + x][count_ / 64] |= std::uint64_t{1} << count_ % 64;
    boxes_[count_++] = box;
}

bool LabelRoom::is_beside(std::size_t n, std::size_t other) const {
    return other < count_ && (n == other || boxes_[n].overlaps(boxes_[other]));
}

bool LabelRoom::is_free(const Rect& box, std::size_t except) const {
    Set near{};
    const Parts parts = parts_of(box);
    for (std::size_t y = parts.top; y <= parts.bottom; ++y)
        for (std::size_t x = parts.left; x <= parts.right; ++x)
            for (std::size_t n = 0; n < near.size(); ++n) near[n] |= sets_[y * kParts + x][n];
    for (std::size_t n = 0; n < count_; ++n)
        if ((near[n / 64] >> n % 64 & 1u) != 0 && boxes_[n].overlaps(box) && !is_beside(n, except)) return false;
    return true;
}

}  // namespace tedavis::draw
